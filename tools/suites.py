"""Test suites: programs that leave a JUnit file. Runs them and counts."""

from __future__ import annotations

import os
import subprocess
import time
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TIMEOUT_S = 3600


@dataclass(frozen=True)
class Suite:
    """A test program and the JUnit file that it was told to write."""

    name: str
    command: list[str]
    junit: Path


@dataclass
class Outcome:
    """How often tests passed, failed and were skipped; the skipped ones with their reasons."""

    counts: Counter[str] = field(default_factory=Counter)
    skipped: list[str] = field(default_factory=list)
    seconds: float = 0

    def add(self, other: Outcome) -> None:
        """Counts in what another suite left."""
        self.counts += other.counts
        self.skipped += other.skipped
        self.seconds += other.seconds

    def __str__(self) -> str:
        """Such as '12 passed, 0 failed, 1 skipped'."""
        return ", ".join(f"{self.counts[name]} {name}" for name in ("passed", "failed", "skipped"))


def outcome_of(case: ElementTree.Element) -> str:
    """'passed', 'failed' or 'skipped' for one JUnit test case, of pytest or of GoogleTest."""
    children = {child.tag for child in case}
    if children & {"failure", "error"}:
        return "failed"
    if "skipped" in children or case.get("result") in ("skipped", "suppressed"):
        return "skipped"
    return "passed"


def _read(junit: Path) -> Outcome:
    found = Outcome()
    for case in ElementTree.parse(junit).iter("testcase"):
        kind = outcome_of(case)
        found.counts[kind] += 1
        if kind == "skipped":
            element = case.find("skipped")
            reason = "" if element is None else element.get("message", "")
            found.skipped.append(f"{case.get('name')}: {reason}")
    return found


def _output(suite: Suite) -> tuple[int, str]:
    """The exit code and all that it printed, at once: suites may run side by side."""
    try:
        ran = subprocess.run(
            suite.command,
            cwd=ROOT,
            timeout=TIMEOUT_S,
            check=False,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return 1, str(error)
    return ran.returncode, ran.stdout.decode(errors="replace")


def run(suite: Suite) -> Outcome:
    """Runs one suite; one that leaves no result or fails without saying where is a failure."""
    suite.junit.unlink(missing_ok=True)
    start = time.monotonic()
    code, text = _output(suite)
    print(f"== {suite.name}\n{text}", flush=True)
    seconds = time.monotonic() - start
    found = Outcome()
    try:
        found = _read(suite.junit)
    except (OSError, ElementTree.ParseError) as error:
        print(f"{suite.name}: no result ({error})")
    if not found.counts or (code != 0 and not found.counts["failed"]):
        print(f"{suite.name}: ended with exit code {code} and {found.counts.total()} results")
        found.counts["failed"] += 1
    found.seconds = seconds
    return found


def report(results: dict[str, Outcome]) -> int:
    """Prints a line for each name, its skipped tests, and the total; the exit code."""
    total = Outcome()
    for name, found in results.items():
        print(f"{name}: {found}, in {found.seconds:.0f} s")
        for skipped in found.skipped:
            print(f"    skipped {skipped}")
        total.add(found)
    print(total, flush=True)
    return 1 if total.counts["failed"] else 0


def junit_file(name: str) -> Path:
    """Where the suite of that name leaves its results."""
    folder = Path(os.environ.get("ILLUSTRATE_RESULTS", ROOT / "build" / "test-results"))
    folder.mkdir(parents=True, exist_ok=True)
    return folder / f"{name}.xml"
