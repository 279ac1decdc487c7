"""The workers of a farm: processes that draw frames, ended midway, by several at once."""

import os
import pathlib
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import bpy
import illustrate
import pytest
from farm_shots import FORMATS, bad_at, contents, draw, moving_cube
from illustrate.output import stamps

import tools

SCRIPT = pathlib.Path(illustrate.__file__).parent / "headless.py"


@pytest.fixture
def shot(scene: Any, tmp_path: Any) -> pathlib.Path:
    return moving_cube(scene, tmp_path)


Start = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture(params=["script", "command"])
def start(request: Any) -> Start:
    """Starts a worker on a file with arguments, in either of the two spellings."""
    if request.param == "script":
        return lambda blend, *arguments: _popen([*_script(str(blend)), *arguments])
    if not illustrate.__name__.startswith("bl_ext.") or not bpy.app.binary_path:
        pytest.skip("--command is of extensions, in programs of Blender 4.2 and later")
    command = [bpy.app.binary_path, "-b"]
    return lambda blend, *arguments: _popen(
        [*command, str(blend), "--command", "illustrate", *arguments]
    )


def _script(blend: str) -> list[str]:
    if not bpy.app.binary_path:
        return [sys.executable, str(SCRIPT), blend]
    first = [bpy.app.binary_path, "-b", "--factory-startup", blend]
    return [*first, "--python-exit-code", "3", "--python", str(SCRIPT), "--"]


def _popen(words: list[str]) -> "subprocess.Popen[str]":
    return subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_what_a_worker_says(shot: Any, start: Start, tmp_path: Any) -> None:
    bad_at(3)
    bpy.ops.wm.save_mainfile()
    out = tmp_path / "out"
    arguments = ("--out", str(out), "--frames", "1-5x2,6", "--progress", "none")
    said, errors = start(shot, *arguments).communicate(timeout=300)
    assert re.findall(r"^Saved: '(.*)'$", said, re.M) == [
        str(out / f"shot_000{frame}.svg") for frame in (1, 5, 6)
    ]
    assert len(re.findall(r"^Time: \d\d:\d\d\.\d\d$", said, re.M)) == 3
    assert errors.splitlines()[-1] == "illustrate: failed frames: 3 (1 of 4 frames)"
    again = start(shot, *arguments, "--skip-existing")
    said, errors = again.communicate(timeout=300)
    assert again.returncode == 1 and "failed frames: 3 (1 of 4 frames)" in errors
    assert re.findall(r"^skipping existing frame (\d+)$", said, re.M) == ["1", "5", "6"]
    assert "Saved: " not in said


@pytest.mark.skipif(os.name == "nt", reason="there are no signals")
def test_a_termination_leaves_whole_files(shot: Any, start: Start, tmp_path: Any) -> None:
    out = tmp_path / "out"
    worker = start(shot, "--out", str(out), "--frames", "1-500", *FORMATS)
    assert worker.stdout is not None
    for line in worker.stdout:
        if line.startswith("Saved: ") and line.rstrip().endswith("_0002.svg'"):
            break
    worker.send_signal(signal.SIGTERM)
    begun = time.monotonic()
    assert worker.wait(30) == -signal.SIGTERM
    assert time.monotonic() - begun < 1.0
    worker.communicate()
    left = sorted(out.iterdir())
    assert left and len(left) < 100
    for path in left:
        assert stamps.read_stamp(str(path))["frame"] == int(path.stem[-4:])


@pytest.mark.skipif(os.name == "nt", reason="there are no signals")
def test_a_termination_while_writing_removes_what_was_begun(tmp_path: Any) -> None:
    from illustrate.output import files

    def end(*_: Any) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, end)
    try:
        with pytest.raises(KeyboardInterrupt), files._whole(str(tmp_path / "x.svg")) as unfinished:
            pathlib.Path(unfinished).write_text("half")
            os.kill(os.getpid(), signal.SIGTERM)
            os.getpid()  # signals are seen between instructions
        assert signal.getsignal(signal.SIGTERM) is end
    finally:
        signal.signal(signal.SIGTERM, before or signal.SIG_DFL)
    assert not list(tmp_path.iterdir())


def test_two_workers_on_the_same_frames(shot: Any, start: Start, tmp_path: Any) -> None:
    out = tmp_path / "out"
    workers = [
        start(shot, "--out", str(out), "--frames", "1-3", "--format", "svg,json") for _ in range(2)
    ]
    for worker in workers:
        worker.communicate(timeout=300)
        assert worker.returncode == 0
    assert len(contents(out)) == 6
    for path in out.iterdir():
        assert stamps.read_stamp(str(path))["frame"] == int(path.stem[-4:])
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out", "shot.blend"]


def test_nothing_is_written_elsewhere(shot: Any, tmp_path: Any) -> None:
    home = tmp_path / "home"
    home.mkdir()
    arguments = ("--out", str(tmp_path / "out"), "--frames", "1-2", *FORMATS)
    ran = tools.run_script(SCRIPT, *arguments, blend=shot, variables={"HOME": str(home)})
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert len(contents(tmp_path / "out")) == 8
    assert sorted(path.name for path in tmp_path.iterdir()) == ["home", "out", "shot.blend"]
    assert not [path for path in home.rglob("*") if path.suffix in (".png", ".blend", ".txt")]


@pytest.mark.usefixtures("shot")
def test_many_frames_leave_nothing_behind(tmp_path: Any) -> None:
    untouched = tools.snapshot()
    assert draw(tmp_path, "--frames", "1-3", "--name", "same_#") == 0
    moved = {name: untouched[name] for name in ("frame", "things")}
    assert {**tools.snapshot(), **moved} == untouched
    pictures = ("--name", "same_#", "--format", "png")  # in the colours of strokes in the scene
    assert draw(tmp_path, "--frames", "1-3", *pictures) == 0
    before = tools.snapshot()
    things = sum(len(layer.frames) for layer in bpy.data.objects["Illustration"].data.layers)
    assert draw(tmp_path, "--frames", "4-12", *pictures) == 0
    after = {**tools.snapshot(), "frame": before["frame"], "things": before["things"]}
    assert after == before
    layers = bpy.data.objects["Illustration"].data.layers
    assert sum(len(layer.frames) for layer in layers) == things
