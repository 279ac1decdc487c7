"""How light materials are: base colours, textures and attributes, as Blender has them."""

import contextlib
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.reading import lightness, pictures
from illustrate.reading.kept_images import IMAGES
from illustrate.running import illustration

import tools
from tools import read

GREY = 0.4


def material(colour: Any = (GREY, GREY, GREY, 1)) -> tuple[Any, Any]:
    """A material and its Principled node."""
    made = bpy.data.materials.new("Ink")
    made.use_nodes = True
    shader = next(n for n in made.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = colour
    return made, shader


def link(made: Any, kind: str, to: Any) -> Any:
    node = made.node_tree.nodes.new(kind)
    output = next(o for o in node.outputs if o.name in ("Color", "Result") and o.enabled)
    made.node_tree.links.new(output, to)
    return node


def checks(name: str = "Checks") -> Any:
    """4 x 4 texels, black and white in turn, black at the origin."""
    image = bpy.data.images.new(name, 4, 4)
    grey = (np.indices((4, 4)).sum(0) % 2).astype(float)
    image.pixels.foreach_set(
        np.stack([grey, grey, grey, np.ones_like(grey)], axis=2).astype(np.float32).ravel()
    )
    return image


def board(scene: Any, made: Any, place: Any = (0, 0, 5)) -> Any:
    """A plane of two units, seen from above."""
    tools.add_camera(scene, place, (200, 200), type="ORTHO", ortho_scale=2.5)
    bpy.ops.mesh.primitive_plane_add(size=2)
    thing = bpy.context.object
    thing.data.materials.append(made)
    return thing


def test_base_colours_are_lightness_and_white_stays_white(scene: Any) -> None:
    thing = board(scene, None)
    assert read(scene).meshes[0].reflectance is None  # Blender's own grey is paper
    thing.data.materials[0] = material()[0]
    assert read(scene).meshes[0].reflectance == pytest.approx([GREY / lightness.PAPER])
    thing.data.materials[0] = material((1, 1, 1, 1))[0]
    assert read(scene).meshes[0].reflectance is None


def test_the_material_of_a_slot_counts_where_it_is_the_objects(scene: Any) -> None:
    thing = board(scene, material((1, 1, 1, 1))[0])
    thing.material_slots[0].link = "OBJECT"
    thing.material_slots[0].material = material()[0]
    assert read(scene).meshes[0].reflectance == pytest.approx([GREY / lightness.PAPER])


def test_without_nodes_the_viewport_colour_counts(scene: Any) -> None:
    made = bpy.data.materials.new("Plain")
    made.diffuse_color = (0.2, 0.2, 0.2, 1)
    if bpy.app.version < (5, 0, 0):
        made.use_nodes = False
        board(scene, made)
        assert read(scene).meshes[0].reflectance == pytest.approx([0.25])


def test_a_texture_is_seen_where_its_map_lies(scene: Any) -> None:
    made, shader = material()
    node = link(made, "ShaderNodeTexImage", shader.inputs["Base Color"])
    node.image = checks()
    board(scene, made)
    scene.illustrate.lighting = "HEADLIGHT"
    drawn = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    tone = drawn.drawing.tone
    side = 200 / 2.5 / 2 / tone.cell_px  # cells of a texel
    start = 20 / tone.cell_px
    for row in range(4):
        for column in range(4):
            y = int(tone.brightness.shape[0] - start - (row + 0.5) * side)
            x = int(start + (column + 0.5) * side)
            assert tone.brightness[y, x] == pytest.approx((row + column) % 2, abs=0.05)
    assert not drawn.warnings


def test_a_mapping_moves_the_texture(scene: Any) -> None:
    made, shader = material()
    image = link(made, "ShaderNodeTexImage", shader.inputs["Base Color"])
    image.image = checks()
    nodes, links = made.node_tree.nodes, made.node_tree.links
    mapping, source = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexCoord")
    links.new(mapping.outputs[0], image.inputs["Vector"])
    links.new(source.outputs["UV"], mapping.inputs["Vector"])
    mapping.inputs["Scale"].default_value = (2, 3, 1)
    mapping.inputs["Location"].default_value = (0.25, 0, 0)
    board(scene, made)
    uv = read(scene).meshes[0].uv
    assert uv.min(axis=0) == pytest.approx([0.25, 0])
    assert uv.max(axis=0) == pytest.approx([2.25, 3])


def test_a_colour_attribute_shades_corners(scene: Any) -> None:
    made, shader = material()
    link(made, "ShaderNodeVertexColor", shader.inputs["Base Color"]).layer_name = "Shade"
    thing = board(scene, made)
    colours = thing.data.color_attributes.new("Shade", "FLOAT_COLOR", "POINT")
    for k, datum in enumerate(colours.data):
        datum.color = (0.2 * k, 0.2 * k, 0.2 * k, 1)
    mesh = read(scene).meshes[0]
    expected = 0.2 * mesh.corner_vertices / lightness.PAPER
    assert mesh.reflectance == pytest.approx(expected, abs=1e-6)


def test_what_is_not_followed_is_named_once(scene: Any) -> None:
    made, shader = material()
    link(made, "ShaderNodeTexNoise", shader.inputs["Base Color"])
    made.diffuse_color = (0.08, 0.08, 0.08, 1)
    board(scene, made)
    assert read(scene).meshes[0].reflectance == pytest.approx([0.1])
    drawn = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    (warning,) = [w for w in drawn.warnings if "nodes" in w]
    assert '"Ink"' in warning


def test_materials_that_nodes_cut_out_are_named(scene: Any) -> None:
    made, shader = material()
    link(made, "ShaderNodeTexNoise", shader.inputs["Alpha"])
    board(scene, made)
    drawn = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    (warning,) = [w for w in drawn.warnings if "is drawn whole" in w]
    assert '"Ink"' in warning


def missing_image(folder: Any) -> Any:
    image = bpy.data.images.new("Bad", 4, 4)
    image.source = "FILE"
    image.filepath = str(folder / "nowhere.png")
    return image


def wrongly_packed_image(_folder: Any) -> Any:
    image = bpy.data.images.new("Bad", 4, 4)
    image.pack(data=b"no picture at all", data_len=17)
    image.source = "FILE"
    return image


def huge_image(_folder: Any) -> Any:
    """32,768 pixels wide, and a little larger than what is read."""
    return bpy.data.images.new("Bad", 32768, pictures.MOST_TEXELS // 32768 + 1)


@pytest.mark.parametrize("bad", [missing_image, wrongly_packed_image, huge_image])
def test_a_bad_image_counts_as_white_and_is_named_once(scene: Any, tmp_path: Any, bad: Any) -> None:
    made, shader = material()
    for _ in range(2):  # two materials and two objects with the same image
        node = link(made, "ShaderNodeTexImage", shader.inputs["Base Color"])
        node.image = bpy.data.images.get("Bad") or bad(tmp_path)
        board(scene, made)
        made, shader = material()
    drawn = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    (warning,) = drawn.warnings
    assert warning.startswith('Image "Bad" counts as white: it')
    assert (drawn.drawing.tone.level != 255).any()


def test_a_wide_image_is_read(scene: Any) -> None:
    """As wide as the worst that is sold, but only some rows of it."""
    made, shader = material()
    node = link(made, "ShaderNodeTexImage", shader.inputs["Base Color"])
    node.image = bpy.data.images.new("Wide", 32768, 4)
    board(scene, made)
    arrays = read(scene)
    (mesh,) = arrays.meshes
    assert mesh.textures[0].luminance.shape == (1, 2048) and not arrays.unread_images


def test_large_images_are_averaged() -> None:
    pixels = np.zeros((3, 5000, 4), np.float32)
    pixels[..., 0] = np.arange(5000)
    small = pictures._averaged(pixels)
    assert small.shape == (1, 1666, 4)
    assert small[0, :, 0] == pytest.approx(1 + 3 * np.arange(1666))


def test_frames_of_a_sequence_are_exposed_alike(scene: Any) -> None:
    board(scene, material()[0])
    lamp = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "SUN"))
    scene.collection.objects.link(lamp)
    lamp.data.energy = 1
    depsgraph = bpy.context.evaluated_depsgraph_get()
    first = illustration.illustrate(scene, depsgraph)
    lamp.data.energy = 3
    second = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    assert second.drawing.tone.exposure == pytest.approx(first.drawing.tone.exposure / 3)
    request = illustration.read_request(scene, bpy.context.evaluated_depsgraph_get())
    request.expose_as(first.drawing)
    third = illustration.compute(request)
    assert third.drawing.tone.exposure == pytest.approx(first.drawing.tone.exposure)


@pytest.mark.parametrize("kind", ["alpha", "transmission", "glass", "half"])
def test_objects_of_transparent_materials_are_seen_through(scene: Any, kind: str) -> None:
    made, shader = material()
    name = "Transmission Weight" if bpy.app.version >= (4, 0, 0) else "Transmission"
    if kind == "alpha":
        shader.inputs["Alpha"].default_value = 0.3
    elif kind == "transmission":
        shader.inputs[name].default_value = 1.0
    else:
        surface = shader.outputs[0].links[0].to_socket
        glass = made.node_tree.nodes.new("ShaderNodeBsdfGlass")
        made.node_tree.links.new(glass.outputs[0], surface)
    thing = board(scene, made)
    if kind == "half":
        thing.data.materials.append(material()[0])
    (style,) = read(scene).styles
    assert style.get("see_through", False) == (kind != "half")


def test_images_are_read_again_when_they_change(scene: Any, monkeypatch: Any) -> None:
    made, shader = material()
    image = checks()
    link(made, "ShaderNodeTexImage", shader.inputs["Base Color"]).image = image
    board(scene, made)
    image.pack()  # it is as in its file
    counted: list[Any] = []
    plain = lightness.read_image

    def watched(one: Any) -> Any:
        counted.append(one)
        return plain(one)

    monkeypatch.setattr(lightness, "read_image", watched)

    def reads(asked: bool) -> int:
        counted.clear()
        with IMAGES.asked() if asked else contextlib.nullcontext():
            texture = read(scene).meshes[0].textures[0]
        assert np.array_equal(texture.luminance, plain(image))
        return len(counted)

    IMAGES.forget()
    assert [reads(True), reads(True), reads(False), reads(True)] == [1, 0, 1, 0]
    image.pixels[0] = 0.5  # that nobody has saved
    assert reads(True) == 1
    image.pack()
    IMAGES.forget()
    assert reads(True) == 1
    IMAGES.forget()


def test_sequences_are_another_picture_at_each_time() -> None:
    image = checks()
    image.pack()
    image.source = "SEQUENCE"
    made: list[int] = []
    with IMAGES.asked():
        for _ in range(2):
            IMAGES.of(image, "tone", lambda: made.append(1))
    assert len(made) == 2
