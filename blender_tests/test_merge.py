"""Frames that were drawn apart, as keyframes."""

import json
import pathlib
import shutil
from typing import Any

import bpy
import illustrate
import numpy as np
import pytest
from blender_render import render_png
from illustrate import output
from illustrate.farm import main as farm
from illustrate.output import pencil

import tools

JSON = ("--format", "json", "--progress", "none")


@pytest.fixture
def shot(scene: Any, tmp_path: Any) -> pathlib.Path:
    """A saved file of a hatched cube that moves through frames 1 to 3."""
    cube = tools.cube_scene(scene)
    scene.frame_start, scene.frame_end = 1, 3
    for frame, x in ((1, 0.0), (3, 1.0)):
        cube.location.x = x
        cube.keyframe_insert("location", frame=frame)
    path = pathlib.Path(tmp_path) / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def draw(shot: pathlib.Path, *arguments: str) -> pathlib.Path:
    """The folder that frames of a file were drawn to."""
    out = shot.parent / "out"
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    assert farm.main(["--out", str(out), *JSON, *arguments]) == 0
    return out


def merge(shot: pathlib.Path, *arguments: str) -> int:
    """The exit code; the file is open as it is now."""
    code: int = farm.main(["merge", str(shot.parent / "out"), "--into", str(shot), *arguments])
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    return code


def strokes() -> Any:
    """What the writer wrote: by layer and frame, points, radii and whether strokes are closed."""
    [thing] = (t for t in bpy.data.objects if t.type == tools.pencil_type())
    frames = {
        layer.name if tools.V3 else layer.info: [
            (frame.frame_number, frame.keyframe_type) for frame in layer.frames
        ]
        for layer in thing.data.layers
    }
    return frames, tools.read_pencil(thing)


def same(first: Any, second: Any) -> bool:
    assert first[0] == second[0]
    assert first[1].keys() == second[1].keys()
    return all(
        np.array_equal(a[name], b[name])
        for title in first[1]
        for a, b in zip(first[1][title], second[1][title], strict=True)
        for name in ("points", "radii", "closed")
    )


def test_merged_frames_are_a_bake(shot: Any) -> None:
    draw(shot, "--frames", "1-3")
    assert merge(shot) == 0
    merged = strokes()
    assert all({kind for _, kind in found} == {pencil.BAKED} for found in merged[0].values())
    assert {number for found in merged[0].values() for number, _ in found} == {1, 2, 3}
    bpy.ops.illustrate.bake()
    assert same(merged, strokes())
    bpy.ops.illustrate.clear()
    assert not [t for t in bpy.data.objects if t.type == tools.pencil_type()]
    assert sorted(p.name for p in shot.parent.iterdir()) == ["out", "shot.blend"]


def test_chunks_that_warm_up_merge_into_one_bake(shot: Any) -> None:
    draw(shot, "--frames", "1-2")
    draw(shot, "--frames", "3", "--warm-up", "2")
    assert merge(shot, "--frames", "1-3") == 0
    merged = strokes()
    bpy.ops.illustrate.bake()
    assert same(merged, strokes())


def pictures(folder: pathlib.Path) -> list[Any]:
    """The pixels of frames 1 to 3, as Blender renders the strokes."""
    scene, read = bpy.context.scene, []
    folder.mkdir()
    for frame in (1, 2, 3):
        scene.frame_set(frame)
        path = folder / f"{frame}.png"
        render_png(str(path), scene, [t for t in scene.objects if t.type == tools.pencil_type()])
        image = bpy.data.images.load(str(path))
        read.append(np.array(image.pixels[:]))
    return read


def test_merged_frames_render_as_a_bake(shot: Any, tmp_path: Any) -> None:
    draw(shot, "--frames", "1-3")
    assert merge(shot) == 0
    merged = pictures(tmp_path / "merged")
    bpy.ops.illustrate.bake()
    baked = pictures(tmp_path / "baked")
    assert all(np.array_equal(*pair) for pair in zip(merged, baked, strict=True))
    assert not np.array_equal(merged[0], merged[2]) and merged[0].min() < 0.2


def test_a_file_that_is_not_there_begins_as_another(shot: Any, tmp_path: Any, capsys: Any) -> None:
    out, into = draw(shot, "--frames", "1-3"), tmp_path / "drawn.blend"
    words = ["merge", str(out), "--into", str(into)]
    assert farm.main(words) == 1 and "drawn.blend" in capsys.readouterr().err
    before = shot.read_bytes()
    assert farm.main([*words, "--from", str(shot)]) == 0
    assert shot.read_bytes() == before
    bpy.ops.wm.open_mainfile(filepath=str(into))
    bpy.data.texts.new("Later")
    bpy.ops.wm.save_mainfile()
    assert farm.main([*words, "--from", str(shot)]) == 0
    assert "Later" in bpy.data.texts


def test_a_merge_that_fails_midway_leaves_the_file(shot: Any, monkeypatch: Any) -> None:
    draw(shot, "--frames", "1-3")
    before, append = shot.read_bytes(), output.PENCIL_API.append
    handlers = list(bpy.app.handlers.save_pre)

    def fails(data: Any, layer: Any, frame: Any, *others: Any) -> None:
        if frame.frame_number == 2:
            raise MemoryError
        append(data, layer, frame, *others)

    monkeypatch.setattr(output.PENCIL_API, "append", fails)
    with pytest.raises(MemoryError):
        merge(shot)
    assert shot.read_bytes() == before and list(bpy.app.handlers.save_pre) == handlers
    assert sorted(p.name for p in shot.parent.iterdir()) == ["out", "shot.blend"]


def test_all_else_in_the_file_stays(shot: Any) -> None:
    bpy.data.texts.new("Notes").write("Mind the gap")
    bpy.ops.wm.save_mainfile()
    out = draw(shot, "--frames", "1-3")
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    before = {**tools.snapshot(), "active": None}
    assert merge(shot) == 0
    output.clear(bpy.context.scene)
    assert {**tools.snapshot(), "active": None} == before
    assert bpy.data.texts["Notes"].as_string() == "Mind the gap"
    assert len(list(out.iterdir())) == 3


def test_frames_of_the_artists_stay(shot: Any, capsys: Any) -> None:
    bpy.ops.illustrate.bake()
    [thing] = (t for t in bpy.data.objects if t.type == tools.pencil_type())
    tools.add_artists_stroke_at(thing.data.layers[-1], 2)
    bpy.ops.wm.save_mainfile()
    before = tools.artists_bytes(thing.data.layers[-1])
    draw(shot, "--frames", "1-3")
    assert merge(shot) == 0
    [thing] = (t for t in bpy.data.objects if t.type == tools.pencil_type())
    assert tools.artists_bytes(thing.data.layers[-1]) == before
    assert "Left as drawn by hand" in capsys.readouterr().err


def cut(out: pathlib.Path) -> None:
    path = out / "shot_0002.json"
    path.write_bytes(path.read_bytes()[:-50])


def restamp(out: pathlib.Path, **changes: Any) -> None:
    path = out / "shot_0002.json"
    data = json.loads(path.read_text())
    data["made_by"].update(changes)
    path.write_text(json.dumps(data))


SPOILS: dict[str, tuple[Any, str]] = {
    "missing": (lambda out: (out / "shot_0002.json").unlink(), "Missing frames: 2"),
    "damaged": (cut, 'Damaged files: "shot_0002.json"'),
    "settings": (lambda out: restamp(out, settings="other"), '"shot_0002.json"'),
    "version": (lambda out: restamp(out, version="9.9"), '"shot_0002.json"'),
    "not ours": (lambda out: (out / "a.json").write_text("{}"), '"a.json"'),
    "no stamp": (lambda out: restamp(out, camera=None), '"shot_0002.json"'),
    "twice": (lambda out: shutil.copy(out / "shot_0002.json", out / "z.json"), '"z.json"'),
}


@pytest.mark.parametrize("spoil", SPOILS)
def test_what_is_wrong_is_named_and_merged_only_when_asked(
    shot: Any, spoil: str, capsys: Any
) -> None:
    out = draw(shot, "--frames", "1-4")
    change, words = SPOILS[spoil]
    change(out)
    before = shot.read_bytes()
    assert merge(shot) == 1
    assert shot.read_bytes() == before
    error = capsys.readouterr().err
    assert error.startswith("illustrate: error: Nothing was merged. ") and words in error
    assert merge(shot, "--partial") == 0
    assert words in capsys.readouterr().err
    frames = {number for found in strokes()[0].values() for number, _ in found}
    assert frames == ({1, 2, 3, 4} if spoil in ("not ours", "twice") else {1, 3, 4})


def test_frames_that_must_be_there(shot: Any, capsys: Any) -> None:
    draw(shot, "--frames", "1-3x2")
    assert merge(shot) == 0
    assert merge(shot, "--frames", "1-5x2") == 1
    assert "Missing frames: 5" in capsys.readouterr().err
    assert merge(shot, "--frames", "3") == 0


def test_folders_and_files_that_cannot_be_used(shot: Any, tmp_path: Any, capsys: Any) -> None:
    (tmp_path / "empty").mkdir()
    for folder, file, words in (
        ("empty", shot, "there are no frames"),
        ("nowhere", shot, "nowhere"),
        ("empty", tmp_path / "nothing.blend", "nothing.blend"),
    ):
        assert farm.main(["merge", str(tmp_path / folder), "--into", str(file)]) == 1
        assert words in capsys.readouterr().err
    assert not (tmp_path / "nothing.blend").exists()


def test_curves_have_no_keyframes(shot: Any, capsys: Any) -> None:
    bpy.context.scene.illustrate.output = "CURVES"
    bpy.ops.wm.save_mainfile()
    draw(shot, "--frames", "1")
    assert merge(shot) == 1
    assert "set Output to Grease Pencil" in capsys.readouterr().err


def test_the_operator_imports_into_the_open_file(shot: Any) -> None:
    out = draw(shot, "--frames", "1-3")
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    assert bpy.ops.illustrate.import_frames(directory=str(out)) == {"FINISHED"}
    imported = strokes()
    bpy.ops.illustrate.bake()
    assert same(imported, strokes())
    cut(out)
    with pytest.raises(RuntimeError, match=r"Damaged files.*shot_0002"):
        bpy.ops.illustrate.import_frames(directory=str(out))
    assert bpy.ops.illustrate.import_frames(directory=str(out), partial=True) == {"FINISHED"}


def test_the_command_line(shot: Any) -> None:
    out = draw(shot, "--frames", "1-2")
    script = pathlib.Path(illustrate.__file__).parent / "headless.py"
    ran = tools.run_script(script, "merge", str(out), "--into", str(shot))
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert f"Saved: '{shot}'" in ran.stdout and "merged 2 frames" in ran.stdout
    ran = tools.run_script(script, "merge", str(out))
    assert ran.returncode == 2 and "--into" in ran.stderr
