"""The Slurm script, with stubs of sbatch and Blender that say how they were called."""

import os
import pathlib
import subprocess
from typing import Any

import pytest

SCRIPT = pathlib.Path(__file__).parents[1] / "farm" / "slurm" / "illustrate.sh"
STUB = '#!/bin/sh\nprintf "%s\\n" "$*" >>"$LOG"\necho "41;cluster"\n'

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the script is bash")


@pytest.fixture
def run(tmp_path: Any) -> Any:
    """Runs the script; what it printed, and the calls of the stubs."""
    for name in ("sbatch", "blender"):
        (tmp_path / name).write_text(STUB)
        (tmp_path / name).chmod(0o755)

    def call(*arguments: str, **variables: str) -> tuple[str, list[str]]:
        log = tmp_path / "log"
        log.write_text("")
        path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
        ran = subprocess.run(
            ["bash", str(SCRIPT), *arguments],
            env={**os.environ, "PATH": path, "LOG": str(log), **variables},
            capture_output=True,
            text=True,
            check=True,
        )
        return ran.stdout, log.read_text().splitlines()

    return call


def test_an_array_of_chunks_and_a_merge_after_it(run: Any) -> None:
    said, (drawn, merged) = run("my shot.blend", "out", "into.blend", "1", "10", "4", MOST="2")
    assert said == "draw 41\nmerge 41\n"
    assert "--array=1-10:4%2 " in drawn
    assert drawn.endswith("illustrate.sh draw my shot.blend out 1 10 4")
    assert "--dependency=afterok:41 --kill-on-invalid-dep=yes" in merged
    assert merged.endswith("illustrate.sh merge my shot.blend out into.blend 1 10")


@pytest.mark.parametrize(("begin", "chunk"), [("1", "1-4"), ("9", "9-10")])
def test_a_chunk(run: Any, begin: str, chunk: str) -> None:
    arguments = ("draw", "s.blend", "out", "1", "10", "4")
    _, [called] = run(*arguments, SLURM_ARRAY_TASK_ID=begin, WARM_UP="3")
    assert called == (
        f"-b s.blend --command illustrate --out=out --frames={chunk} --format=svg,json "
        "--warm-up=3 --expose-as=1 --skip-existing --progress none"
    )


def test_a_merge_into_a_copy(run: Any, tmp_path: Any) -> None:
    (tmp_path / "s.blend").write_text("scene")
    files = (str(tmp_path / "s.blend"), "out", str(tmp_path / "into.blend"))
    _, [called] = run("merge", *files, "1", "10", SCRIPT="headless.py")
    assert (tmp_path / "into.blend").read_text() == "scene"
    assert called == (
        f"-b --python-exit-code 3 --python headless.py -- merge out --into {files[2]} --frames=1-10"
    )
