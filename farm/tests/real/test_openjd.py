"""The template of Open Job Description, checked and run by openjd-cli."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from shots import BLENDER, SCRIPT, Shot, contents, run

OPENJD = str(Path(sys.executable).with_name("openjd"))
TEMPLATE = str(Path(__file__).parents[2] / "openjd" / "illustrate.yaml")

Shots = Callable[[str], Shot]
Whole = Callable[[str], dict[str, bytes]]


def job(shot: Shot, out: Path, **parameters: object) -> list[str]:
    """The words that run all of a job: twelve frames in chunks of five, then the merge."""
    chosen = {"File": shot.blend, "Out": out, "Into": out.parent / "into.blend", "Frames": "1-12",
              "ChunkSize": 5, "WarmUp": 12, "Blender": BLENDER, "Script": SCRIPT,
              **parameters}  # fmt: skip
    words = [OPENJD, "run", TEMPLATE, "--step", "Merge", "--run-dependencies"]
    return [*words, *(word for name in chosen for word in ("-p", f"{name}={chosen[name]}"))]


def test_the_template_is_valid() -> None:
    assert "passes validation checks" in run([OPENJD, "check", TEMPLATE])


def test_a_job_draws_what_one_command_draws(shot: Shots, whole: Whole, tmp_path: Path) -> None:
    out = tmp_path / "out"
    said = run(job(shot("following"), out))
    assert contents(out) == whole("following")
    assert "openjd_progress: 100.0" in said and "merged 12 frames" in said
    assert sorted(path.name for path in tmp_path.iterdir()) == ["into.blend", "out"]


def test_a_job_that_fails_is_resumed(shot: Shots, whole: Whole, tmp_path: Path) -> None:
    out = tmp_path / "out"
    stone = out / "apart_0007.json"
    stone.mkdir(parents=True)
    said = run(job(shot("apart"), out), 1)
    assert "openjd_fail: failed frames: 7 (1 of 4 frames)" in said
    assert not (tmp_path / "into.blend").exists()
    first = contents(out)
    assert "apart_0007.json" not in first and first.items() <= whole("apart").items()
    stone.rmdir()
    said = run(job(shot("apart"), out))
    assert contents(out) == whole("apart") and "merged 12 frames" in said
    assert [f"skipping existing frame {frame}" in said for frame in (1, 6, 7, 8)] == [
        True,
        True,
        False,
        True,
    ]


def test_a_worker_has_resources_of_its_own(shot: Shots, tmp_path: Path) -> None:
    user = tmp_path / "user"
    (user / "config").mkdir(parents=True)
    tell = tmp_path / "tell.sh"
    tell.write_text('#!/bin/sh\necho "resources: $BLENDER_USER_RESOURCES"\n')
    tell.chmod(0o755)
    words = job(shot("apart"), tmp_path / "out", Resources=user, Blender=tell, Frames="1-2")
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    [told] = {
        line.split("resources: ")[1] for line in ran.stdout.splitlines() if "resources: /" in line
    }
    assert told.endswith("/resources") and not Path(told).exists()
