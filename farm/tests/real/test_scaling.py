"""What a second worker is good for: the walking robot on one and on two nodes of one core each.

ILLUSTRATE_SCALING_FRAMES: how many frames, such as 120; without it nothing is measured here, as it
takes minutes of a machine that does nothing else.
"""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest
from cluster import NODES, Cluster
from shots import ROOT, contents, make_shot

FRAMES = int(os.environ.get("ILLUSTRATE_SCALING_FRAMES", "0"))
SHARED = Path(os.environ.get("ILLUSTRATE_SHARED", ROOT.parent / "shared"))
CHUNKS = 2
HOUR_S = 3600

pytestmark = [
    pytest.mark.skipif(not FRAMES, reason="ILLUSTRATE_SCALING_FRAMES says how many frames"),
    pytest.mark.skipif(
        not (SHARED / "scenes" / "RobotExpressive.blend").is_file(),
        reason="the robot is in the shared folder",
    ),
]


def drawn_in(cluster: Cluster, blend: Path, out: Path, workers: int) -> tuple[float, float]:
    """Seconds from submitting to the array's end, and from there to the end of the merge."""
    arguments = (blend, out, out.parent / f"{out.name}.blend", 1, FRAMES, FRAMES // CHUNKS)
    start = time.monotonic()
    drawn, finished = cluster.submit(*arguments, MOST=str(workers))
    assert cluster.wait(drawn, HOUR_S) == ["COMPLETED"] * CHUNKS
    middle = time.monotonic()
    assert len(cluster.nodes_of(drawn)) <= workers <= len(NODES)
    assert cluster.wait(finished, HOUR_S) == ["COMPLETED"]
    return middle - start, time.monotonic() - middle


def test_two_workers_draw_the_same_in_less_time(cluster: Cluster, tmp_path: Path) -> None:
    """Times are printed, not judged: they are the machine's."""
    blend = make_shot(tmp_path, "robot", FRAMES).blend
    one, two = (drawn_in(cluster, blend, tmp_path / f"by{n}", n) for n in (1, 2))
    print(f"\n{FRAMES} frames in {CHUNKS} chunks, drawing and merging:")
    print(f"one worker {one[0]:.0f} s and {one[1]:.0f} s, two {two[0]:.0f} s and {two[1]:.0f} s")
    print(f"drawing takes {2 * two[0] / one[0]:.3f} of half")
    assert contents(tmp_path / "by1") == contents(tmp_path / "by2")
