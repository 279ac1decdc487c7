"""The native module: the one that came with the add-on, else the one installed for this Python."""

import importlib
import importlib.util
import pathlib
import sys
from types import ModuleType

from .messages import IllustrateError

NAME = "illustrate_native"


def load() -> ModuleType:
    """The module `illustrate_native`. Raises IllustrateError when there is none for this Python."""
    if NAME in sys.modules:
        return sys.modules[NAME]
    try:
        return _load_bundled() or importlib.import_module(NAME)
    except ImportError as error:
        version = ".".join(map(str, sys.version_info[:2]))
        raise IllustrateError(
            f"The native module of Illustrate cannot be loaded for Python {version} ({error}): "
            "install the add-on again from a package made for this Blender"
        ) from error


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
