"""The native module: the one that came with the add-on, else the one installed for this Python.

An extension brings it as a wheel, which Blender installs; older Blenders get it inside the add-on.
"""

import importlib
import importlib.util
import pathlib
import re
import sys
from types import ModuleType

import bpy

from .messages import IllustrateError

NAME = "illustrate_native"


def load() -> ModuleType:
    """The module `illustrate_native`. Raises IllustrateError when there is none for this Python."""
    if NAME in sys.modules:
        return sys.modules[NAME]
    try:
        return _load_bundled() or importlib.import_module(NAME)
    except ImportError as error:
        raise IllustrateError(_missing(error)) from error


def _missing(error: ImportError) -> str:
    """Why the module cannot be loaded, and the way out."""
    needed, inside = "{}.{}".format(*sys.version_info[:2]), pythons_inside()
    blender = f"Blender {bpy.app.version_string} runs Python {needed}"
    if needed in inside:
        return (
            f"The native module of Illustrate for Python {needed} is there and cannot be loaded "
            f"({error}): install Illustrate again from the package for this system"
        )
    has = f"has it for Python {', '.join(inside)}" if inside else "has it for no Python"
    return (
        f"The native module of Illustrate is missing: {blender}, and this package {has}. "
        "Install the package of Illustrate that is made for this Blender"
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
    load()
    return importlib.import_module(f"{NAME}.{name}")


def can_seed() -> bool:
    """True where `draw` takes the drawing that its strokes are to start from."""
    return "previous" in (load().draw.__doc__ or "")


def _load_bundled() -> ModuleType | None:
    """Loads the package beside this file under its own name, so that it is in memory only once."""
    folder = pathlib.Path(__file__).parent / NAME
    start = folder / "__init__.py"
    if not start.is_file():
        return None
    spec = importlib.util.spec_from_file_location(
        NAME, start, submodule_search_locations=[str(folder)]
    )
    if spec is None or spec.loader is None:
        return None
    module = importlib.util.module_from_spec(spec)
    sys.modules[NAME] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[NAME]
        raise
    return module
