"""Frames of a sequence drawn apart: exposed as one, begun as those before them ended."""

import itertools
import pathlib
from typing import Any

import bpy
import illustrate
import pytest
from farm_shots import bad_at, contents, draw, moving_cube
from illustrate.farm import frames as farm_frames
from illustrate.output import stamps


@pytest.fixture
def shot(scene: Any, tmp_path: Any) -> pathlib.Path:
    return moving_cube(scene, tmp_path)


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
    start = ill.View.start_draw

    def watched(view: Any, previous: Any = None, detail: str = "whole") -> Any:
        job = start(view, previous, detail)
        found.append((previous, job))
        return job

    monkeypatch.setattr(ill.View, "start_draw", watched)
    return found


def chained(seeds: list[Any]) -> list[bool]:
    """Of each drawing: it was started from the one before."""
    assert seeds[0][0] is None
    return [after[0] is before[1].result() for before, after in itertools.pairwise(seeds)]


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


@pytest.mark.usefixtures("shot")
def test_nothing_warms_up_before_the_scene_begins(tmp_path: Any, seeds: list[Any]) -> None:
    assert draw(tmp_path / "whole", "--frames", "1-3") == 0
    seeds.clear()
    assert draw(tmp_path / "out", "--frames", "1-3", "--warm-up", "5") == 0
    assert chained(seeds) == [True, True]
    assert contents(tmp_path / "out") == contents(tmp_path / "whole")
    seeds.clear()
    bpy.context.scene.frame_start = 3
    assert draw(tmp_path / "out", "--frames", "4", "--warm-up", "5") == 0
    assert chained(seeds) == [True]


@pytest.mark.parametrize("extension", ["svg", "png", "json"])
@pytest.mark.usefixtures("shot")
def test_the_next_frame_is_prepared_meanwhile(
    tmp_path: Any, monkeypatch: Any, extension: str
) -> None:
    ill, there = illustrate.native.load(), []
    start = ill.start_prepare

    def watched(*arguments: Any, **named: Any) -> Any:
        there.append(len(list((tmp_path / "ahead").glob(f"*.{extension}"))))
        return start(*arguments, **named)

    monkeypatch.setattr(ill, "start_prepare", watched)
    arguments = ("--frames", "1-4", "--format", extension)
    assert draw(tmp_path / "ahead", *arguments) == 0
    assert there == [0, 0, 1, 2]  # before the file of the frame before is written
    assert draw(tmp_path / "after", *arguments, "--skip-existing") == 0
    assert contents(tmp_path / "ahead") == contents(tmp_path / "after")
