"""Runs the scenarios in a real window, and ends Blender with their results.

    blender --factory-startup --enable-event-simulate --python blender_tests/window/drive.py -- OUT
        [SCENARIO or MODULE...]

A scenario is a generator: it yields seconds to wait, or a condition to wait for, and Blender works
meanwhile. Pictures and a JUnit file go to the folder OUT. The exit code is 0 when none failed.
"""

import os
import pathlib
import sys
import time
import traceback
import unittest
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Generator
from typing import Any

import bpy

HERE = pathlib.Path(__file__).resolve().parent
PATIENCE_S = 60.0
INTERVAL_S = 0.01

Scenario = Callable[[pathlib.Path], Generator[Any, None, None]]


class Driver:
    """Goes through the scenarios, one step at each call of Blender's timer."""

    def __init__(self, scenarios: list[Scenario], out: pathlib.Path) -> None:
        self.waiting, self.out = list(scenarios), out
        self.results: dict[str, str] = {}  # name: what went wrong, empty where nothing did
        self.skipped: dict[str, str] = {}  # name: why
        self._name, self._run = "", iter(())
        self._wanted: Any = None
        self._since = time.monotonic()

    def tick(self) -> float:
        """Blender's timer."""
        if not self._is_due():
            return INTERVAL_S
        try:
            self._wanted, self._since = next(self._run), time.monotonic()
        except StopIteration:
            self._finish("")
        except unittest.SkipTest as reason:
            self.skipped[self._name] = str(reason)
            self._finish("")
        except Exception:
            self._finish(traceback.format_exc())
        return INTERVAL_S

    def _is_due(self) -> bool:
        waited = time.monotonic() - self._since
        if not callable(self._wanted):
            return waited >= (self._wanted or 0)
        if waited > PATIENCE_S:
            self._run = iter(())
            self._finish(f"waited {PATIENCE_S} s in vain for {self._wanted}")
            return False
        return bool(self._wanted())

    def _finish(self, error: str) -> None:
        if self._name:
            self.results[self._name] = error
            skipped = self.skipped.get(self._name)
            print(f"{self._name}: {error or skipped or 'passed'}", flush=True)
        self._wanted, self._since = None, time.monotonic()
        if not self.waiting:
            self._leave()
        scenario = self.waiting.pop(0)
        self._name, self._run = scenario.__name__, scenario(self.out)

    def _leave(self) -> None:
        suite = ElementTree.Element("testsuite", name="window", tests=str(len(self.results)))
        for name, error in self.results.items():
            case = ElementTree.SubElement(suite, "testcase", classname="window", name=name)
            if error:
                ElementTree.SubElement(case, "failure").text = error
            elif name in self.skipped:
                ElementTree.SubElement(case, "skipped", message=self.skipped[name])
        ElementTree.ElementTree(suite).write(self.out / "window.xml")
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(1 if any(self.results.values()) else 0)


def provide() -> None:
    """Registers the add-on."""
    sys.path[:0] = [str(HERE), str(HERE.parent)]
    import installed

    installed.provide()
    import illustrate

    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.system.viewport_aa = "OFF"  # there is no graphics card
    if not installed.is_enabled(illustrate):
        illustrate.register()


def run(scenarios: list[Scenario]) -> None:
    """Starts the driver with those that are named after the folder, or all of them.

    The name of a module stands for all scenarios in it.
    """
    out = pathlib.Path(sys.argv[sys.argv.index("--") + 1]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    names = set(sys.argv[sys.argv.index("--") + 2 :])
    wanted = [each for each in scenarios if not names or names & {each.__name__, each.__module__}]
    driver = Driver(wanted, out)
    bpy.app.timers.register(driver.tick, first_interval=1.0, persistent=True)


def main() -> None:
    """All scenarios."""
    provide()
    import export_scenarios
    import hands_scenarios
    import job_scenarios
    import live_scenarios
    import live_times
    import newcomer_scenarios
    import paper_scenarios
    import render_scenarios
    import scenarios

    drawn = (
        newcomer_scenarios,
        scenarios,
        job_scenarios,
        export_scenarios,
        live_scenarios,
        paper_scenarios,
    )
    parts = (*drawn, hands_scenarios, live_times, render_scenarios)
    run([each for part in parts for each in part.ALL])


if __name__ == "__main__":
    main()
