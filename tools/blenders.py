"""The Blenders of blenders.txt: how each is set up, and how the tests are run in it."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from suites import ROOT, Suite

SHARED = Path(os.environ.get("ILLUSTRATE_SHARED", ROOT.parent / "shared"))
MADE = ("build", "out")  # folders of the checkout that the tests do not read
CHECKOUT_IN_ROOT = "srv/illustrate/main"
SCREEN = ["xvfb-run", "--auto-servernum", "--server-args", "-screen 0 1280x800x24 +extension GLX"]
PASSED_ON = ("ILLUSTRATE_REPEATS", "ILLUSTRATE_MEASURE")  # to the scenarios in a window
PATH_IN_ROOT = "PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin"


class SetUpError(Exception):
    """A Blender or its package cannot be had here; the message says why."""


@dataclass(frozen=True)
class Blender:
    """A row of the table. source: 'system', 'wheel', or the Debian whose root folder it is in."""

    version: str
    source: str
    python: str

    @property
    def is_program(self) -> bool:
        """It has windows and a command line; the module bpy has not."""
        return self.source != "wheel"

    @property
    def takes_extensions(self) -> bool:
        """From 4.2 on."""
        return tuple(map(int, self.version.split(".")[:2])) >= (4, 2)


@dataclass(frozen=True)
class Place:
    """Where a Blender is. root: the folder that is / for it."""

    program: str
    root: Path

    @property
    def checkout(self) -> Path:
        """The folder that the tests run from, seen from outside."""
        return ROOT if self.root == Path("/") else self.root / CHECKOUT_IN_ROOT

    def inside(self, path: Path) -> str:
        """A path below the root, as it is called in there."""
        return "/" + path.relative_to(self.root).as_posix()

    def command(self, words: list[str], variables: dict[str, str]) -> list[str]:
        """A command of this machine that runs `words` in there, with environment variables."""
        own = [f"{name}={value}" for name, value in variables.items()]
        if self.root == Path("/"):
            return ["env", *own, *words]
        enter = [str(ROOT / "tools" / "enter_root.sh"), str(self.root)]
        return [*enter, "/usr/bin/env", "-i", PATH_IN_ROOT, "LANG=C.UTF-8", *own, *words]


def table() -> list[Blender]:
    """All Blenders that are tested, oldest first."""
    lines = (ROOT / "tools" / "blenders.txt").read_text(encoding="utf-8").splitlines()
    return [Blender(*line.split()) for line in lines if line and not line.startswith("#")]


def set_up(blender: Blender) -> Place:
    """Makes it ready. Raises SetUpError."""
    script = str(ROOT / "tools" / "setup_blender.sh")
    ran = subprocess.run(
        [script, blender.source, blender.version, blender.python],
        stdout=subprocess.PIPE,
        text=True,
        check=False,
    )
    if ran.returncode:
        raise SetUpError(f"Blender {blender.version} could not be set up")
    found = ran.stdout.splitlines()[-1]
    if not Path(found).is_dir():
        return Place(found, Path("/"))
    program = "/usr/bin/blender" if blender.is_program else "/opt/bpy/bin/python"
    place = Place(program, Path(found))
    _stage(place.checkout)
    return place


def _stage(checkout: Path) -> None:
    """Copies the checkout but what is made in it into a root folder, which has no mounts."""
    shutil.rmtree(checkout, ignore_errors=True)
    for path in ROOT.iterdir():
        if path.is_dir() and path.name not in MADE and not path.name.startswith("."):
            shutil.copytree(path, checkout / path.name)
    if SHARED.is_dir():
        meshes = checkout.parent / "shared" / "meshes"
        shutil.copytree(SHARED / "meshes", meshes, dirs_exist_ok=True)


def package(blender: Blender) -> str:
    """The name of the zip in dist that a user of this Blender installs. Raises SetUpError."""
    found = [
        path.name
        for path in (ROOT / "dist").glob("illustrate-*-linux-x64.zip")
        if blender.takes_extensions != ("-legacy-" in path.name)
    ]
    if not found:
        raise SetUpError(f"no package for Blender {blender.version} in dist: run make extension")
    return found[0]


def background_suite(blender: Blender, place: Place, options: list[str]) -> Suite:
    """All tests, without a window; options: further ones of pytest."""
    results = _fresh(place, blender, "background")
    script = place.inside(place.checkout / "blender_tests" / "run.py")
    start = [place.program, script]
    if blender.is_program:
        start = [place.program, "-b", "--factory-startup", "--python-exit-code", "1"]
        start += ["--python", script]
    junit = results / "tests.xml"
    words = [*start, "--", "-q", f"--junitxml={place.inside(junit)}", *options]
    command = place.command(words, _variables(blender, place, results))
    return Suite(f"Blender {blender.version}", command, junit)


def window_suite(blender: Blender, place: Place, scenarios: list[str]) -> Suite:
    """What artists do in a window: these scenarios, all when none is named."""
    results = _fresh(place, blender, "window")
    script = place.inside(place.checkout / "blender_tests" / "window" / "drive.py")
    start = [*SCREEN, place.program, "--factory-startup", "--enable-event-simulate"]
    words = [*start, "--python", script, "--", place.inside(results), *scenarios]
    passed_on = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
    variables = _variables(blender, place, results) | passed_on | {"LIBGL_ALWAYS_SOFTWARE": "1"}
    command = place.command(words, variables)
    return Suite(f"Blender {blender.version} in a window", command, results / "window.xml")


def _fresh(place: Place, blender: Blender, name: str) -> Path:
    """An empty folder for results and for the settings of a user."""
    folder = place.checkout / "build" / "test-results" / blender.version / name
    shutil.rmtree(folder, ignore_errors=True)
    for user in ("home", "resources", "config", "scripts"):
        (folder / user).mkdir(parents=True)
    return folder


def _variables(blender: Blender, place: Place, results: Path) -> dict[str, str]:
    """A user who has this Blender and nothing else, and the package to test."""
    folders = {
        "HOME": "home",
        "BLENDER_USER_RESOURCES": "resources",
        "BLENDER_USER_CONFIG": "config",
        "BLENDER_USER_SCRIPTS": "scripts",
    }
    variables = {name: place.inside(results / folder) for name, folder in folders.items()}
    variables["ILLUSTRATE_ZIP"] = place.inside(place.checkout / "dist" / package(blender))
    if blender.source != "system":  # pytest is there already; .venv would hide a missing module
        variables["ILLUSTRATE_TEST_SITE"] = place.inside(results)
    return variables
