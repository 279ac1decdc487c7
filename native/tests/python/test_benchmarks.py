"""The exact work that the benchmarks count is the work that was written down."""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[3]
BENCHMARKS = ROOT / "native" / "benchmarks"


def load(name: str, folder: Path = BENCHMARKS) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, folder / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("level", [2, 3])
def test_silhouettes_take_the_work_written_down(level: int) -> None:
    benchmark = load("bench_silhouettes")
    counts = benchmark.counts_of(benchmark.prepared_blob(level))
    written = json.loads((BENCHMARKS / "counts.json").read_text())[f"blob_4 level {level}"]
    assert counts == written, "if this is meant: bench_silhouettes.py --levels 2 3 --write-counts"
    assert counts["triangles_visited"] <= 2.5 * counts["silhouette_triangles"]


def test_the_page_of_sensitivity_has_every_constant_as_it_is() -> None:
    page = (ROOT / "docs" / "sensitivity.md").read_text(encoding="utf-8")
    for table in load("sensitivity", ROOT / "tools").TABLES:
        constants = list(table.constants())
        assert len(constants) > 5, f"{table.header} is not read"
        missing = [f"{n} = {v}" for n, v, _ in constants if f"| `{n}` = {v} |" not in page]
        assert not missing, "make docs/sensitivity.md anew: tools/sensitivity.py"


def test_sensitivity_reads_each_constant_from_the_environment() -> None:
    sensitivity = load("sensitivity", ROOT / "tools")
    for table in sensitivity.TABLES:
        text = sensitivity.tuned(table)
        for name, value, (half, double) in table.constants():
            assert f'{name} = tuned("{table.name()}.{name}", {value})' in text
            assert half < sensitivity.number(value) < double
