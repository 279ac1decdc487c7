"""An empty scene, and one click."""

from typing import Any

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from illustrate.running import first_use
from mathutils import Euler, Vector

import tools


def frame_places(scene: Any) -> Any:
    """(n, 2) where the corners of everything are in the frame, 0 .. 1."""
    corners = [
        thing.matrix_world @ Vector(corner)
        for thing in scene.objects
        if thing.type == "MESH"
        for corner in thing.bound_box
    ]
    return np.array([world_to_camera_view(scene, scene.camera, corner)[:] for corner in corners])


def test_an_empty_scene_can_be_drawn_after_one_click(scene: Any) -> None:
    assert first_use.missing(scene, bpy.context.view_layer) == ["an object", "a camera", "a light"]
    assert not bpy.ops.illustrate.illustrate.poll()
    assert bpy.ops.illustrate.set_up() == {"FINISHED"}
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    assert {thing.type for thing in scene.objects} >= {"MESH", "CAMERA", "LIGHT"}
    assert not bpy.ops.illustrate.set_up.poll()


@pytest.mark.parametrize("size", [0.001, 1.0, 4000.0])
def test_the_camera_sees_everything(scene: Any, size: float) -> None:
    for place in ((0, 0, 0), (3 * size, size, 0)):
        tools.add_cube("Box", place).scale = (size, 2 * size, size)
    bpy.context.view_layer.update()
    first_use.make_missing(scene, bpy.context.view_layer)
    places = frame_places(scene)
    assert (places[:, :2] > 0).all() and (places[:, :2] < 1).all() and (places[:, 2] > 0).all()
    assert np.ptp(places[:, :2], axis=0).max() > 0.6
    assert places[:, 2].max() < scene.camera.data.clip_end


def test_the_camera_looks_as_the_viewport_does(scene: Any) -> None:
    tools.add_cube()
    turn = Euler((1.1, 0.0, 0.7)).to_matrix()
    first_use.make_missing(scene, bpy.context.view_layer, turn.inverted().to_4x4())
    made = scene.camera.matrix_world.to_3x3()
    assert np.allclose(made, turn, atol=1e-5)


def test_only_what_is_missing_is_made(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    camera = scene.camera
    assert first_use.missing(scene, bpy.context.view_layer) == []
    scene.illustrate.source = "SELECTION"
    cube.select_set(False)
    assert first_use.missing(scene, bpy.context.view_layer) == ["a selection"]
    bpy.ops.illustrate.set_up()
    assert cube.select_get() and scene.camera == camera and len(scene.objects) == 3


def test_reset_gives_the_defaults_back(scene: Any) -> None:
    chosen = scene.illustrate
    chosen.spacing_px, chosen.hidden, chosen.line_color = 30, True, (1, 0, 0, 1)
    chosen.source = "SELECTION"
    bpy.ops.illustrate.reset()
    assert (chosen.spacing_px, chosen.hidden, tuple(chosen.line_color)) == (8, False, (0, 0, 0, 1))
    assert chosen.source == "SELECTION"
