"""The Slurm script, with stubs of sbatch and Blender that say how they were called."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / "slurm" / "illustrate.sh"
STUB = """#!/bin/sh
printf "%s\\n" "$*" >>"$LOG"
echo "resources $BLENDER_USER_RESOURCES: $(ls "$BLENDER_USER_RESOURCES" 2>/dev/null)" >>"$LOG.own"
echo "41;cluster"
exit "${STATUS:-0}"
"""

Run = Callable[..., tuple[subprocess.CompletedProcess[str], list[str]]]


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """Runs the script; how it ended, and the calls of the stubs."""
    for name in ("sbatch", "blender"):
        (tmp_path / name).write_text(STUB)
        (tmp_path / name).chmod(0o755)

    def call(
        *arguments: object, **variables: str
    ) -> tuple[subprocess.CompletedProcess[str], list[str]]:
        log = tmp_path / "log"
        log.write_text("")
        stubs = {
            "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}",
            "BLENDER": "blender",
            "LOG": str(log),
            "TMPDIR": str(tmp_path),
        }
        ran = subprocess.run(
            ["bash", str(SCRIPT), *map(str, arguments)],
            env={**os.environ, **stubs, **variables},
            capture_output=True,
            text=True,
            check=False,
        )
        return ran, log.read_text().splitlines()

    return call


def test_an_array_of_chunks_and_what_follows_it(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran, (drawn, finished) = run("my shot.blend", out, "into.blend", 1001, 1010, 4, MOST="2")
    assert ran.stdout == "draw 41\nfinish 41\n"
    assert "--array=0-2%2 " in drawn and f"--output={out}/logs/%A_%a.log " in drawn
    assert "--requeue" in drawn and "--requeue" in finished
    assert drawn.endswith(f"illustrate.sh draw my shot.blend {out} 1001 1010 4")
    assert "--dependency=afterany:41 " in finished
    assert finished.endswith(
        f"illustrate.sh finish my shot.blend {out} into.blend 1001 1010 {out}/logs 41"
    )
    assert (out / "logs").is_dir()


@pytest.mark.parametrize(("last", "array"), [(4, "0-0"), (5, "0-1"), (8, "0-1"), (9, "0-2")])
def test_as_many_tasks_as_chunks(run: Run, tmp_path: Path, last: int, array: str) -> None:
    _, (drawn, _) = run("s.blend", tmp_path / "out", "into.blend", 1, last, 4)
    assert f"--array={array} " in drawn


@pytest.mark.parametrize(("task", "chunk"), [("0", "1001-1004"), ("2", "1009-1010")])
def test_a_chunk(run: Run, task: str, chunk: str) -> None:
    arguments = ("draw", "s.blend", "out", 1001, 1010, 4)
    _, [called] = run(*arguments, SLURM_ARRAY_TASK_ID=task, WARM_UP="3")
    assert called == (
        f"-b s.blend --command illustrate --out=out --frames={chunk} --format=svg,json "
        "--warm-up=3 --expose-as=1001 --skip-existing --progress none"
    )


def test_what_failed_is_said_before_the_merge(run: Run, tmp_path: Path) -> None:
    logs = {"41_0.log": "frame 10: full", "41_1.log": "frame 9: full", "4_0.log": "frame 1: old"}
    for name, error in logs.items():
        (tmp_path / name).write_text(f"Time: 00:01.00\nillustrate: error: {error}\nend\n")
    arguments = ("finish", "s.blend", "out", "into.blend", 1, 10, tmp_path)
    ran, [called] = run(*arguments, 41, SCRIPT="headless.py", STATUS="1")
    assert ran.returncode == 1
    assert ran.stdout.splitlines()[:2] == [
        "illustrate: error: frame 9: full",
        "illustrate: error: frame 10: full",
    ]
    assert called == (
        "-b --python-exit-code 3 --python headless.py -- merge out --into=into.blend "
        "--from=s.blend --frames=1-10"
    )
    ran, _ = run(*arguments, 42)
    assert ran.returncode == 0 and ran.stdout.startswith("no errors in the logs of job 42\n")


def test_a_task_has_resources_of_its_own(run: Run, tmp_path: Path) -> None:
    (tmp_path / "user" / "extensions").mkdir(parents=True)
    arguments = ("draw", "s.blend", "out", 1, 10, 4)
    run(*arguments, SLURM_ARRAY_TASK_ID="0", RESOURCES=str(tmp_path / "user"))
    told = (tmp_path / "log.own").read_text()
    assert told.startswith(f"resources {tmp_path}/illustrate.") and told.endswith(": extensions\n")
    assert not list(tmp_path.glob("illustrate.*"))


def test_how_to_use_it(run: Run) -> None:
    ran, called = run("s.blend", "out")
    assert ran.returncode == 2 and not called
    assert "illustrate.sh FILE.blend OUT INTO.blend FIRST LAST [CHUNK]" in ran.stderr
