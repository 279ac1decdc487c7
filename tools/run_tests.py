"""Runs every test suite, whatever the others do, and adds up their results.

The suites: C++ (GoogleTest), the Python module, and the built packages in some of the Blenders of
the matrix: the oldest, one with Grease Pencil 2 and extensions, the newest. The last line is the
total.
"""

from __future__ import annotations

import sys

import blenders
import run_matrix
import suites
from suites import ROOT, Outcome, Suite

VERSIONS = ("3.4.1", "4.2.23", "5.2.3")


def native_suites() -> list[Suite]:
    """The tests that need no Blender."""
    cpp, python = suites.junit_file("cpp"), suites.junit_file("python")
    pytest = [sys.executable, "-m", "pytest", "-q", str(ROOT / "native" / "tests" / "python")]
    executable = [str(ROOT / "build" / "native" / "illustrate_tests"), "--gtest_brief=1"]
    return [
        Suite("cpp", [*executable, f"--gtest_output=xml:{cpp}"], cpp),
        Suite("python", [*pytest, f"--junitxml={python}"], python),
    ]


def main() -> int:
    """Runs all suites; the exit code is 0 when nothing failed."""
    results: dict[str, Outcome] = {suite.name: suites.run(suite) for suite in native_suites()}
    left_out = [b.version for b in blenders.table() if b.version not in VERSIONS]
    for blender in run_matrix.chosen(list(VERSIONS)):
        try:
            blenders.set_up(blender)
        except blenders.SetUpError as error:
            print(error, flush=True)
            left_out.append(blender.version)
            continue
        results[f"Blender {blender.version}"] = run_matrix.test(blender, window=False, options=[])
    print(f"left out, make matrix runs them: Blender {', '.join(left_out)}; tests in a window")
    return suites.report(results)


if __name__ == "__main__":
    sys.exit(main())
