"""The cluster, the shots, and what one machine draws of them, for the tests in real."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "real"))

from cluster import NODES, Cluster
from shots import SCRIPT, Shot, draw, make_shot

FRAMES = 12


@pytest.fixture(scope="session")
def _cluster() -> Iterator[Cluster]:
    cluster = Cluster(Path("/run/illustrate-slurm"))  # pytest's own folders are closed to munge
    cluster.variables["SCRIPT"] = str(SCRIPT)
    try:
        cluster.start()
        yield cluster
    finally:
        cluster.stop()


@pytest.fixture
def cluster(_cluster: Cluster, request: pytest.FixtureRequest) -> Iterator[Cluster]:
    """Slurm with two nodes that are up; what its daemons said is printed where a test fails."""
    for node in NODES:
        _cluster.mend_node(node)
    failed = request.session.testsfailed
    yield _cluster
    if request.session.testsfailed > failed:
        print(_cluster.logs())
    _cluster.clear()


@pytest.fixture(scope="session")
def shot(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Shot]:
    """A shot of each kind of make_shot.py, made once."""
    made: dict[str, Shot] = {}

    def get(kind: str) -> Shot:
        if kind not in made:
            made[kind] = make_shot(tmp_path_factory.mktemp(kind), kind, FRAMES)
        return made[kind]

    return get


@pytest.fixture(scope="session")
def whole(
    shot: Callable[[str], Shot], tmp_path_factory: pytest.TempPathFactory
) -> Callable[[str], dict[str, bytes]]:
    """What one command on one machine draws of a shot, once: SVG and JSON by name."""
    drawn: dict[str, dict[str, bytes]] = {}

    def get(kind: str) -> dict[str, bytes]:
        if kind not in drawn:
            out = tmp_path_factory.mktemp(f"{kind}-whole")
            drawn[kind] = draw(shot(kind), out, "--format", "svg,json")
            shutil.rmtree(out)
        return drawn[kind]

    return get
