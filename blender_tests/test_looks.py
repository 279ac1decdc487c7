"""What is followed of a material's nodes: shaders, colours and where images lie."""

from collections.abc import Callable
from typing import Any

import bpy
import pytest
from illustrate.reading.lightness import PAPER, Look, look_of
from test_lightness import checks, material

Colour = Callable[[Any], None]  # links a colour socket to nodes


def grey(value: float) -> tuple[float, ...]:
    return (value, value, value, 1.0)


def shaded(kind: str, value: float, to: Any) -> Any:
    """A shader node of one grey, linked to a socket."""
    node = to.id_data.nodes.new(kind)
    node.inputs["Color"].default_value = grey(value)
    to.id_data.links.new(node.outputs[0], to)
    return node


def mixer(made: Any) -> Any:
    """A mix of shaders in the place of the material's only one."""
    nodes = made.node_tree.nodes
    output = next(n for n in nodes if n.type == "OUTPUT_MATERIAL")
    mix = nodes.new("ShaderNodeMixShader")
    made.node_tree.links.new(mix.outputs[0], output.inputs["Surface"])
    return mix


def coloured(colour: Colour) -> Look:
    """The look of a material whose base colour has nodes."""
    made, shader = material()
    made.diffuse_color = grey(0.07)
    colour(shader.inputs["Base Color"])
    return look_of(made)


def link(kind: str, to: Any) -> Any:
    """A new node, its colour linked to a socket."""
    node = to.id_data.nodes.new(kind)
    to.id_data.links.new(node.outputs["Color"], to)
    return node


def image(to: Any) -> Any:
    node = link("ShaderNodeTexImage", to)
    node.image = checks()
    return node


@pytest.mark.parametrize(("share", "value"), [(0.25, 0.35), (0.0, 0.2), (1.0, 0.8)])
def test_shaders_are_mixed_in_their_shares(share: float, value: float) -> None:
    made, _ = material()
    mix = mixer(made)
    mix.inputs[0].default_value = share
    shaded("ShaderNodeBsdfDiffuse", 0.2, mix.inputs[1])
    shaded("ShaderNodeEmission", 0.4, mix.inputs[2]).inputs["Strength"].default_value = 2.0
    assert look_of(made) == Look(pytest.approx(value))


@pytest.mark.parametrize(("share", "is_clear"), [(0.4, False), (0.6, True)])
def test_a_mix_is_seen_through_where_half_of_it_is(share: float, is_clear: bool) -> None:
    made, _ = material()
    mix = mixer(made)
    mix.inputs[0].default_value = share
    shaded("ShaderNodeBsdfDiffuse", 0.2, mix.inputs[1])
    shaded("ShaderNodeBsdfTransparent", 1.0, mix.inputs[2])
    assert look_of(made).is_clear == is_clear


def test_a_mix_by_nodes_is_the_first_that_is_followed() -> None:
    made, _ = material()
    mix = mixer(made)
    link("ShaderNodeTexNoise", mix.inputs[0])
    shaded("ShaderNodeBsdfHair", 0.9, mix.inputs[1])  # not followed
    shaded("ShaderNodeBsdfDiffuse", 0.2, mix.inputs[2])
    look = look_of(made)
    assert (look.value, look.is_whole, look.is_clear) == (pytest.approx(0.2), False, False)


def test_what_nodes_cut_out_is_its_solid_side() -> None:
    made, _ = material()
    mix = mixer(made)
    link("ShaderNodeTexNoise", mix.inputs[0])
    shaded("ShaderNodeBsdfTransparent", 1.0, mix.inputs[1])
    shaded("ShaderNodeBsdfDiffuse", 0.2, mix.inputs[2])
    assert look_of(made) == Look(pytest.approx(0.2), is_cut_out=True)
    made, shader = material(grey(0.3))
    link("ShaderNodeTexNoise", shader.inputs["Alpha"])
    assert look_of(made) == Look(pytest.approx(0.3), is_cut_out=True)


def test_of_a_side_that_is_not_mixed_in_nothing_is_said() -> None:
    made, _ = material()
    mix = mixer(made)
    shaded("ShaderNodeBsdfDiffuse", 0.2, mix.inputs[1])
    shaded("ShaderNodeBsdfHair", 0.9, mix.inputs[2])
    mix.inputs[0].default_value = 0.5
    assert not look_of(made).is_whole
    mix.inputs[0].default_value = 0.0
    assert look_of(made) == Look(pytest.approx(0.2))


def test_light_of_its_own_makes_a_material_lighter() -> None:
    made, shader = material(grey(0.2))
    name = "Emission Color" if "Emission Color" in shader.inputs else "Emission"
    shader.inputs[name].default_value = grey(0.5)
    shader.inputs["Emission Strength"].default_value = 0.4
    assert look_of(made) == Look(pytest.approx(0.4))
    image(shader.inputs["Base Color"])
    assert look_of(made) == Look(PAPER)  # no texture is seen below a light


def multiplied(share: float, a: Colour, b: Colour) -> Colour:
    """A mix of colours that multiplies."""

    def to(socket: Any) -> None:
        node = link("ShaderNodeMixRGB", socket)
        node.blend_type = "MULTIPLY"
        node.inputs[0].default_value = share
        a(node.inputs[1])
        b(node.inputs[2])

    return to


def plain(value: float) -> Colour:
    """An RGB node behind a reroute."""

    def to(socket: Any) -> None:
        reroute = socket.id_data.nodes.new("NodeReroute")
        socket.id_data.links.new(reroute.outputs[0], socket)
        node = link("ShaderNodeRGB", reroute.inputs[0])
        node.outputs[0].default_value = grey(value)

    return to


def shade(socket: Any) -> None:
    """A colour attribute."""
    link("ShaderNodeAttribute", socket).attribute_name = "Shade"


def gamma(socket: Any) -> None:
    """A constant through a node that is not followed."""
    node = link("ShaderNodeGamma", socket)
    node.inputs["Color"].default_value = grey(0.5)


def noise(socket: Any) -> None:
    """Nothing that is followed."""
    link("ShaderNodeTexNoise", socket)


@pytest.mark.parametrize(
    ("colour", "value", "has", "is_whole"),
    [
        (plain(0.3), 0.3, "", True),
        (gamma, 0.5, "", False),
        (noise, 0.07, "", False),  # as in the viewport
        (multiplied(0.5, plain(0.4), plain(0.5)), 0.3, "", True),
        (multiplied(0.5, image, plain(0.5)), 0.75, "image", True),
        (multiplied(1.0, plain(0.5), image), 0.5, "image", True),
        (multiplied(0.5, plain(0.4), image), 0.4, "", False),
        (multiplied(1.0, shade, image), 1.0, "image attribute", True),
        (multiplied(1.0, image, shade), 1.0, "image attribute", True),
        (multiplied(1.0, image, image), 1.0, "image", False),
        (multiplied(1.0, shade, shade), 1.0, "attribute", False),
        (multiplied(1.0, image, gamma), 0.5, "image", False),
        (multiplied(1.0, image, noise), 1.0, "image", False),
        (multiplied(1.0, noise, image), 1.0, "image", False),
        (multiplied(1.0, noise, noise), 0.07, "", False),
    ],
)
def test_colours_are_followed_to_one_image_and_one_attribute(
    colour: Colour, value: float, has: str, is_whole: bool
) -> None:
    look = coloured(colour)
    assert (look.value, look.is_whole) == (pytest.approx(value), is_whole)
    assert (look.image is not None, look.attribute is not None) == (
        "image" in has,
        "attribute" in has,
    )


def mapped(kind: str) -> Colour:
    """An image through a Mapping node that scales by 2 and 0.5 and moves by 1 and 0."""

    def to(socket: Any) -> None:
        links, nodes = socket.id_data.links, socket.id_data.nodes
        mapping, uv = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeUVMap")
        mapping.vector_type = kind
        mapping.inputs["Scale"].default_value = (2, 0.5, 1)
        if kind != "NORMAL":
            mapping.inputs["Location"].default_value = (1, 0, 0)
        uv.uv_map = "Second"
        links.new(uv.outputs[0], mapping.inputs["Vector"])
        links.new(mapping.outputs[0], image(socket).inputs["Vector"])

    return to


@pytest.mark.parametrize(
    ("kind", "mapping"), [("POINT", (2, 0, 1, 0, 0.5, 0)), ("TEXTURE", (0.5, 0, -0.5, 0, 2, 0))]
)
def test_images_lie_where_their_mapping_says(kind: str, mapping: tuple[float, ...]) -> None:
    look = coloured(mapped(kind))
    assert (look.uv_map, look.mapping) == ("Second", pytest.approx(mapping))


def generated(socket: Any) -> None:
    """An image that lies by other coordinates than a UV map."""
    source = socket.id_data.nodes.new("ShaderNodeTexCoord")
    socket.id_data.links.new(source.outputs["Generated"], image(socket).inputs["Vector"])


def projected(socket: Any) -> None:
    """An image on the six sides of a box."""
    image(socket).projection = "BOX"


def empty(socket: Any) -> None:
    """A node without its image."""
    image(socket).image = None


@pytest.mark.parametrize("colour", [mapped("NORMAL"), generated, projected, empty])
def test_the_viewport_colour_stands_in_for_images_that_lie_otherwise(colour: Colour) -> None:
    look = coloured(colour)
    assert look == Look(pytest.approx(0.07), is_whole=False)


def test_a_mapping_by_nodes_is_not_followed() -> None:
    made, shader = material()
    mapped("POINT")(shader.inputs["Base Color"])
    mapping = next(n for n in made.node_tree.nodes if n.type == "MAPPING")
    link("ShaderNodeTexNoise", mapping.inputs["Scale"])
    assert not look_of(made).is_whole


def test_a_texture_of_no_size_is_one_texel() -> None:
    made, shader = material()
    mapped("TEXTURE")(shader.inputs["Base Color"])
    mapping = next(n for n in made.node_tree.nodes if n.type == "MAPPING")
    mapping.inputs["Scale"].default_value = (0, 1, 1)
    assert look_of(made).mapping == (0.0,) * 6


def test_without_an_output_the_viewport_colour_counts() -> None:
    made = bpy.data.materials.new("Bare")
    made.use_nodes = True
    made.node_tree.nodes.clear()
    made.diffuse_color = grey(0.3)
    assert look_of(made) == Look(pytest.approx(0.3))
