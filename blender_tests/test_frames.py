"""Keyframes: what a click and a bake write, and what they leave."""

import contextlib
import itertools
from typing import Any

import bpy
import pytest
from illustrate import native
from illustrate.messages import IllustrateError
from illustrate.output import pencil
from illustrate.running import bake, jobs, operators

import tools


def pencil_object() -> Any:
    return next(thing for thing in bpy.data.objects if thing.type == tools.pencil_type())


def frames() -> dict[str, dict[int, tuple[int, str]]]:
    """By layer and frame: strokes, and the keyframe's type."""
    found: dict[str, dict[int, tuple[int, str]]] = {}
    for layer in pencil_object().data.layers:
        name = layer.name if tools.V3 else layer.info
        found[name] = {
            f.frame_number: (
                len(f.drawing.strokes if tools.V3 else f.strokes), f.keyframe_type
            ) for f in layer.frames
        }  # fmt: skip
    return found


def moving_cube(scene: Any) -> Any:
    cube = tools.cube_scene(scene)
    scene.illustrate.hatching = False
    scene.frame_start, scene.frame_end = 1, 4
    for frame, x in ((1, 0.0), (4, 1.0)):
        cube.location.x = x
        cube.keyframe_insert("location", frame=frame)
    scene.frame_set(2)
    return cube


def test_a_bake_writes_marked_keyframes(scene: Any) -> None:
    moving_cube(scene)
    assert bpy.ops.illustrate.bake() == {"FINISHED"}
    assert scene.frame_current == 2
    [(name, found)] = frames().items()
    assert name == "Crease"
    assert set(found) == {1, 2, 3, 4}
    assert {kind for _, kind in found.values()} == {pencil.BAKED}
    assert all(count for count, _ in found.values())
    strokes = tools.read_pencil(pencil_object())["Crease"]
    assert len({s["points"].tobytes() for s in strokes}) > len(strokes) / 2
    before = tools.read_pencil(pencil_object())
    bpy.ops.illustrate.bake()
    again = tools.read_pencil(pencil_object())
    assert {k: [s["points"].tobytes() for s in v] for k, v in before.items()} == {
        k: [s["points"].tobytes() for s in v] for k, v in again.items()
    }


def test_a_bake_starts_from_the_strokes_of_the_last_frame(scene: Any, monkeypatch: Any) -> None:
    moving_cube(scene)
    ill = native.load()
    assert native.can_seed()
    seeds, start = [], ill.start_draw

    def watched(*arguments: Any, **named: Any) -> Any:
        seeds.append(named.get("previous"))
        return start(*arguments, **named)

    monkeypatch.setattr(ill, "start_draw", watched)
    bpy.ops.illustrate.bake()
    assert seeds[0] is None and all(isinstance(seed, ill.Drawing) for seed in seeds[1:])
    scene.illustrate.keep_strokes = False
    seeds.clear()
    bpy.ops.illustrate.bake()
    assert seeds == [None] * len(seeds)


@pytest.mark.skipif(not tools.V3, reason="strokes of Grease Pencil 2 have no attributes")
def test_strokes_keep_their_numbers_through_a_bake(scene: Any) -> None:
    moving_cube(scene)
    bpy.ops.illustrate.bake()
    [layer] = pencil_object().data.layers
    numbers = [
        {value.value for value in frame.drawing.attributes["stroke_id"].data}
        for frame in layer.frames
    ]
    assert all(len(a & b) > len(b) / 2 for a, b in itertools.pairwise(numbers))
    assert all("stroke_start" in frame.drawing.attributes for frame in layer.frames)


def test_every_second_frame_of_a_range_of_its_own(scene: Any) -> None:
    moving_cube(scene)
    chosen = scene.illustrate
    chosen.use_scene_range, chosen.frame_start, chosen.frame_end = False, 3, 8
    chosen.frame_step = 2
    bpy.ops.illustrate.bake()
    assert set(frames()["Crease"]) == {3, 5, 7}
    chosen.frame_end = 1
    before = tools.snapshot()
    with pytest.raises(RuntimeError, match="set End to 3"):
        bpy.ops.illustrate.bake()
    assert tools.snapshot() == before


def test_a_click_leaves_a_bake_on_other_frames(scene: Any) -> None:
    moving_cube(scene)
    bpy.ops.illustrate.bake()
    bpy.ops.illustrate.illustrate()
    found = frames()["Crease"]
    assert set(found) == {1, 2, 3, 4}
    assert found[2][1] == "KEYFRAME" and found[3][1] == pencil.BAKED
    scene.frame_set(9)
    bpy.ops.illustrate.illustrate()
    assert set(frames()["Crease"]) == {1, 3, 4, 9}
    bpy.ops.illustrate.bake()
    assert set(frames()["Crease"]) == {1, 2, 3, 4, 9}


def test_other_frames_are_kept_when_asked_for(scene: Any) -> None:
    moving_cube(scene)
    scene.illustrate.keep_frames = True
    for frame in (1, 3):
        scene.frame_set(frame)
        bpy.ops.illustrate.illustrate()
    assert set(frames()["Crease"]) == {1, 3}
    scene.illustrate.keep_frames = False
    bpy.ops.illustrate.illustrate()
    assert set(frames()["Crease"]) == {3}


def test_a_layer_without_strokes_ends_at_its_frame(scene: Any) -> None:
    cube = moving_cube(scene)
    scene.illustrate.hatching = True
    cube.illustrate.use_own = True
    for frame, value in ((1, True), (2, True), (3, False)):  # Blender 4.4.0 blends between them
        cube.illustrate.hatching = value
        cube.illustrate.keyframe_insert("hatching", frame=frame)
    bpy.ops.illustrate.bake()
    found = frames()
    hatch = next(name for name in found if name != "Crease")
    assert {n: bool(count) for n, (count, _) in found[hatch].items()} == {
        1: True, 2: True, 3: False,
    }  # fmt: skip
    assert len(found["Crease"]) == 4
    bpy.ops.illustrate.clear()
    assert not [thing for thing in bpy.data.objects if thing.type == tools.pencil_type()]


def test_a_bake_leaves_the_artists_frames(scene: Any, capfd: Any) -> None:
    moving_cube(scene)
    bpy.ops.illustrate.bake()
    layer = pencil_object().data.layers[0]
    layer.frames.new(12)
    tools.add_artists_stroke_at(layer, 3)
    scene.illustrate.use_scene_range = False
    scene.illustrate.frame_end = 12
    before = tools.artists_bytes(layer)
    bpy.ops.illustrate.bake()
    tools.flush()
    assert tools.artists_bytes(layer) == before
    assert frames()["Crease"][3][0] == 1
    assert frames()["Crease"][12] == (0, "KEYFRAME")
    assert 'Left as drawn by hand: "frame 3 of layer "Crease""' in capfd.readouterr().out


def test_curves_cannot_be_baked(scene: Any) -> None:
    moving_cube(scene)
    scene.illustrate.output = "CURVES"
    with pytest.raises(RuntimeError, match="set Output to Grease Pencil"):
        bpy.ops.illustrate.bake()


def test_an_error_in_a_bake_writes_nothing(scene: Any) -> None:
    cube = moving_cube(scene)
    cube.hide_render = False
    cube.keyframe_insert("hide_render", frame=1)
    cube.hide_render = True
    cube.keyframe_insert("hide_render", frame=3)
    scene.frame_set(1)
    before = tools.snapshot()
    with pytest.raises(RuntimeError, match="can be drawn"):
        bpy.ops.illustrate.bake()
    assert tools.snapshot() == before
    assert scene.frame_current == 1


def waited_for(task: Any, step: Any) -> Any:
    """The step after one, which is waited for."""
    jobs.finish(step)
    return jobs.go_on(task, step.job)


def test_a_cancelled_bake_leaves_the_scene(scene: Any) -> None:
    moving_cube(scene)
    scene.frame_set(2, subframe=0.5)
    before = tools.snapshot()
    task = bake.ILLUSTRATE_OT_bake.task(None, bpy.context)
    step = next(task)
    assert step.title == "Frame 1" and step.start == 0
    step = waited_for(task, step)
    assert step.title == "Frame 1" and step.end == 0.25
    step = waited_for(task, step)
    assert step.title == "Frame 2"
    task.close()
    assert tools.snapshot() == before
    assert scene.frame_subframe == 0.5


def test_a_cancelled_drawing_leaves_the_scene(scene: Any) -> None:
    tools.cube_scene(scene)
    before = tools.snapshot()
    task = operators.ILLUSTRATE_OT_illustrate.task(None, bpy.context)
    step = next(task)
    step.job.cancel()
    with contextlib.suppress(native.load().Cancelled):  # it may have been done
        waited_for(task, step)
    task.close()
    assert tools.snapshot() == before


@pytest.mark.parametrize("operator", [operators.ILLUSTRATE_OT_illustrate, bake.ILLUSTRATE_OT_bake])
def test_a_scene_that_goes_while_it_is_drawn(scene: Any, operator: Any) -> None:
    moving_cube(scene)
    task = operator.task(None, bpy.context)
    step = waited_for(task, next(task))
    bpy.data.scenes.new("Other")
    bpy.data.scenes.remove(scene)
    with pytest.raises(IllustrateError, match="is gone"):
        waited_for(task, step)
