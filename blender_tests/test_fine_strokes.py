"""Strokes of Grease Pencil that paper shows as ribbons: which, and that they are what was drawn."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.output import PENCIL_API, pencil
from illustrate.viewport import fine_strokes
from mathutils import Matrix

import tools

pytestmark = pytest.mark.skipif(
    not fine_strokes.IS_NEEDED, reason="before Blender 5.0 it draws thin strokes well itself"
)


@pytest.fixture
def illustration(scene: Any) -> Any:
    """Of a cube."""
    tools.cube_scene(scene)
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    return pencil.find(scene, PENCIL_API)


def can_show() -> bool:
    bpy.context.view_layer.update()
    return bool(fine_strokes.can_show(bpy.context.view_layer))


def drawing_of(thing: Any) -> Any:
    return thing.data.layers[0].current_frame().drawing


def colour_a_point(thing: Any) -> None:
    attribute = drawing_of(thing).attributes.new("vertex_color", "FLOAT_COLOR", "POINT")
    attribute.data[0].color = (1, 0, 0, 1)


def fill_a_stroke(thing: Any) -> None:
    drawing_of(thing).attributes.new("fill_id", "INT", "CURVE").data[0].value = 1


def fill_all(thing: Any) -> None:
    thing.data.materials[0].grease_pencil.show_fill = True


def tint(thing: Any) -> None:
    thing.modifiers.new("Tint", "GREASE_PENCIL_TINT")


def texture(thing: Any) -> None:
    thing.data.materials[0].grease_pencil.stroke_style = "TEXTURE"


def mask(thing: Any) -> None:
    thing.data.layers[0].use_masks = True


def move_a_layer(thing: Any) -> None:
    thing.data.layers[0].translation = (0, 0, 1)


def blur(thing: Any) -> None:
    thing.shader_effects.new("Blur", "FX_BLUR")


def edit(thing: Any) -> None:
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")


CHANGES = [colour_a_point, fill_a_stroke, fill_all, tint, texture, mask, move_a_layer, blur, edit]


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.__name__)
def test_what_ribbons_lack_blender_draws(illustration: Any, change: Callable[[Any], None]) -> None:
    assert can_show()
    change(illustration)
    assert not can_show()
    if illustration.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
        assert can_show()


def test_what_is_hidden_does_not_count(illustration: Any) -> None:
    fill_all(illustration)
    assert not can_show()
    illustration.hide_set(True)
    assert can_show()


def test_they_are_the_strokes_of_the_layers(illustration: Any) -> None:
    illustration.matrix_world = Matrix.Scale(2.0, 4)
    bpy.context.view_layer.update()
    thing = illustration.evaluated_get(bpy.context.evaluated_depsgraph_get())
    found = list(fine_strokes._strokes_of(thing))
    drawn = [strokes for strokes in tools.read_pencil(illustration).values() if strokes]
    assert len(found) == len(drawn) > 1
    for (points, diameters, sizes, closed, colours), strokes in zip(found, drawn, strict=True):
        np.testing.assert_allclose(points, 2 * np.concatenate([s["points"] for s in strokes]), 1e-5)
        radii = np.concatenate([s["radii"] for s in strokes])
        np.testing.assert_allclose(diameters, 4 * radii, rtol=1e-5)
        assert list(sizes) == [len(s["points"]) for s in strokes]
        assert list(closed) == [s["closed"] for s in strokes]
        assert (colours[:, 3] == 1).all()


def test_hidden_materials_have_no_ink(illustration: Any) -> None:
    for material in illustration.data.materials:
        material.grease_pencil.hide = True
    for *_, colours in fine_strokes._strokes_of(illustration):
        assert len(colours) and (colours[:, 3] == 0).all()


def test_what_is_behind_the_eye_is_left_out(illustration: Any) -> None:
    region = SimpleNamespace(width=200, height=100)
    places = {"window_matrix": np.eye(4), "perspective_matrix": -np.eye(4)}
    eye = SimpleNamespace(region=region, region_data=SimpleNamespace(**places))
    strokes = next(fine_strokes._strokes_of(illustration))
    assert not len(fine_strokes._in_region(strokes, eye).triangles)
    places["perspective_matrix"] = np.eye(4)
    eye.region_data = SimpleNamespace(**places)
    assert len(fine_strokes._in_region(strokes, eye).triangles)


def test_hidden_layers_have_none(illustration: Any) -> None:
    before = list(fine_strokes._strokes_of(illustration))
    illustration.data.layers[0].hide = True
    assert len(list(fine_strokes._strokes_of(illustration))) == len(before) - 1
