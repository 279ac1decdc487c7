"""What a brush moves while Blender evaluates nothing: it is read as it is seen."""

from collections.abc import Iterator
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.viewport import live_view

import tools


@pytest.fixture
def sculpted(scene: Any) -> Iterator[Any]:
    """A sphere that is shaded smooth, in sculpt mode."""
    tools.add_camera(scene)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=12, ring_count=8)
    sphere = bpy.context.object
    tools.shade_smooth(sphere, [True] * len(sphere.data.polygons))
    bpy.ops.object.mode_set(mode="SCULPT")
    yield sphere
    bpy.ops.object.mode_set(mode="OBJECT")


def brush(thing: Any) -> None:
    """Moves the upper half as a brush does: Blender is told nothing."""
    positions = np.zeros((len(thing.data.vertices), 3), np.float32)
    thing.data.vertices.foreach_get("co", positions.ravel())
    positions[positions[:, 2] > 0.1] += (0.3, 0, 0.5)
    held = thing.data.attributes.get("position")
    elements, name = (held.data, "vector") if held else (thing.data.vertices, "co")
    elements.foreach_set(name, positions.ravel())


def read_top(scene: Any) -> float:
    return float(tools.read(scene).meshes[0].positions[:, 2].max())


def test_the_mesh_under_the_brush_is_read(scene: Any, sculpted: Any) -> None:
    before = tools.read(scene).meshes[0]
    brush(sculpted)
    after = tools.read(scene).meshes[0]
    assert after.positions[:, 2].max() == pytest.approx(before.positions[:, 2].max() + 0.5)
    bpy.ops.object.mode_set(mode="OBJECT")
    sculpted.data.update()
    bpy.context.view_layer.update()
    left = tools.read(scene).meshes[0]
    assert np.array_equal(left.positions, after.positions)
    assert np.abs(left.corner_normals - after.corner_normals).max() < 1e-5
    assert np.abs(after.corner_normals - before.corner_normals).max() > 0.1


@pytest.mark.parametrize("form", ["AUTO", "MESH"])
def test_a_subdivision_without_levels_changes_nothing(scene: Any, sculpted: Any, form: str) -> None:
    tools.subdivide(sculpted, levels=0)
    sculpted.illustrate.use_own, sculpted.illustrate.form = True, form
    bpy.context.view_layer.update()
    before = read_top(scene)
    brush(sculpted)
    assert read_top(scene) == pytest.approx(before + 0.5)


def test_modifiers_are_evaluated_as_ever(scene: Any, sculpted: Any) -> None:
    sculpted.modifiers.new("Array", "ARRAY")
    bpy.context.view_layer.update()
    assert len(tools.read(scene).meshes[0].positions) > len(sculpted.data.vertices)


def test_the_live_drawing_notices_the_brush(scene: Any, sculpted: Any) -> None:
    before = live_view._what_is_seen(scene)
    assert live_view._what_is_seen(scene) == before
    brush(sculpted)
    assert live_view._what_is_seen(scene) != before
