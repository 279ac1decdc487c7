"""Materials that an image cuts out are drawn with the outline of what it shows."""

import math
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.reading.alpha import reader
from illustrate.reading.alpha.looks import ALPHA, COLOUR, alpha_look
from illustrate.reading.kept_images import IMAGES
from illustrate.running import illustration
from test_alpha_cut import disc
from test_lightness import board, material, missing_image, wrongly_packed_image

import tools
from tools import read

RADIUS_PX = 0.3 * 2 * 200 / 2.5  # of the disc on the board, which is two units wide


def painted(alpha: Any, grey: float = 0.8, name: str = "Leaf") -> Any:
    """An image of one grey with this alpha."""
    image = bpy.data.images.new(name, alpha.shape[1], alpha.shape[0], alpha=True)
    pixels = np.dstack([np.full((*alpha.shape, 3), grey), alpha])
    image.pixels.foreach_set(pixels.astype(np.float32).ravel())
    return image


def cut_out(image: Any, output: str = "Alpha") -> tuple[Any, Any]:
    """A material with the alpha of an image, and the node of the image."""
    made, shader = material()
    node = made.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    made.node_tree.links.new(node.outputs[output], shader.inputs["Alpha"])
    return made, node


def leaf() -> Any:
    """A material with a disc for its alpha."""
    return cut_out(painted(disc(128)))[0]


def drawn(scene: Any) -> Any:
    scene.illustrate.hatching = False
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


def points(made: Any) -> Any:
    """(n, 2) pixels of all strokes from the middle of the picture."""
    return np.asarray(made.drawing.points)[:, :2] * 200 / 2.5


def test_a_disc_on_a_card_is_drawn_as_a_circle(scene: Any) -> None:
    board(scene, leaf())
    made = drawn(scene)
    radii = np.linalg.norm(points(made), axis=1)
    assert np.abs(radii - RADIUS_PX).max() < 1
    angles = np.sort(np.arctan2(*points(made).T))
    assert np.diff(angles).max() < math.radians(20) and not made.warnings


def test_without_the_setting_it_is_a_square(scene: Any) -> None:
    board(scene, leaf())
    scene.illustrate.cut_by_alpha = False
    made = drawn(scene)
    assert np.abs(np.abs(points(made)).max(axis=1) - 80).max() < 1 and not made.warnings


def test_what_lies_behind_is_seen_where_nothing_is(scene: Any) -> None:
    board(scene, leaf())
    bar = [(-0.9, -0.05, -1), (0.9, -0.05, -1), (0.9, 0.05, -1), (-0.9, 0.05, -1)]
    tools.add_mesh("Bar", bar, [(0, 1, 2, 3)])
    seen = points(drawn(scene))
    on_bar = seen[np.abs(np.linalg.norm(seen, axis=1) - RADIUS_PX) > 1]
    assert len(on_bar) and np.abs(on_bar[:, 1]).max() < 5
    assert np.abs(on_bar[:, 0]).min() > RADIUS_PX - 2 and np.abs(on_bar[:, 0]).max() > 70


def test_parts_that_are_not_cut_stay_smooth_surfaces(scene: Any) -> None:
    thing = board(scene, leaf())
    bpy.ops.mesh.primitive_uv_sphere_add(location=(0, 0, -2))
    ball = bpy.context.object
    ball.data.materials.append(bpy.data.materials.new("Bark"))
    for one in (thing, ball):
        one.select_set(True)
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.join()
    cut, rest = read(scene).meshes
    assert cut.scheme == "none" and rest.scheme is None
    assert len(rest.face_sizes) == 512 and cut.name == rest.name == thing.name


def test_a_cage_of_leaves_is_read_as_its_modifier_leaves_it(scene: Any) -> None:
    tools.subdivide(board(scene, leaf()), levels=2)
    (mesh,) = read(scene).meshes
    assert not mesh.cage and mesh.scheme == "none" and len(mesh.face_sizes) > 16
    scene.illustrate.cut_by_alpha = False
    assert read(scene).meshes[0].scheme == "catmull-clark"


def test_an_object_of_which_nothing_is_left_is_not_there(scene: Any) -> None:
    board(scene, cut_out(painted(np.zeros((8, 8))))[0])
    tools.add_cube("Box", (0, 0, -3))
    arrays = read(scene)
    assert [mesh.name for mesh in arrays.meshes] == ["Box"] and not arrays.left_out


def test_instances_are_cut_once_and_shared(scene: Any, monkeypatch: Any) -> None:
    thing = board(scene, leaf())
    for x in (1, 2):
        copy = thing.copy()
        copy.location.x = x
        scene.collection.objects.link(copy)
    counted = counting(monkeypatch)
    arrays = read(scene)
    assert len(arrays.meshes) == 3 and len(counted) == 1
    drawn(scene)


def counting(monkeypatch: Any) -> list[int]:
    """Gets an entry for each mesh that is cut, from now on."""
    counted: list[int] = []
    plain = reader.cut_parts

    def watched(*arguments: Any) -> Any:
        counted.append(1)
        return plain(*arguments)

    monkeypatch.setattr(reader, "cut_parts", watched)
    reader.CUTS.begin()
    reader.CUTS.begin()
    return counted


def test_it_is_cut_again_when_image_map_or_mesh_change(scene: Any, monkeypatch: Any) -> None:
    made, node = cut_out(painted(disc(64)))
    thing = board(scene, made)
    counted = counting(monkeypatch)

    def cuts() -> int:
        counted.clear()
        bpy.context.view_layer.update()
        read(scene)
        return len(counted)

    assert [cuts(), cuts()] == [1, 0]
    thing.location.x += 1
    assert cuts() == 0
    thing.data.uv_layers[0].data[0].uv = (0.1, 0.1)
    assert [cuts(), cuts()] == [1, 0]
    thing.data.vertices[0].co.z = 1
    thing.data.update()
    assert [cuts(), cuts()] == [1, 0]
    node.image.pixels[3 + 4 * 64 * 32] = 0.6
    assert [cuts(), cuts()] == [1, 0]
    node.extension = "CLIP"
    assert [cuts(), cuts()] == [1, 0]


# --- Materials ----------------------------------------------------------------------------------


def test_a_mix_with_a_transparent_shader_is_followed_both_ways() -> None:
    for clear, is_below in ((1, False), (2, True)):
        made, shader = material()
        nodes, links = made.node_tree.nodes, made.node_tree.links
        mix, node = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeTexImage")
        node.image = painted(disc(16))
        links.new(node.outputs["Color"], mix.inputs[0])
        links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], mix.inputs[clear])
        links.new(shader.outputs[0], mix.inputs[3 - clear])
        output = next(n for n in nodes if n.type == "OUTPUT_MATERIAL")
        links.new(mix.outputs[0], output.inputs["Surface"])
        look = alpha_look(made)
        assert (look.channel, look.threshold, look.is_below) == (COLOUR, 0.5, is_below)


def through(kind: str, **settings: Any) -> Any:
    """What is followed of an image through a node; `second`: the value of its second input."""
    made, image = cut_out(painted(disc(16)))
    links, shader = made.node_tree.links, image.outputs["Alpha"].links[0].to_node
    node = made.node_tree.nodes.new(kind)
    linked = settings.pop("linked", 0)
    for name, value in settings.items():
        if name == "constant":
            node.inputs[1 - linked].default_value = value
        else:
            setattr(node, name, value)
    links.new(image.outputs["Alpha"], node.inputs[linked])
    links.new(node.outputs[0], shader.inputs["Alpha"])
    return alpha_look(made)


@pytest.mark.parametrize(
    ("settings", "threshold", "is_below"),
    [
        ({"operation": "GREATER_THAN", "constant": 0.3}, 0.3, False),
        ({"operation": "LESS_THAN", "constant": 0.3}, 0.3, True),
        ({"operation": "GREATER_THAN", "constant": 0.3, "linked": 1}, 0.3, True),
        ({"operation": "SUBTRACT", "constant": 1.0, "linked": 1}, 0.5, True),
        ({"operation": "MULTIPLY", "constant": 2.0}, 0.25, False),
        ({"operation": "ROUND"}, 0.5, False),
    ],
)
def test_comparisons_are_followed(settings: Any, threshold: float, is_below: bool) -> None:
    look = through("ShaderNodeMath", **settings)
    assert (look.threshold, look.is_below) == (pytest.approx(threshold), is_below)


def test_ramps_of_two_colours_are_followed() -> None:
    look = through("ShaderNodeValToRGB")
    assert (look.threshold, look.is_below) == (pytest.approx(0.5), False)
    assert through("ShaderNodeMath", operation="SINE") is None
    assert through("ShaderNodeMath", operation="MULTIPLY", constant=0.0) is None


def test_the_threshold_of_a_clipped_material_counts() -> None:
    made = leaf()
    assert alpha_look(made).threshold == 0.5 and alpha_look(made).channel == ALPHA
    if bpy.app.version < (4, 2, 0):
        made.blend_method, made.alpha_threshold = "CLIP", 0.2
        assert alpha_look(made).threshold == pytest.approx(0.2)


def test_the_map_and_mapping_of_the_alpha_are_its_own(scene: Any) -> None:
    made, node = cut_out(painted(disc(128)))
    thing = board(scene, made)
    other = thing.data.uv_layers.new(name="Other")
    for datum in other.data:
        datum.uv = [2 * x for x in datum.uv]
    uv_map = made.node_tree.nodes.new("ShaderNodeUVMap")
    uv_map.uv_map = "Other"
    made.node_tree.links.new(uv_map.outputs[0], node.inputs["Vector"])
    (mesh,) = read(scene).meshes
    assert np.abs(mesh.positions[:, :2]).min(axis=1).min() > 0.1  # four discs, none in the middle


def without_alpha(_folder: Any) -> Any:
    return bpy.data.images.new("Bad", 8, 8, alpha=False)


def without_use_of_alpha(_folder: Any) -> Any:
    image = painted(disc(8), name="Bad")
    image.alpha_mode = "NONE"
    return image


def tiled(_folder: Any) -> Any:
    return bpy.data.images.new("Bad", 8, 8, alpha=True, tiled=True)


def sequence(_folder: Any) -> Any:
    image = painted(disc(8), name="Bad")
    image.pack()
    image.source = "SEQUENCE"
    return image


def huge(_folder: Any) -> Any:
    return bpy.data.images.new("Bad", 32768, 8192 * 8192 // 32768 + 1, alpha=True)


@pytest.mark.parametrize(
    "bad",
    [
        missing_image,
        wrongly_packed_image,
        without_alpha,
        without_use_of_alpha,
        tiled,
        sequence,
        huge,
    ],
)
def test_bad_images_leave_materials_whole_and_are_told_once(
    scene: Any, tmp_path: Any, bad: Any
) -> None:
    made, _ = cut_out(bad(tmp_path))
    for place in ((0, 0, 5), (0, 0, 6)):
        board(scene, made, place)
    result = drawn(scene)
    (warning,) = result.warnings
    assert warning.startswith(f'Material "{made.name}" is drawn whole: image "Bad": ')
    assert [mesh.face_sizes.tolist() for mesh in result.arrays.meshes] == [[4], [4]]


def test_a_mesh_without_a_map_is_whole_and_named(scene: Any) -> None:
    thing = board(scene, leaf())
    thing.data.uv_layers.remove(thing.data.uv_layers[0])
    (warning,) = drawn(scene).warnings
    assert "has no UV map" in warning and '"Ink"' in warning


def test_packed_and_wide_images_are_read(scene: Any) -> None:
    image = painted(disc(64))
    image.pack()
    board(scene, cut_out(image)[0])
    with IMAGES.asked():
        assert len(read(scene).meshes[0].face_sizes) > 4
    IMAGES.forget()
    wide = painted(np.ones((2, 32768), np.float32), name="Wide")
    made, _ = cut_out(wide)
    bpy.context.object.data.materials[0] = made
    assert read(scene).meshes[0].face_sizes.tolist() == [4]


def test_coarse_outlines_are_told_with_the_setting(scene: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr("illustrate.reading.alpha.cut.MOST_CUT", 10)
    board(scene, leaf())
    (warning,) = drawn(scene).warnings
    assert "Cut By Alpha" in warning and '"Plane"' in warning
