"""Nodes and workers that die, and a disk that is full: every frame is there in the end, whole."""

from __future__ import annotations

import os
import random
import re
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from cluster import NODES, Cluster, until
from shots import Shot, contents

Shots = Callable[[str], Shot]
Whole = Callable[[str], dict[str, bytes]]

NODE_KILLS = int(os.environ.get("ILLUSTRATE_NODE_KILLS", "3"))


def submit(cluster: Cluster, shot: Shot, out: Path, **variables: str) -> tuple[str, str]:
    """Twelve frames in four chunks, each frame apart from the others."""
    into = out.parent / "into.blend"
    return cluster.submit(shot.blend, out, into, 1, 12, 3, WARM_UP="0", **variables)


def said(out: Path, job: str) -> str:
    """What the tasks of an array, or a job, have said up to now."""
    logs = sorted((out / "logs").glob(f"{job}*.log"))
    return "\n".join(path.read_text() for path in logs)


def mended(cluster: Cluster, finished: str) -> list[str]:
    """The state of the job at the end; meanwhile what was lost begins again."""

    def ended() -> bool:
        cluster.requeue_at_once()
        return cluster.has_ended(finished)

    until(ended, 300)
    return cluster.states(finished)


def test_a_worker_killed_within_a_frame(
    cluster: Cluster, shot: Shots, whole: Whole, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    drawn, finished = submit(cluster, shot("apart"), out)
    until(lambda: "Saved: " in said(out, f"{drawn}_"), 60)
    until(lambda: bool(cluster.processes("w1", "blender")), 60)
    os.kill(cluster.processes("w1", "blender")[0], signal.SIGKILL)
    assert mended(cluster, finished) == ["FAILED"]
    assert sorted(cluster.states(drawn)) == ["COMPLETED"] * 3 + ["FAILED"]
    missing = set(whole("apart")) - set(contents(out))
    frames = sorted({int(name[-9:-4].strip("_.")) for name in missing if name.endswith(".json")})
    assert 1 <= len(frames) <= 3
    assert f"Missing frames: {', '.join(map(str, frames))}" in said(out, finished)
    _, finished = submit(cluster, shot("apart"), out)
    assert cluster.wait(finished) == ["COMPLETED"]
    assert visible(out) == whole("apart")


def visible(out: Path) -> dict[str, bytes]:
    """The files that anything reads: what a killed worker had begun has a name with a dot."""
    return {name: data for name, data in contents(out).items() if not name.startswith(".")}


@pytest.mark.parametrize("turn", range(NODE_KILLS))
def test_a_node_killed_at_a_random_moment(
    cluster: Cluster, shot: Shots, whole: Whole, tmp_path: Path, turn: int
) -> None:
    chance = random.Random(turn)
    out = tmp_path / "out"
    drawn, finished = submit(cluster, shot("apart"), out)
    until(lambda: len(cluster.nodes_of(drawn) & set(NODES)) == 2, 60)
    time.sleep(chance.uniform(0.0, 6.0))
    cluster.kill_node(chance.choice(NODES))
    assert mended(cluster, finished) == ["COMPLETED"], said(out, finished)
    assert cluster.states(drawn) == ["COMPLETED"] * 4
    assert visible(out) == whole("apart")
    assert "merged 12 frames" in said(out, finished)


def test_a_node_that_slurm_lost_draws_on(
    cluster: Cluster, shot: Shots, whole: Whole, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    drawn, finished = submit(cluster, shot("apart"), out)
    until(lambda: bool(cluster.processes("w1", "blender")), 60)
    cluster.kill_daemon("w1")
    assert mended(cluster, finished) == ["COMPLETED"], said(out, finished)
    assert cluster.states(drawn) == ["COMPLETED"] * 4
    assert contents(out) == whole("apart")


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A folder on a disk that holds some of the frames, not all."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", str(disk)]
    subprocess.run(mount, check=True)
    try:
        yield disk
    finally:
        subprocess.run(["umount", "--lazy", str(disk)], check=True)


def test_a_full_disk(
    cluster: Cluster, shot: Shots, whole: Whole, small_disk: Path, tmp_path: Path
) -> None:
    out, logs = small_disk / "out", str(tmp_path / "logs")
    _, finished = submit(cluster, shot("apart"), out, LOGS=logs)
    assert cluster.wait(finished) == ["FAILED"]
    left = contents(out)
    assert 0 < len(left) < len(whole("apart"))
    assert left.items() <= whole("apart").items()  # each whole, nothing begun
    told = (tmp_path / "logs" / f"{finished}.log").read_text()
    failed = set(re.findall(r"^illustrate: error: frame (\d+): .*No space left", told, re.M))
    assert failed and failed >= {
        str(frame) for frame in range(1, 13) if f"apart_{frame:04}.json" not in left
    }
    subprocess.run(["mount", "-o", "remount,size=100m", str(small_disk)], check=True)
    _, finished = submit(cluster, shot("apart"), out, LOGS=logs)
    assert cluster.wait(finished) == ["COMPLETED"]
    assert contents(out) == whole("apart")
