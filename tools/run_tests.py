"""Runs every test suite, whatever the others do, and adds up their results.

The suites: C++ (GoogleTest), the Python module, the job templates for farms, and the built packages
in the oldest and the newest Blender of the matrix: one with Grease Pencil 2, one with extensions
and Grease Pencil 3. The last line is the total.
"""

from __future__ import annotations

import sys
import time
from concurrent.futures import ThreadPoolExecutor

import blenders
import run_matrix
import suites
from suites import ROOT, Suite

VERSIONS = ("3.4.1", "5.2.3")
SIDE_BY_SIDE = 3  # most of a suite keeps one core busy; one more than there are, to the end


def native_suites() -> list[Suite]:
    """The tests that need no Blender."""
    cpp, python, farm = (suites.junit_file(name) for name in ("cpp", "python", "farm"))
    pytest = [sys.executable, "-m", "pytest", "-q"]
    native, templates = str(ROOT / "native" / "tests" / "python"), str(ROOT / "farm" / "tests")
    no_cluster = f"--ignore={ROOT / 'farm' / 'tests' / 'real'}"  # make farm sets it up
    executable = [str(ROOT / "build" / "native" / "illustrate_tests"), "--gtest_brief=1"]
    return [
        Suite("cpp", [*executable, f"--gtest_output=xml:{cpp}"], cpp),
        Suite("python", [*pytest, native, f"--junitxml={python}"], python),
        Suite("farm", [*pytest, templates, no_cluster, f"--junitxml={farm}"], farm),
    ]


def main() -> int:
    """Runs all suites, two at a time; the exit code is 0 when nothing failed."""
    start = time.monotonic()
    left_out = [b.version for b in blenders.table() if b.version not in VERSIONS]
    with ThreadPoolExecutor(SIDE_BY_SIDE) as pool:
        running = {suite.name: pool.submit(suites.run, suite) for suite in native_suites()}
        for blender in run_matrix.chosen(list(VERSIONS)):
            try:
                blenders.set_up(blender)
            except blenders.SetUpError as error:
                print(error, flush=True)
                left_out.append(blender.version)
                continue
            running[f"Blender {blender.version}"] = pool.submit(
                run_matrix.test, blender, window=False, options=[]
            )
        results = {name: future.result() for name, future in running.items()}
    print(f"left out, make matrix runs them: Blender {', '.join(left_out)}; tests in a window")
    print(f"the tests took {time.monotonic() - start:.0f} s, {SIDE_BY_SIDE} suites side by side")
    return suites.report(results)


if __name__ == "__main__":
    sys.exit(main())
