"""Runs every test suite, whatever the others do, and adds up their results.

The suites: C++ (GoogleTest), the Python module, inside the program Blender, inside the Blender
module `bpy`. Each leaves a JUnit file in build/test-results. The last line is the total.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "build" / "test-results"
TIMEOUT_S = 3600


@dataclass(frozen=True)
class Suite:
    """A test program and the JUnit file that it was told to write."""

    name: str
    command: list[str]
    junit: Path


def suites(blender: str, bpy_python: str) -> list[Suite]:
    """The four suites; `blender` is a program, `bpy_python` an interpreter that has `bpy`."""

    def junit(name: str) -> Path:
        return RESULTS / f"{name}.xml"

    in_blender = str(ROOT / "blender_tests" / "run.py")
    wheel = [bpy_python, in_blender]
    start = [blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", in_blender]
    pytest = [sys.executable, "-m", "pytest", "-q", str(ROOT / "native" / "tests" / "python")]
    cpp = [str(ROOT / "build" / "native" / "illustrate_tests"), "--gtest_brief=1"]
    return [
        Suite("cpp", [*cpp, f"--gtest_output=xml:{junit('cpp')}"], junit("cpp")),
        Suite("python", [*pytest, f"--junitxml={junit('python')}"], junit("python")),
        Suite("blender", [*start, "--", "-q", f"--junitxml={junit('blender')}"], junit("blender")),
        Suite("bpy", [*wheel, "--", "-q", f"--junitxml={junit('bpy')}"], junit("bpy")),
    ]


def environment() -> dict[str, str]:
    """The environment of the tests: the user's Blender settings and add-ons are out of reach."""
    folders = {
        f"BLENDER_USER_{name}": str(RESULTS / "blender" / name.lower())
        for name in ("RESOURCES", "CONFIG", "SCRIPTS")
    }
    for folder in folders.values():
        Path(folder).mkdir(parents=True, exist_ok=True)
    return os.environ | folders


def outcome(case: ElementTree.Element) -> str:
    """'passed', 'failed' or 'skipped' for one JUnit test case, of pytest or of GoogleTest."""
    children = {child.tag for child in case}
    if children & {"failure", "error"}:
        return "failed"
    if "skipped" in children or case.get("result") in ("skipped", "suppressed"):
        return "skipped"
    return "passed"


def run(suite: Suite) -> Counter[str]:
    """Runs one suite; one that leaves no result or fails without saying where is a failure."""
    print(f"== {suite.name}", flush=True)
    suite.junit.unlink(missing_ok=True)
    try:
        code = subprocess.run(
            suite.command, cwd=ROOT, env=environment(), timeout=TIMEOUT_S, check=False
        ).returncode
    except (OSError, subprocess.TimeoutExpired) as error:
        print(f"{suite.name}: {error}")
        code = 1
    counts: Counter[str] = Counter()
    try:
        counts.update(outcome(case) for case in ElementTree.parse(suite.junit).iter("testcase"))
    except (OSError, ElementTree.ParseError) as error:
        print(f"{suite.name}: no result ({error})")
    if not counts or (code != 0 and not counts["failed"]):
        print(f"{suite.name}: ended with exit code {code} and {sum(counts.values())} results")
        counts["failed"] += 1
    return counts


def closing_line(counts: Counter[str]) -> str:
    """Such as '12 passed, 0 failed, 1 skipped'."""
    return ", ".join(f"{counts[name]} {name}" for name in ("passed", "failed", "skipped"))


def main() -> int:
    """Runs all suites; the exit code is 0 when nothing failed."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--blender", required=True, help="the program Blender")
    parser.add_argument("--bpy-python", required=True, help="a Python interpreter that has bpy")
    arguments = parser.parse_args()
    RESULTS.mkdir(parents=True, exist_ok=True)
    results = {suite.name: run(suite) for suite in suites(arguments.blender, arguments.bpy_python)}
    for name, counts in results.items():
        print(f"{name}: {closing_line(counts)}")
    total = sum(results.values(), Counter[str]())
    print(closing_line(total), flush=True)
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
