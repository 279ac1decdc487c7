"""Runs the tests of the add-on inside Blender, on build/addons/illustrate.

    blender -b --factory-startup --python-exit-code 1 --python blender_tests/run.py -- [ARGUMENTS]
    python blender_tests/run.py [ARGUMENTS]        (a Python that has the module bpy)

ARGUMENTS are pytest's.

pytest comes from this Python, from $ILLUSTRATE_TEST_SITE or from .venv, whichever has it first.
$ILLUSTRATE_ADDONS names another folder of add-ons to test.
"""

import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent


def set_paths() -> None:
    """The add-on first; packages for the tests last, so that they replace none of Blender's own."""
    addons = os.environ.get("ILLUSTRATE_ADDONS", str(ROOT / "build" / "addons"))
    sys.path[:0] = [addons, str(HERE), str(ROOT / "examples")]
    site = os.environ.get("ILLUSTRATE_TEST_SITE")
    version = "python{}.{}".format(*sys.version_info[:2])
    sys.path.extend([site] if site else [])
    sys.path.append(str(ROOT / ".venv" / "lib" / version / "site-packages"))


def own_arguments() -> list[str]:
    """What stands after --, or after the name of the script."""
    return sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]


if __name__ == "__main__":
    set_paths()
    import pytest

    options = ["-c", os.devnull, "--rootdir", str(HERE), "-p", "no:cacheprovider"]
    sys.exit(int(pytest.main([*options, str(HERE), *own_arguments()])))
