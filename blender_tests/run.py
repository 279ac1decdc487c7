"""Runs the tests of the add-on inside Blender.

    blender -b --factory-startup --python-exit-code 1 --python blender_tests/run.py -- [ARGUMENTS]
    python blender_tests/run.py [ARGUMENTS]        (a Python that has the module bpy)

ARGUMENTS are pytest's.

pytest comes from this Python, else from $ILLUSTRATE_TEST_SITE, or .venv where that is not set.
The add-on is that of build/addons; $ILLUSTRATE_ADDONS names another folder of add-ons, and
$ILLUSTRATE_ZIP a package to install and to test. $ILLUSTRATE_COVERAGE: see measured.py.
"""

import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent


def set_paths() -> None:
    """Packages for the tests come last, so that they replace none of Blender's own."""
    sys.path[:0] = [str(HERE), str(ROOT / "examples")]
    site = os.environ.get("ILLUSTRATE_TEST_SITE")
    version = "python{}.{}".format(*sys.version_info[:2])
    sys.path.append(site or str(ROOT / ".venv" / "lib" / version / "site-packages"))


def own_arguments() -> list[str]:
    """What stands after --, or after the name of the script."""
    return sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]


if __name__ == "__main__":
    set_paths()
    import installed
    import measured
    import pytest

    installed.provide()
    options = ["-c", os.devnull, "--rootdir", str(HERE), "-p", "no:cacheprovider"]
    arguments = [*options, str(HERE), *own_arguments()]
    sys.exit(int(pytest.main(arguments, plugins=measured.plugins())))
