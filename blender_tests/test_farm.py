"""What a farm relies on: what is said, what is skipped, bad frames gone past."""

import json
import pathlib
import re
from typing import Any

import bpy
import illustrate
import pytest
from farm_shots import FORMATS, bad_at, contents, draw, moving_cube
from illustrate.farm import frames as farm_frames
from illustrate.farm.arguments import frames as frames_of
from illustrate.farm.lines import Progress, time_text
from illustrate.output import stamps


@pytest.fixture
def shot(scene: Any, tmp_path: Any) -> pathlib.Path:
    return moving_cube(scene, tmp_path)


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


@pytest.mark.usefixtures("shot")
def test_json_says_how_it_was_made(tmp_path: Any) -> None:
    assert draw(tmp_path, "--frames", "2", "--format", "json") == 0
    made_by = json.loads((tmp_path / "shot_0002.json").read_text())["made_by"]
    assert made_by["frame"] == 2 and made_by["version"] == illustrate.native.load().__version__
    assert set(made_by) == {"version", "settings", "frame", "exposure", "camera"}
