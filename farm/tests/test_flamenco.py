"""The job type of Flamenco, compiled by Node in place of the Manager (manager.js)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from manager import JOB_TYPE, NODE, compile_job, tasks_of

SETTINGS = {
    "frames": "1-10, 20",
    "chunk_size": 4,
    "output": "/frames",
    "expose_as": 1,
    "blendfile": "/shots/shot.flamenco.blend",
}

pytestmark = pytest.mark.skipif(NODE is None, reason="there is no node: make farm installs it")


def arguments_of(task: dict[str, Any]) -> list[str]:
    [command] = task["commands"]
    assert command["name"] == "blender-render"
    assert command["parameters"]["exe"] == "{blender}"
    assert command["parameters"]["blendfile"] == SETTINGS["blendfile"]
    return list(command["parameters"]["args"])


def test_a_task_for_each_chunk(tmp_path: Path) -> None:
    tasks = tasks_of(tmp_path, SETTINGS)
    assert [task["name"] for task in tasks] == ["draw-1-4", "draw-5-8", "draw-9,10,20"]
    assert not any(task["dependencies"] for task in tasks)
    assert arguments_of(tasks[2]) == [
        "--command", "illustrate", "--out=/frames", "--name=shot_####", "--frames=9,10,20",
        "--format=svg,json", "--expose-as=1", "--warm-up=2", "--skip-existing", "--progress=none",
    ]  # fmt: skip


def test_a_merge_after_all_of_them(tmp_path: Path) -> None:
    *drawn, merge = tasks_of(
        tmp_path, {**SETTINGS, "merged": "/shots/drawn.blend", "script": "/headless.py"}
    )
    assert merge["dependencies"] == [task["name"] for task in drawn]
    assert arguments_of(merge) == [
        "--python-exit-code", "3", "--python", "/headless.py", "--", "merge", "/frames",
        "--into=/shots/drawn.blend", "--from=/shots/shot.flamenco.blend", "--frames=1-10,20",
    ]  # fmt: skip


def test_merging_needs_json(tmp_path: Path) -> None:
    ran = compile_job(tmp_path, {**SETTINGS, "merged": "/m.blend", "formats": "svg,png"})
    assert ran.returncode == 1 and "needs json" in ran.stderr


@pytest.mark.parametrize(
    ("changed", "to", "words"),
    [
        ("author.Task(", "author.Work(", "author has no Work"),
        ("path.stem(", "path.trunk(", "path has no trunk"),
        ("task.addCommand(", "task.addStep(", "a task has no addStep"),
        ("settings.output", "settings.out", "settings has no out"),
        ("frameChunker(", "chunked(", "chunked is not defined"),
        ("return task;", "console.log(task); return task;", "console is not defined"),
        ('"blender-render"', '"blender"', "no command blender"),
        ("argsBefore:", "argsFirst:", "takes no argsFirst"),
        ('type: "int32"', 'type: "int"', "is of type int"),
    ],
)
def test_the_stand_in_knows_what_the_manager_has_not(
    tmp_path: Path, changed: str, to: str, words: str
) -> None:
    text = JOB_TYPE.read_text()
    assert changed in text
    script = tmp_path / "other.js"
    script.write_text(text.replace(changed, to))
    ran = compile_job(tmp_path, SETTINGS, script)
    assert ran.returncode == 1 and words in ran.stderr
