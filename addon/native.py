"""The native module: the one that came with the add-on, else the one installed for this Python.

An extension brings it as a wheel, which Blender installs; older Blenders get it inside the add-on.
"""

import functools
import importlib
import pathlib
import re
import sys
from types import ModuleType

import bpy

from .messages import IllustrateError, said

NAME = "illustrate_native"


@functools.cache
def load() -> ModuleType:
    """The module `illustrate_native`. Raises IllustrateError when there is none for this Python.

    The one inside the add-on is a package of it and has a name of its own: Python may know another
    of the short name.
    """
    try:
        if (pathlib.Path(__file__).parent / NAME / "__init__.py").is_file():
            return importlib.import_module(f".{NAME}", __package__)
        return importlib.import_module(NAME)
    except ImportError as error:
        raise IllustrateError(_missing(error)) from error


def is_loaded() -> bool:
    """True when something has needed the module."""
    return load.cache_info().currsize > 0


def _missing(error: ImportError) -> str:
    """Why the module cannot be loaded, and the way out."""
    needed, inside = "{}.{}".format(*sys.version_info[:2]), pythons_inside()
    if needed in inside:
        return said(
            "The native module of Illustrate for Python {needed} is there and cannot be loaded "
            "({error}): install Illustrate again from the package for this system",
            needed=needed,
            error=error,
        )
    has = said("no Python")
    if inside:
        has = said("Python {versions}", versions=", ".join(inside))
    return said(
        "The native module of Illustrate is missing: Blender {blender} runs Python {needed}, and "
        "this package has it for {has}. Install the package of Illustrate that is made for this "
        "Blender",
        blender=bpy.app.version_string,
        needed=needed,
        has=has,
    )


def pythons_inside() -> list[str]:
    """The Pythons that this package has the module for, such as '3.11', by its files."""
    folder = pathlib.Path(__file__).parent
    names = [path.name for path in (*folder.glob("wheels/*.whl"), *folder.glob(f"{NAME}/_core.*"))]
    found = [re.search(r"-cp3(\d+)-|[.]cp(?:ython-)?3(\d+)-", name) for name in names]
    minors = {int(match[1] or match[2]) for match in found if match}
    return [f"3.{minor}" for minor in sorted(minors)]


def load_part(name: str) -> ModuleType:
    """A Python module of the native package, such as 'svg'."""
    return importlib.import_module(f"{load().__name__}.{name}")


def can_seed() -> bool:
    """True where `draw` takes the drawing that its strokes are to start from."""
    return "previous" in (load().draw.__doc__ or "")
