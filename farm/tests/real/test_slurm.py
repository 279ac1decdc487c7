"""Two nodes of a real Slurm: frames as one machine draws them, and what is said of bad ones."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from cluster import Cluster
from shots import Shot, contents

Shots = Callable[[str], Shot]
Whole = Callable[[str], dict[str, bytes]]


def log(out: Path, job: str) -> str:
    """What the job that follows an array said."""
    return (out / "logs" / f"{job}.log").read_text()


@pytest.mark.parametrize(("kind", "warm_up"), [("apart", "0"), ("following", "12")])
def test_two_nodes_draw_what_one_machine_draws(
    cluster: Cluster, shot: Shots, whole: Whole, tmp_path: Path, kind: str, warm_up: str
) -> None:
    out, into = tmp_path / "out", tmp_path / "into.blend"
    drawn, finished = cluster.submit(shot(kind).blend, out, into, 1, 12, 3, WARM_UP=warm_up)
    assert cluster.wait(finished) == ["COMPLETED"], log(out, finished)
    assert cluster.states(drawn) == ["COMPLETED"] * 4
    assert cluster.nodes_of(drawn) == {"w1", "w2"}
    assert contents(out) == whole(kind)
    assert log(out, finished).startswith(f"no errors in the logs of job {drawn}\n")
    assert "merged 12 frames" in log(out, finished) and into.exists()


def test_a_frame_that_cannot_be_drawn(cluster: Cluster, shot: Shots, tmp_path: Path) -> None:
    out, into = tmp_path / "out", tmp_path / "into.blend"
    drawn, finished = cluster.submit(shot("cut").blend, out, into, 1, 12, 4)
    assert cluster.wait(finished) == ["FAILED"]
    assert sorted(cluster.states(drawn)) == ["COMPLETED", "FAILED", "FAILED"]
    assert sorted(contents(out)) == Shot(shot("cut").blend, 6).names("svg", "json")
    told = re.findall(r"^illustrate: error: frame (\d+): .*panoramic", log(out, finished), re.M)
    assert told == [str(frame) for frame in range(7, 13)]
    assert "Missing frames: 7, 8, 9, 10, 11, 12" in log(out, finished)
    assert not into.exists()


def test_no_camera(cluster: Cluster, shot: Shots, tmp_path: Path) -> None:
    out = tmp_path / "out"
    drawn, finished = cluster.submit(shot("blind").blend, out, tmp_path / "into.blend", 1, 12, 6)
    assert cluster.wait(finished) == ["FAILED"]
    assert cluster.states(drawn) == ["FAILED"] * 2
    assert contents(out) == {} and log(out, finished).count("no camera") == 12


def test_the_same_array_twice(cluster: Cluster, shot: Shots, whole: Whole, tmp_path: Path) -> None:
    out, into = tmp_path / "out", tmp_path / "into.blend"
    jobs = [cluster.submit(shot("apart").blend, out, into, 1, 12, 6) for _ in range(2)]
    assert [cluster.wait(finished) for _, finished in jobs] == [["COMPLETED"]] * 2
    assert contents(out) == whole("apart")
    logs = [path.read_text() for path in (out / "logs").glob("*_*.log")]
    saved = [name for text in logs for name in re.findall(r"^Saved: .*/(.*\.svg)'", text, re.M)]
    assert set(saved) == set(shot("apart").names("svg"))
    assert len(saved) + sum(text.count("skipping existing frame") for text in logs) == 24
