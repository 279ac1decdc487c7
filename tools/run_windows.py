"""Runs, under wine, the tests of the module and of the add-on from the packages for Windows.

The module's tests run in the Python of each Blender, the add-on's background suite in each Blender;
then both systems draw the demo's scenes in the same Blender, which must come out the same.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import zipfile
from dataclasses import dataclass
from pathlib import Path

import blenders
import suites
from suites import ROOT, Outcome, Suite

WINE = str(ROOT / "tools" / "run_in_wine.sh")
PYTHONS = {"4.5.15": "3.11", "5.2.3": "3.13"}
DEFAULT = ("4.5.15",)  # Debian 12's wine lacks functions that numpy for Python 3.13 calls
COMPARED = "4.5.15"
SCENES = ("suzanne", "torus_sphere", "drape", "goblet", "cube")
"""Not klein: the matrix of its camera, which Blender computes, differs by a bit."""


@dataclass(frozen=True)
class Windows:
    """The Python of an official module bpy for Windows. program: python.exe in the cache."""

    version: str
    python: str
    program: Path

    def command(self, *words: str | Path) -> list[str]:
        """A command that runs this Python with these words; paths are called as they are there."""
        named = [on_drive(word) if isinstance(word, Path) else word for word in words]
        return [WINE, str(self.program), *named]


def on_drive(path: Path) -> str:
    """What Windows calls a file of this machine."""
    return f"Z:{path.as_posix()}"


def set_up(version: str, python: str) -> Windows:
    """Fetches it. Raises SetUpError."""
    script = str(ROOT / "tools" / "setup_windows_blender.sh")
    ran = subprocess.run([script, version, python], stdout=subprocess.PIPE, text=True, check=False)
    if ran.returncode:
        raise blenders.SetUpError(f"Blender {version} for Windows could not be set up")
    return Windows(version, python, Path(ran.stdout.splitlines()[-1]))


def unpacked_wheel(windows: Windows) -> Path:
    """A folder with the module alone, from the wheel for this Python."""
    folder = ROOT / "build" / "windows-tests" / windows.python
    shutil.rmtree(folder, ignore_errors=True)
    number = windows.python.replace(".", "")
    (wheel,) = (ROOT / "dist" / "wheels").glob(f"*-cp{number}-win_amd64.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


def module_suite(windows: Windows, options: list[str]) -> Suite:
    """The tests of the Python module, on what the wheel holds."""
    junit = suites.junit_file(f"windows-{windows.python}")
    tests = ROOT / "native" / "tests" / "python"
    words = windows.command("-m", "pytest", "-q", "-p", "no:cacheprovider", tests)
    words += [f"--junitxml={on_drive(junit)}", *options]
    variables = {"PYTHONPATH": on_drive(unpacked_wheel(windows))}
    return Suite(f"Python {windows.python} for Windows", _with(variables, words), junit)


def blender_suite(windows: Windows, options: list[str]) -> Suite:
    """The add-on's tests, on the package, installed as a user would."""
    junit = suites.junit_file(f"windows-bpy-{windows.version}")
    (package,) = (ROOT / "dist").glob("illustrate-*-windows-x64.zip")
    words = windows.command(ROOT / "blender_tests" / "run.py", "--", "-q")
    words += [f"--junitxml={on_drive(junit)}", *options]
    variables = _user(windows) | {
        "ILLUSTRATE_ZIP": on_drive(package),
        "ILLUSTRATE_TEST_SITE": on_drive(windows.program.parent / "Lib" / "site-packages"),
    }
    return Suite(f"Blender {windows.version} for Windows", _with(variables, words), junit)


def _user(windows: Windows) -> dict[str, str]:
    """Folders of a user who has this Blender and nothing else."""
    folder = ROOT / "build" / "windows-tests" / f"user-{windows.version}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return {"BLENDER_USER_RESOURCES": on_drive(folder)}


def _with(variables: dict[str, str], words: list[str]) -> list[str]:
    return ["env", *(f"{name}={value}" for name, value in variables.items()), *words]


def staged_checkout(windows: Windows) -> Path:
    """A checkout whose built add-on is that for Windows; its folder."""
    folder = ROOT / "build" / "windows-tests" / "checkout"
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("addon", "examples"):
        shutil.copytree(ROOT / name, folder / name)
    addon = folder / "build" / "addons" / "illustrate"
    shutil.copytree(ROOT / "addon", addon)
    module = "illustrate_native"
    shutil.copytree(unpacked_wheel(windows) / module, addon / module)
    return folder


def compare(windows: Windows) -> Outcome:
    """The demo's scenes as both systems draw them; a test for each scene."""
    here, there = (ROOT / "out" / name for name in ("linux-x64", "windows-x64"))
    demo, form = Path("examples", "demo.py"), ["--", "--format", "svg", "--out"]
    (blender,) = (each for each in blenders.table() if each.version == windows.version)
    linux = [blenders.set_up(blender).program, str(ROOT / demo), *form, str(here), *SCENES]
    subprocess.run(linux, cwd=ROOT, check=True)
    checkout = staged_checkout(windows)
    subprocess.run(windows.command(checkout / demo, *form, there, *SCENES), cwd=ROOT, check=True)
    return same_bytes(here, there)


def same_bytes(here: Path, there: Path) -> Outcome:
    """A test for each scene: whether two folders have the same drawing."""
    found = Outcome()
    for scene in SCENES:
        first, second = (folder / f"{scene}.svg" for folder in (here, there))
        is_same = first.read_bytes() == second.read_bytes()
        print(f"{scene}: {'the same bytes' if is_same else f'{first} and {second} differ'}")
        found.counts["passed" if is_same else "failed"] += 1
    return found


def main() -> int:
    """The exit code is 0 when nothing failed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("versions", nargs="*", default=[], help=f"of {', '.join(PYTHONS)}")
    parser.add_argument("-k", help="only the tests that match, as pytest's -k")
    arguments = parser.parse_args()
    options = [] if arguments.k is None else ["-k", arguments.k]
    results: dict[str, Outcome] = {}
    for version in arguments.versions or DEFAULT:
        windows = set_up(version, PYTHONS[version])
        for suite in (module_suite(windows, options), blender_suite(windows, options)):
            results[suite.name] = suites.run(suite)
        if version == COMPARED and not options:
            results["drawings of both systems"] = compare(windows)
    left_out = set(PYTHONS) - set(arguments.versions or DEFAULT)
    print("left out:", *(f"Blender {version} for Windows" for version in sorted(left_out)))
    return suites.report(results)


if __name__ == "__main__":
    sys.exit(main())
