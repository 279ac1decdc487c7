"""Illustrates frames of a scene without a window and writes the drawings to files.

    blender -b FILE.blend --python-exit-code 3 --python headless.py -- --out DIR [options]
    blender -b FILE.blend --command illustrate --out DIR [options]       (the extension, 4.2 on)
    python headless.py FILE.blend --out DIR [options]          (a Python that has the module bpy)

A file is called as the .blend and its frame, such as scene_0001.svg; it appears whole or not at
all. Nothing outside DIR is written. The exit code is 0 when every file was written. `merge OUT
--into FILE.blend` in place of the options makes keyframes of JSON files. This file finds the add-on
and leaves Blender; what is done is in the folder farm (docs/farm.md).
"""

import atexit
import importlib
import os
import pathlib
import sys
import traceback
from types import ModuleType
from typing import Any

# Of the library that numpy multiplies matrices with, which bpy loads: its threads wait for more by
# spinning, on the cores that the next frame is drawn on.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import bpy

PACKAGE = "illustrate"


def main(arguments: list[str], summaries: list[str] | None = None) -> int:
    """Does what the command line asks for; the exit code. `summaries` gets a line per frame.

    Raises SystemExit for a wrong command line.
    """
    code: int = _part(find_package(), "farm.main").main(arguments, summaries)
    return code


def find_package() -> ModuleType:
    """The add-on, registered: that of this Blender, else the one this file is in or was built from.

    In a module what was registered here is taken back when Python ends. Raises ModuleNotFoundError
    when there is none.
    """
    registered = _registered()
    if registered is not None:
        return importlib.import_module(registered.__module__.removesuffix(".running.operators"))
    here = pathlib.Path(__file__).resolve().parent
    folder = here.parent if here.name == PACKAGE else here.parent / "build" / "addons"
    if (folder / PACKAGE).is_dir():
        sys.path.insert(0, str(folder))
    package = importlib.import_module(PACKAGE)
    package.register()
    if is_module():
        atexit.register(_unregister, package)
    return package


def _registered() -> Any:
    """The operator of the add-on that is registered, or None."""
    return getattr(bpy.types, "ILLUSTRATE_OT_illustrate", None)


def _unregister(package: ModuleType) -> None:
    if _registered() is not None:
        package.unregister()


def _part(package: ModuleType, name: str) -> Any:
    """A module of the add-on, under whatever name it is installed."""
    return importlib.import_module(f"{package.__name__}.{name}")


def own_arguments() -> list[str]:
    """What stands after -- on the command line of Blender, or after the name of a Python script."""
    if "--" in sys.argv:
        return sys.argv[sys.argv.index("--") + 1 :]
    return sys.argv[1:] if is_module() else []


def is_module() -> bool:
    """True in a Python that has Blender as a module, not in the program."""
    return not bpy.app.binary_path


def leave(code: int) -> None:
    """Ends the process when there is something to say, or when Blender is a module.

    A script in a module calls it last: up to 4.5 the module hangs or crashes at its own end while a
    class is registered, whoever's it is, and 4.2 also after one that was (docs/addon.md).
    """
    sys.stdout.flush()
    sys.stderr.flush()
    if is_module():
        os._exit(code)
    if code:
        sys.exit(code)


def run() -> int:
    """`main` with the command line; in a module, the exit code of an exception that it let pass."""
    try:
        return main(own_arguments())
    except SystemExit as left:  # from the parser of the arguments, which has said why
        return left.code if isinstance(left.code, int) else 2
    except Exception:
        if not is_module():
            raise
        traceback.print_exc()
        return 3


if __name__ == "__main__":
    leave(run())
