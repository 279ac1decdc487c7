"""All that a Grease Pencil object holds, read back as Blender keeps it, now and from a file."""

from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.output import bake_drawings, sheet_of, write_drawing
from illustrate.running import illustration

import tools

SIZES = {"FLOAT_VECTOR": ("vector", 3), "FLOAT_COLOR": ("color", 4), "FLOAT2": ("vector", 2)}
KINDS = {"INT", "INT8", "BOOLEAN", "FLOAT", *SIZES}
OURS = {"illustrate_kind", "illustrate_object", "illustrate_invisibility"}

pytestmark = pytest.mark.skipif(not tools.V3, reason="Grease Pencil 2 has no attributes")


def values(attribute: Any) -> list[Any]:
    field, columns = SIZES.get(attribute.data_type, ("value", 1))
    kind = {"INT": np.int32, "INT8": np.int32, "BOOLEAN": bool}.get(attribute.data_type, np.float32)
    found = np.zeros(len(attribute.data) * columns, kind)
    attribute.data.foreach_get(field, found)
    return list(found.tolist())


def held(data: Any) -> dict[str, Any]:
    """Layers with their groups and keyframes, and every attribute of every drawing."""
    return {
        layer.name: (
            layer.parent_group.name if layer.parent_group else None,
            layer.use_lights,
            [
                (
                    frame.frame_number,
                    frame.keyframe_type,
                    [len(stroke.points) for stroke in frame.drawing.strokes],
                    {a.name: values(a) for a in frame.drawing.attributes if a.data_type in KINDS},
                )
                for frame in layer.frames
            ],
        )
        for layer in data.layers
    }


def made(scene: Any, **settings: Any) -> Any:
    for name, value in settings.items():
        setattr(scene.illustrate, name, value)
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


def test_a_file_keeps_strokes_attributes_keyframes_and_layers(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    tools.add_cube("Other", (2.5, 0, 0))
    result = made(scene)
    thing = write_drawing(scene, result.drawing, result.arrays.camera, "GREASE_PENCIL")[0]
    sheets = [sheet_of(result.drawing, result.arrays.camera, n, result.names) for n in (5, 7)]
    assert bake_drawings(scene, sheets) == []
    before = held(thing.data)
    numbers = {number for _, _, frames in before.values() for number, *_ in frames}
    assert numbers == {1, 5, 7} and {group for group, *_ in before.values()} == {"Illustration"}
    for _, lit, frames in before.values():
        assert not lit
        for _, _, sizes, attributes in frames:
            assert OURS | {"position", "radius", "cyclic", "material_index"} <= attributes.keys()
            assert len(attributes["position"]) == 3 * sum(sizes)
            assert len(attributes["illustrate_kind"]) == len(sizes)
            assert min(attributes["radius"]) >= 0 < max(attributes["radius"])
    path = str(tmp_path / "held.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    tools.new_file()
    bpy.ops.wm.open_mainfile(filepath=path)
    again = next(o for o in bpy.context.scene.objects if o.type == tools.pencil_type())
    assert held(again.data) == before
    assert [material.name for material in again.data.materials]


def test_radii_are_half_the_widths_in_the_world(scene: Any) -> None:
    tools.cube_scene(scene)
    result = made(scene, hatching=False)
    thing = write_drawing(scene, result.drawing, result.arrays.camera, "GREASE_PENCIL")[0]
    radii = [
        radius
        for _, _, frames in held(thing.data).values()
        for _, _, _, attributes in frames
        for radius in attributes["radius"]
    ]
    points = np.asarray(result.drawing.points)
    widths = result.drawing.widths * result.arrays.camera.pixel_size(points)
    assert np.sort(radii) == pytest.approx(np.sort(widths) / 2, rel=1e-5)
