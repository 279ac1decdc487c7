"""What a render makes of objects, collections and materials besides showing them."""

from typing import Any

import bpy
import numpy as np
import pytest

import tools
from tools import read


def read_styles(scene: Any) -> dict[str, dict[str, Any]]:
    arrays = read(scene)
    return {mesh.name: style for mesh, style in zip(arrays.meshes, arrays.styles, strict=True)}


def layer_of(scene: Any, thing: Any) -> Any:
    """A new collection's layer that the object alone is in."""
    inner = bpy.data.collections.new("Inner")
    scene.collection.children.link(inner)
    inner.objects.link(thing)
    scene.collection.objects.unlink(thing)
    return bpy.context.view_layer.layer_collection.children["Inner"]


@pytest.fixture
def boxes(scene: Any) -> Any:
    """A cube that is seen, and one to be told about."""
    tools.cube_scene(scene)
    box = tools.add_cube("Other", (0, 0, 3))
    if box.users_collection[0] != scene.collection:
        scene.collection.objects.link(box)
        box.users_collection[0].objects.unlink(box)
    return box


def test_what_visibility_says(scene: Any, boxes: Any) -> None:
    assert read_styles(scene) == {"Box": {}, "Other": {}}
    for name, value, style in (
        ("visible_camera", False, "shadow_only"),
        ("is_holdout", True, "occlude_only"),
        ("is_shadow_catcher", True, "shadow_catcher"),
    ):
        setattr(boxes, name, value)
        assert read_styles(scene) == {"Box": {}, "Other": {style: True}}
        setattr(boxes, name, not value)
    boxes.visible_camera = boxes.visible_shadow = False
    assert read_styles(scene) == {"Box": {}}


def test_what_collections_say(scene: Any, boxes: Any) -> None:
    layer = layer_of(scene, boxes)
    layer.indirect_only = True
    assert read_styles(scene)["Other"] == {"shadow_only": True}
    layer.indirect_only, layer.holdout = False, True
    assert read_styles(scene)["Other"] == {"occlude_only": True}


@pytest.mark.parametrize("shown_as", ["WIRE", "BOUNDS"])
def test_what_the_viewport_shows_coarsely_is_rendered(
    scene: Any, boxes: Any, shown_as: str
) -> None:
    boxes.display_type = shown_as
    assert read_styles(scene) == {"Box": {}, "Other": {}}


def test_such_scenes_are_drawn(boxes: Any) -> None:
    for name in ("visible_camera", "is_holdout", "is_shadow_catcher"):
        boxes.visible_camera, boxes.is_holdout, boxes.is_shadow_catcher = True, False, False
        setattr(boxes, name, name != "visible_camera")
        assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def materials(thing: Any, count: int) -> list[Any]:
    """New ones in the slots of a cube, one after another on its faces."""
    made = [bpy.data.materials.new(f"Paint {i}") for i in range(count)]
    for material in made:
        thing.data.materials.append(material)
    for i, face in enumerate(thing.data.polygons):
        face.material_index = i % count
    return made


def test_a_material_on_all_of_an_object_is_its_style(scene: Any, boxes: Any) -> None:
    (paint,) = materials(boxes, 1)
    own = paint.illustrate_material
    own.lines, own.spacing_scale, own.width_scale = False, 2, 3
    assert read_styles(scene)["Other"] == {}
    own.use_own = True
    assert read_styles(scene)["Other"] == {
        "lines": False, "hatching": True, "spacing_scale": 2, "width_scale": 3,
    }  # fmt: skip
    boxes.illustrate.use_own, boxes.illustrate.width_scale = True, 0.5
    boxes.illustrate.hatching = False
    style = read_styles(scene)["Other"]
    assert (style["width_scale"], style["hatching"], style["lines"]) == (1.5, False, False)
    own.ignore = True
    assert "Other" not in read_styles(scene)


def test_a_material_on_some_faces_is_told_apart(scene: Any, boxes: Any) -> None:
    plain, paint = materials(boxes, 2)
    paint.illustrate_material.use_own = True
    paint.illustrate_material.hatching = False
    paint.illustrate_material.spacing_scale = 2
    style = read_styles(scene)["Other"]
    default = {
        "lines": True, "hatching": True, "spacing_scale": 1.0, "width_scale": 1.0, "pen": 0,
    }  # fmt: skip
    assert style["materials"] == [default, {**default, "hatching": False, "spacing_scale": 2.0}]
    paint.illustrate_material.own_pen = True
    assert [m["pen"] for m in read_styles(scene)["Other"]["materials"]] == [0, 2]
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    plain.illustrate_material.use_own = True
    plain.illustrate_material.ignore = True
    arrays = read(scene)
    (box,) = [mesh for mesh in arrays.meshes if mesh.name == "Other"]
    assert np.array_equal(box.hole_faces, [0, 2, 4])
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def test_faces_of_an_ignored_material_below_a_subdivision(scene: Any, boxes: Any) -> None:
    tools.subdivide(boxes, levels=1)
    materials(boxes, 2)[0].illustrate_material.use_own = True
    boxes.data.materials[0].illustrate_material.ignore = True
    (box,) = [mesh for mesh in read(scene).meshes if mesh.name == "Other"]
    assert len(box.face_sizes) == 6 and len(box.hole_faces) == 3
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
