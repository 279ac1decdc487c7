"""What a farm relies on: frames drawn apart, again, ended midway, by several at once."""

import itertools
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
from typing import Any

import bpy
import illustrate
import pytest
from illustrate.farm import frames as farm_frames
from illustrate.farm import main as farm
from illustrate.farm.arguments import frames as frames_of
from illustrate.farm.lines import Progress, time_text
from illustrate.output import stamps

import tools

SCRIPT = pathlib.Path(illustrate.__file__).parent / "headless.py"


@pytest.fixture
def shot(scene: Any, tmp_path: Any) -> pathlib.Path:
    """A saved file of a cube that moves through frames 1 to 6."""
    cube = tools.cube_scene(scene)
    scene.illustrate.hatching = False
    for frame, x in ((1, 0.0), (6, 1.0)):
        cube.location.x = x
        cube.keyframe_insert("location", frame=frame)
    return save(tmp_path)


def save(folder: pathlib.Path) -> pathlib.Path:
    path = folder / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def draw(out: pathlib.Path, *arguments: str) -> int:
    """The exit code of the command, for the open file, in this process."""
    code: int = farm.main(["--out", str(out), *arguments])
    return code


def contents(folder: pathlib.Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("7", [7]),
        ("-3--1", [-3, -2, -1]),
        ("1-20x4,30", [1, 5, 9, 13, 17, 30]),
        ("1-9:4", [1, 5, 9]),
        ("9-9", [9]),
        ("1-3,2-4", [1, 2, 3, 4]),
    ],
)
def test_frames(text: str, numbers: list[int]) -> None:
    assert frames_of(text) == numbers


@pytest.mark.parametrize(
    ("seconds", "text"), [(12.34, "00:12.34"), (59.999, "01:00.00"), (3725.5, "1:02:05.50")]
)
def test_times(seconds: float, text: str) -> None:
    assert time_text(seconds) == text


@pytest.mark.parametrize(
    ("frames", "frame", "count", "before"),
    [
        ([5, 7, 9], 5, 2, [1, 3]),
        ([5, 7, 9], 9, 2, [5, 7]),
        ([5, 7, 9], 7, 3, [1, 3, 5]),
        ([5], 5, 2, [3, 4]),
        ([5, 6], 6, 0, []),
    ],
)
def test_frames_to_warm_up_on(frames: list[int], frame: int, count: int, before: list[int]) -> None:
    assert farm_frames.frames_before(frames, frame, count) == before


def test_progress_for_open_job_description(capsys: Any) -> None:
    progress = Progress("openjd", 2)
    progress.begin("shot_0001")
    assert progress(0.0, "contour") and progress(0.25, "contour") and progress(0.25, "tone")
    progress.end()
    progress.fail("failed frames: 2")
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "openjd_status: shot_0001: Finding silhouettes",
        "openjd_progress: 0.0",
        "openjd_progress: 12.5",
        "openjd_status: shot_0001: Lighting",
        "openjd_progress: 50.0",
        "openjd_fail: failed frames: 2",
    ]
    assert said.err == "illustrate: failed frames: 2\n"


@pytest.mark.usefixtures("shot")
def test_progress_can_be_left_out(tmp_path: Any, capsys: Any) -> None:
    assert draw(tmp_path / "out", "--frames", "1", "--progress", "none") == 0
    saved, time, summary = (
        line for line in capsys.readouterr().out.splitlines() if not line.startswith("Info")
    )
    assert saved == f"Saved: '{tmp_path / 'out' / 'shot_0001.svg'}'"
    assert re.fullmatch(r"Time: \d\d:\d\d\.\d\d", time)
    assert summary.startswith("shot_0001: ")


FORMATS = ("--format", "svg,png,json,blend")


@pytest.mark.usefixtures("shot")
def test_existing_frames_are_skipped(tmp_path: Any, capsys: Any) -> None:
    out = tmp_path / "out"
    assert draw(out, "--frames", "1-3x2", *FORMATS) == 0
    before = contents(out)
    capsys.readouterr()
    assert draw(out, "--frames", "1-3", *FORMATS, "--skip-existing") == 0
    said = capsys.readouterr().out
    assert "skipping existing frame 1\n" in said and "skipping existing frame 3\n" in said
    assert said.count("Time: ") == 1
    after = contents(out)
    assert len(after) == 12 and {name: after[name] for name in before} == before


@pytest.mark.parametrize("kind", ["svg", "png", "json", "blend"])
@pytest.mark.usefixtures("shot")
def test_a_damaged_file_is_drawn_again(tmp_path: Any, kind: str, capsys: Any) -> None:
    arguments = ("--frames", "2", "--format", kind, "--skip-existing", "--progress", "none")
    assert draw(tmp_path, *arguments) == 0
    path = tmp_path / f"shot_0002.{kind}"
    whole = path.read_bytes()
    path.write_bytes(whole[:-40])
    assert draw(tmp_path, *arguments) == 0
    assert "skipping" not in capsys.readouterr().out
    assert stamps.read_stamp(str(path))["frame"] == 2
    assert draw(tmp_path, *arguments) == 0
    assert "skipping existing frame 2" in capsys.readouterr().out


@pytest.mark.parametrize(
    "change", ["settings", "style", "size", "page", "version", "no stamp", "frame"]
)
@pytest.mark.usefixtures("shot")
def test_frames_of_other_settings_are_drawn_again(
    tmp_path: Any, change: str, monkeypatch: Any
) -> None:
    scene, path = bpy.context.scene, tmp_path / "shot_0001.svg"
    arguments = ["--frames", "1", "--skip-existing"]
    assert draw(tmp_path, *arguments) == 0
    if change == "settings":
        scene.illustrate.line_width_px += 1
    elif change == "style":
        bpy.data.objects["Box"].illustrate.use_own = True
    elif change == "size":
        scene.render.resolution_x += 2
    elif change == "page":
        arguments += ["--width-mm", "77"]
    elif change == "version":
        monkeypatch.setattr(illustrate.native.load(), "__version__", "9.9")
    elif change == "no stamp":
        path.write_text(re.sub("<metadata.*</metadata>", "", path.read_text()))
    else:
        path.rename(tmp_path / "shot_0002.svg")
        path, arguments[1] = tmp_path / "shot_0002.svg", "2"
    before = path.read_bytes()
    assert draw(tmp_path, *arguments) == 0
    assert path.read_bytes() != before


@pytest.mark.usefixtures("shot")
def test_what_does_not_show_is_not_in_the_stamp() -> None:
    chosen = bpy.context.scene.illustrate
    before = stamps.stamp_of(bpy.context.scene, 200.0, "centerline")
    chosen.frame_end += 1
    chosen.threads += 1
    assert stamps.stamp_of(bpy.context.scene, 200.0, "centerline") == before


@pytest.mark.usefixtures("shot")
def test_a_blend_with_a_stamp_opens(tmp_path: Any) -> None:
    for compressed in (False, True):
        path = str(tmp_path / f"{compressed}.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path, copy=True, compress=compressed)
        with pytest.raises(ValueError, match="not a whole file"):
            stamps.read_stamp(path)
        stamps.append_stamp(path, {"frame": 3})
        assert stamps.read_stamp(path) == {"frame": 3}
        with bpy.data.libraries.load(path) as (inside, _):
            assert "Box" in inside.objects
        bpy.ops.wm.open_mainfile(filepath=path)
        assert "Box" in bpy.data.objects


def bad_at(frame: int) -> None:
    """Nothing is there to be drawn at a frame."""
    cube = bpy.data.objects["Box"]
    for number in (frame - 1, frame, frame + 1):
        cube.hide_render = number == frame
        cube.keyframe_insert("hide_render", frame=number)


@pytest.mark.usefixtures("shot")
def test_a_bad_frame_is_gone_past(tmp_path: Any, capsys: Any) -> None:
    bad_at(2)
    assert draw(tmp_path / "out", "--frames", "1-3") == 1
    assert sorted(contents(tmp_path / "out")) == ["shot_0001.svg", "shot_0003.svg"]
    errors = capsys.readouterr().err.splitlines()
    assert errors[0].startswith("illustrate: error: frame 2: Nothing in scene")
    assert errors[-1] == "illustrate: failed frames: 2 (1 of 3 frames)"


@pytest.mark.usefixtures("shot")
def test_a_bug_in_a_frame_is_gone_past(tmp_path: Any, capsys: Any, monkeypatch: Any) -> None:
    write = farm_frames.files.write_file

    def fails_once(path: str, page: Any) -> None:
        if path.endswith("2.svg"):
            raise RuntimeError("no such luck")
        write(path, page)

    monkeypatch.setattr(farm_frames.files, "write_file", fails_once)
    assert draw(tmp_path / "out", "--frames", "1-3") == 1
    assert sorted(contents(tmp_path / "out")) == ["shot_0001.svg", "shot_0003.svg"]
    assert "no such luck" in capsys.readouterr().err


def exposures(out: pathlib.Path) -> list[float]:
    return [stamps.read_stamp(str(path))["exposure"] for path in sorted(out.glob("*.svg"))]


@pytest.mark.usefixtures("shot")
def test_frames_of_one_command_share_an_exposure(tmp_path: Any) -> None:
    bpy.context.scene.illustrate.hatching = True
    sun = bpy.data.objects["Sun"].data
    for frame, energy in ((1, 1.0), (3, 100.0)):
        sun.energy = energy
        sun.keyframe_insert("energy", frame=frame)
    whole, alone, same = tmp_path / "whole", tmp_path / "alone", tmp_path / "same"
    assert draw(whole, "--frames", "1-3") == 0
    assert draw(alone, "--frames", "3") == 0
    assert draw(same, "--frames", "3", "--expose-as", "1") == 0
    assert len(set(exposures(whole))) == 1 and exposures(alone)[0] != exposures(whole)[0]
    assert exposures(same)[0] == exposures(whole)[0]
    (whole / "shot_0001.svg").unlink()
    assert draw(whole, "--frames", "1-3", "--skip-existing") == 0
    assert len(set(exposures(whole))) == 1


@pytest.mark.usefixtures("shot")
def test_a_frame_to_expose_as_that_cannot_be_drawn(tmp_path: Any, capsys: Any) -> None:
    bad_at(2)
    assert draw(tmp_path / "out", "--frames", "3-4", "--expose-as", "2") == 1
    errors = capsys.readouterr().err
    assert "error: frame 3: frame 2, of --expose-as: Nothing in scene" in errors
    assert "failed frames: 3, 4 (2 of 2 frames)" in errors
    bpy.context.scene.illustrate.auto_exposure = False
    assert draw(tmp_path / "out", "--frames", "3-4", "--expose-as", "2") == 0


@pytest.mark.usefixtures("shot")
def test_frames_that_are_all_there_cost_nothing(tmp_path: Any, seeds: list[Any]) -> None:
    arguments = ("--frames", "1-2", "--skip-existing", "--expose-as", "3", "--warm-up", "1")
    assert draw(tmp_path, *arguments) == 0
    seeds.clear()
    assert draw(tmp_path, *arguments) == 0
    assert not seeds


@pytest.fixture
def seeds(monkeypatch: Any) -> list[Any]:
    """Drawings that others were started from, None for each that was not."""
    ill, found = illustrate.native.load(), []
    draw_native = ill.draw

    def watched(*arguments: Any, **named: Any) -> Any:
        made = draw_native(*arguments, **named)
        found.append((named.get("previous"), made))
        return made

    watched.__doc__ = draw_native.__doc__
    monkeypatch.setattr(ill, "draw", watched)
    return found


def chained(seeds: list[Any]) -> list[bool]:
    """Of each drawing: it was started from the one before."""
    assert seeds[0][0] is None
    return [after[0] is before[1] for before, after in itertools.pairwise(seeds)]


@pytest.mark.usefixtures("shot")
def test_strokes_follow_the_frame_before(tmp_path: Any, seeds: list[Any]) -> None:
    assert draw(tmp_path, "--frames", "1-3") == 0
    assert chained(seeds) == [True, True]
    seeds.clear()
    bpy.context.scene.illustrate.keep_strokes = False
    assert draw(tmp_path, "--frames", "1-3", "--warm-up", "2") == 0
    assert [seed for seed, _ in seeds] == [None] * len(seeds) and len(seeds) <= 3


@pytest.mark.usefixtures("shot")
def test_a_chunk_warms_up_on_the_frames_before(tmp_path: Any, seeds: list[Any]) -> None:
    bpy.context.scene.illustrate.hatching = True
    whole, chunk = tmp_path / "whole", tmp_path / "chunk"
    assert draw(whole, "--frames", "1-4") == 0
    seeds.clear()
    assert draw(chunk, "--frames", "3-4", "--warm-up", "2") == 0
    assert chained(seeds) == [True, True, True]
    assert contents(chunk) == {name: contents(whole)[name] for name in contents(chunk)}
    assert len(contents(chunk)) == 2
    assert all(b"data-id=" in data for data in contents(whole).values())
    (whole / "shot_0004.svg").unlink()
    assert draw(whole, "--frames", "1-4", "--warm-up", "3", "--skip-existing") == 0
    assert contents(whole)["shot_0004.svg"] == contents(chunk)["shot_0004.svg"]


def start(blend: Any, *arguments: str) -> "subprocess.Popen[str]":
    """The script in another process."""
    command = [sys.executable, str(SCRIPT), str(blend), *arguments]
    if bpy.app.binary_path:
        first = [bpy.app.binary_path, "-b", "--factory-startup", str(blend)]
        command = [*first, "--python-exit-code", "3", "--python", str(SCRIPT), "--", *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


@pytest.mark.skipif(os.name == "nt", reason="there are no signals")
def test_a_termination_leaves_whole_files(shot: Any, tmp_path: Any) -> None:
    out = tmp_path / "out"
    worker = start(shot, "--out", str(out), "--frames", "1-500", *FORMATS)
    assert worker.stdout is not None
    for line in worker.stdout:
        if line.startswith("Saved: ") and line.rstrip().endswith("_0002.svg'"):
            break
    worker.send_signal(signal.SIGTERM)
    worker.stdout.close()
    assert worker.wait(30) == -signal.SIGTERM
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


def test_two_workers_on_the_same_frames(shot: Any, tmp_path: Any) -> None:
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
    assert draw(tmp_path, "--frames", "1-3", "--name", "same_#") == 0
    before = tools.snapshot()
    things = sum(len(layer.frames) for layer in bpy.data.objects["Illustration"].data.layers)
    assert draw(tmp_path, "--frames", "4-12", "--name", "same_#") == 0
    after = {**tools.snapshot(), "frame": before["frame"], "things": before["things"]}
    assert after == before
    layers = bpy.data.objects["Illustration"].data.layers
    assert sum(len(layer.frames) for layer in layers) == things


@pytest.mark.usefixtures("shot")
def test_json_says_how_it_was_made(tmp_path: Any) -> None:
    assert draw(tmp_path, "--frames", "2", "--format", "json") == 0
    made_by = json.loads((tmp_path / "shot_0002.json").read_text())["made_by"]
    assert made_by["frame"] == 2 and made_by["version"] == illustrate.native.load().__version__
    assert set(made_by) == {"version", "settings", "frame", "exposure", "camera"}
