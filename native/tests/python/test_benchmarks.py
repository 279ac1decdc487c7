"""The exact work that the benchmarks count is the work that was written down."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


def load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, BENCHMARKS / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("level", [2, 3])
def test_silhouettes_take_the_work_written_down(level: int) -> None:
    benchmark = load("bench_silhouettes")
    counts = benchmark.counts_of(benchmark.prepared_blob(level))
    written = json.loads((BENCHMARKS / "counts.json").read_text())[f"blob_4 level {level}"]
    assert counts == written, "if this is meant: bench_silhouettes.py --levels 2 3 --write-counts"
    assert counts["triangles_visited"] <= 2.5 * counts["silhouette_triangles"]
