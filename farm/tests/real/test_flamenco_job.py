"""The commands of a job of Flamenco, run as its Worker runs them."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

from manager import tasks_of
from shots import BLENDER, SCRIPT, Shot, contents, run

VARIABLES = {"{blender}": BLENDER, "{blenderArgs}": "-b -y"}  # as the Manager sets them up


def words_of(task: dict[str, Any]) -> list[str]:
    """The command line of a task, put together as in the Worker's command_blender.go."""
    [command] = task["commands"]
    parameters = command["parameters"]
    before = shlex.split(VARIABLES[parameters["exeArgs"]]) + parameters["argsBefore"]
    return [VARIABLES[parameters["exe"]], *before, parameters["blendfile"], *parameters["args"]]


def test_a_job_draws_what_one_command_draws(
    shot: Callable[[str], Shot], whole: Callable[[str], dict[str, bytes]], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    settings = {
        "frames": "1-12", "chunk_size": 5, "output": str(out), "merged": str(tmp_path / "m.blend"),
        "expose_as": 1, "warm_up": 12, "script": str(SCRIPT),
        "blendfile": str(shot("following").blend),
    }  # fmt: skip
    *drawn, merge = tasks_of(tmp_path, settings)
    for task, frames in zip(drawn, (5, 5, 2), strict=True):
        said = run(words_of(task))
        assert len(re.findall(r"^Time: ([0-9:.]+)", said, re.M)) == frames
        assert len(re.findall(r"^Saved: '(.*)'", said, re.M)) == 2 * frames
    assert contents(out) == whole("following")
    assert len(re.findall(r"^skipping existing frame", run(words_of(drawn[0])), re.M)) == 5
    assert "merged 12 frames" in run(words_of(merge))
