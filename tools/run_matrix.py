"""Runs the tests of the add-on, from the built packages, in the Blenders of blenders.txt.

A line for each version, its skipped tests with their reasons, then the total.
"""

from __future__ import annotations

import argparse
import shutil
import sys

import blenders
import suites
from blenders import Blender, Place
from suites import ROOT, Outcome


def test(blender: Blender, window: bool, options: list[str]) -> Outcome:
    """All tests in one Blender, and those in a window if asked for; what cannot run has failed."""
    found = Outcome()
    try:
        place = blenders.set_up(blender)
        found.add(suites.run(blenders.background_suite(blender, place, options)))
        if window and blender.is_program:
            found.add(_in_window(blender, place, []))
    except blenders.SetUpError as error:
        print(f"Blender {blender.version}: {error}", file=sys.stderr)
        found.counts["failed"] += 1
    return found


def test_window(blender: Blender, scenarios: list[str]) -> Outcome:
    """These scenarios in a window alone, all when none is named; what cannot run has failed."""
    found = Outcome()
    try:
        found.add(_in_window(blender, blenders.set_up(blender), scenarios))
    except blenders.SetUpError as error:
        print(f"Blender {blender.version}: {error}", file=sys.stderr)
        found.counts["failed"] += 1
    return found


def _in_window(blender: Blender, place: Place, scenarios: list[str]) -> Outcome:
    """The pictures of the screen go to out/window/VERSION."""
    suite = blenders.window_suite(blender, place, scenarios)
    found = suites.run(suite)
    pictures = ROOT / "out" / "window" / blender.version
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    for picture in suite.junit.parent.glob("*.png"):
        shutil.copy(picture, pictures)
    return found


def chosen(versions: list[str]) -> list[Blender]:
    """The Blenders of these versions, all when none is named. Raises ValueError."""
    known = {blender.version: blender for blender in blenders.table()}
    for version in versions:
        if version not in known:
            raise ValueError(f"no Blender {version} in blenders.txt, which has {', '.join(known)}")
    return [blender for version, blender in known.items() if version in versions or not versions]


def main() -> int:
    """The exit code is 0 when nothing failed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("versions", nargs="*", help="such as 4.2.23; all when left out")
    parser.add_argument("--no-window", action="store_true", help="leave the window suite out")
    parser.add_argument(
        "--window",
        nargs="*",
        metavar="SCENARIO",
        help="these scenarios in a window alone, all when none is named",
    )
    parser.add_argument("-k", help="only the tests that match, as pytest's -k; no window")
    arguments = parser.parse_args()
    try:
        wanted = chosen(arguments.versions)
    except ValueError as error:
        parser.error(str(error))
    if arguments.window is not None:
        return suites.report(
            {
                f"Blender {blender.version} in a window": test_window(blender, arguments.window)
                for blender in wanted
                if blender.is_program
            }
        )
    window = not arguments.no_window and arguments.k is None
    options = [] if arguments.k is None else ["-k", arguments.k]
    return suites.report(
        {f"Blender {blender.version}": test(blender, window, options) for blender in wanted}
    )


if __name__ == "__main__":
    sys.exit(main())
