"""Guides that are read from a collection, and the field shown as an object."""

import math
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.reading.scene import read_scene
from illustrate.running.illustration import prepare_scene
from illustrate.settings import guides
from illustrate.ui import style_panel

import tools

TILT = math.radians(20)


def depsgraph() -> Any:
    return bpy.context.evaluated_depsgraph_get()


def guide_collection(scene: Any) -> Any:
    collection = bpy.data.collections.new("Guides")
    scene.collection.children.link(collection)
    scene.illustrate.guides = collection
    return collection


def add_curve(collection: Any, kind: str, points: Any, closed: bool = False) -> Any:
    data = bpy.data.curves.new("Guide", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new(kind)
    if kind == "BEZIER":
        spline.bezier_points.add(len(points) - 1)
        for point, place in zip(spline.bezier_points, points, strict=True):
            point.co = place
            point.handle_left_type = point.handle_right_type = "VECTOR"
    else:
        spline.points.add(len(points) - 1)
        for point, place in zip(spline.points, points, strict=True):
            point.co = (*place, 1)
    spline.use_cyclic_u = closed
    thing = bpy.data.objects.new("Guide", data)
    collection.objects.link(thing)
    return thing


def add_pencil(collection: Any, points: Any, closed: bool = False) -> Any:
    if tools.V3:
        store = getattr(bpy.data, "grease_pencils_v3", bpy.data.grease_pencils)
    else:
        store = bpy.data.grease_pencils
    data = store.new("Guide")
    frame = data.layers.new("Strokes").frames.new(1)
    if tools.V3:
        frame.drawing.add_strokes([len(points)])
        stroke = frame.drawing.strokes[0]
        stroke.cyclic = closed
        for point, place in zip(stroke.points, points, strict=True):
            point.position = place
    else:
        stroke = frame.strokes.new()
        stroke.points.add(len(points))
        stroke.use_cyclic = closed
        for point, place in zip(stroke.points, points, strict=True):
            point.co = place
    thing = bpy.data.objects.new("Guide", data)
    collection.objects.link(thing)
    return thing


def guides_of(scene: Any) -> list[Any]:
    return list(read_scene(scene, depsgraph(), guides=scene.illustrate.guides).guides.strokes)


CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]


@pytest.mark.parametrize("kind", ["POLY", "BEZIER", "PENCIL"])
@pytest.mark.parametrize("closed", [False, True])
def test_strokes_are_read_in_world_space(scene: Any, kind: str, closed: bool) -> None:
    tools.cube_scene(scene)
    collection = guide_collection(scene)
    if kind == "PENCIL":
        thing = add_pencil(collection, CORNERS, closed)
    else:
        thing = add_curve(collection, kind, CORNERS, closed)
        thing.data.bevel_depth = 0.1  # as a spline it has no thickness
    thing.location = (2, 0, 0)
    thing.scale = (1, 2, 1)
    bpy.context.view_layer.update()
    before = tools.snapshot()
    (guide,) = guides_of(scene)
    assert tools.snapshot() == before
    expected = [(2, 0, 0), (3, 0, 0), (3, 2, 0)]
    length = 1 + 2 + (math.sqrt(5) if closed else 0)
    assert guide[0] == pytest.approx(expected[0], abs=1e-5)
    assert guide[-1] == pytest.approx(expected[0 if closed else 2], abs=1e-5)
    assert np.linalg.norm(np.diff(guide, axis=0), axis=1).sum() == pytest.approx(length, rel=1e-3)
    for corner in expected:
        assert np.linalg.norm(guide - corner, axis=1).min() < 1e-5


@pytest.mark.skipif(bpy.app.version < (4, 2, 0), reason="scripts cannot make hair curves before")
def test_hair_curves_are_read_in_world_space(scene: Any) -> None:
    tools.cube_scene(scene)
    fur = bpy.data.hair_curves.new("Fur")
    fur.add_curves([3, 2, 1])
    flat = np.arange(18, dtype=np.float32)
    fur.attributes["position"].data.foreach_set("vector", flat)
    thing = bpy.data.objects.new("Fur", fur)
    thing.scale = (1, 2, 1)
    guide_collection(scene).objects.link(thing)
    bpy.context.view_layer.update()
    expected = flat.reshape(-1, 3) * (1, 2, 1)
    long, short = guides_of(scene)  # one point has no direction
    assert long == pytest.approx(expected[:3])
    assert short == pytest.approx(expected[3:5])


def test_guides_are_not_drawn_and_child_collections_count(scene: Any) -> None:
    tools.cube_scene(scene)
    collection = guide_collection(scene)
    child = bpy.data.collections.new("More")
    collection.children.link(child)
    add_curve(collection, "POLY", CORNERS).data.bevel_depth = 0.1
    add_curve(child, "POLY", CORNERS).hide_viewport = True
    add_pencil(child, CORNERS)
    arrays = read_scene(scene, depsgraph(), guides=collection)
    assert [mesh.name for mesh in arrays.meshes] == ["Box"]
    assert len(arrays.guides.strokes) == 3


def test_drawings_of_the_frame_in_force_are_read(scene: Any) -> None:
    tools.cube_scene(scene)
    add_pencil(guide_collection(scene), CORNERS)
    scene.frame_set(7)
    assert len(guides_of(scene)) == 1
    scene.frame_set(0)
    assert not guides_of(scene)


def test_hidden_layers_guide_nothing(scene: Any) -> None:
    tools.cube_scene(scene)
    pencil = add_pencil(guide_collection(scene), CORNERS)
    pencil.data.layers[0].hide = True
    assert not guides_of(scene)


def test_a_collection_without_strokes_is_warned_of(scene: Any, capfd: Any) -> None:
    tools.cube_scene(scene)
    guide_collection(scene)
    bpy.ops.illustrate.illustrate()
    tools.flush()
    assert 'Collection "Guides" guides nothing' in capfd.readouterr().out


def off_tilt(scene: Any) -> float:
    """Degrees between the field on top of the cube, near the x axis, and a line turned by TILT."""
    prepared = prepare_scene(scene, depsgraph())
    positions = np.asarray(prepared.surface.positions)
    on_line = np.abs(positions @ (-math.sin(TILT), math.cos(TILT), 0)) < 0.02
    chosen = (positions[:, 2] > 0.99) & on_line & (np.abs(positions[:, 0]) < 0.5)
    assert chosen.any()
    x, y = np.asarray(prepared.field.directions)[chosen, :2].T
    turn = np.degrees(np.arctan2(y, x) - TILT)
    off: float = np.abs((turn + 45) % 90 - 45).max()
    return off


def grid_scene(scene: Any) -> None:
    """A flat square at height 1, of many faces: Blender's own grid."""
    tools.add_camera(scene)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=40, y_subdivisions=40, location=(0, 0, 1))


@pytest.mark.parametrize("kind", ["POLY", "PENCIL"])
def test_hatches_follow_guides(scene: Any, kind: str) -> None:
    grid_scene(scene)
    assert off_tilt(scene) == pytest.approx(20, abs=1)
    collection = guide_collection(scene)
    ends = [(s * 0.6 * math.cos(TILT), s * 0.6 * math.sin(TILT), 1.02) for s in (-1, 1)]
    add: Any = add_pencil if kind == "PENCIL" else lambda c, p: add_curve(c, "POLY", p)
    guide = add(collection, ends)
    assert off_tilt(scene) < 3
    guide.illustrate_guide.weight = 0
    assert off_tilt(scene) == pytest.approx(20, abs=1)
    guide.illustrate_guide.weight = 1
    scene.illustrate.guide_weight = 0
    assert off_tilt(scene) == pytest.approx(20, abs=1)


def add_empty(collection: Any, place: Any, turns: int) -> Any:
    empty = bpy.data.objects.new("Turn", None)
    empty.location = place
    empty.illustrate_guide.turns = turns
    collection.objects.link(empty)
    return empty


def test_hatches_turn_round_empties(scene: Any) -> None:
    tools.add_camera(scene)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16)
    bpy.ops.object.shade_smooth()
    collection = guide_collection(scene)
    poles = [add_empty(collection, (0, 0, z), 4) for z in (-1, 1)]
    add_empty(collection, (1, 0, 0), 0)  # says nothing
    bpy.context.view_layer.update()
    found = prepare_scene(scene, depsgraph()).field
    assert sorted(found.singular_indices) == [1] * 8
    assert np.abs(np.asarray(found.singular_positions)[:, 2]).min() > 0.9
    before = tools.snapshot()
    poles[0].illustrate_guide.turns = 3
    with pytest.raises(RuntimeError, match=r"4 chi.*Change the Turns of the empties"):
        bpy.ops.illustrate.illustrate()
    assert tools.snapshot() == before


def test_guides_have_a_panel(scene: Any) -> None:
    cube, collection = tools.cube_scene(scene), guide_collection(scene)
    panel = style_panel.ILLUSTRATE_PT_guide
    for thing, name in (
        (cube, ""),
        (add_curve(collection, "POLY", CORNERS), "weight"),
        (add_empty(collection, (0, 0, 1), 1), "turns"),
    ):
        assert panel.poll(SimpleNamespace(object=thing, scene=scene)) == bool(name)
        assert guides.shown_of(thing) == name


def shown(scene: Any) -> Any:
    return scene.objects.get("Illustration Field")


def test_the_field_is_shown_and_hidden(scene: Any) -> None:
    tools.add_camera(scene)
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4)
    bpy.context.object.data.polygons.foreach_set("use_smooth", [True] * 1280)
    before = tools.snapshot()
    assert bpy.ops.illustrate.show_field() == {"FINISHED"}
    field = shown(scene)
    assert field.hide_render and field["illustrate_owner"]
    points = np.array([v.co for v in field.data.vertices])
    arms = np.array(sorted(sorted(e.vertices) for e in field.data.edges if e.is_loose))
    assert len(arms) > 400
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 0.1
    first, second = (np.diff(points[arms[k::2]], axis=1)[:, 0] for k in (0, 1))
    assert np.abs((first * second).sum(1)).max() < 1e-4
    assert len(field.data.polygons) == 8 * 8  # an octahedron for each singularity of a sphere
    inks = [field.data.materials[p.material_index].name for p in field.data.polygons]
    assert inks == ["Illustration Field Plus"] * 64
    bpy.ops.illustrate.show_field()
    assert [t.name for t in scene.objects if t.name.startswith("Illustration")] == [field.name]
    assert bpy.ops.illustrate.hide_field() == {"FINISHED"}
    assert tools.snapshot() == before
    assert not bpy.ops.illustrate.hide_field.poll()


def test_the_shown_field_is_not_drawn(scene: Any) -> None:
    tools.cube_scene(scene)
    bpy.ops.illustrate.show_field()
    assert [mesh.name for mesh in read_scene(scene, depsgraph()).meshes] == ["Box"]
    scene.illustrate.output = "CURVES"
    bpy.ops.illustrate.illustrate()
    assert shown(scene) is not None
    inks = {t.data.materials[0].name for t in scene.objects if t.type == "CURVE"}
    assert "Illustration Feature Ink" in inks
    assert not any(name.startswith("Illustration Field") for name in inks)


def test_an_error_leaves_no_field(scene: Any) -> None:
    tools.add_camera(scene)
    bpy.context.view_layer.update()
    before = tools.snapshot()
    with pytest.raises(RuntimeError, match="add a mesh"):
        bpy.ops.illustrate.show_field()
    assert tools.snapshot() == before
