"""How light or dark materials are by themselves: base colours, colour attributes, textures.

Node trees are followed as far as a constant, an image through a UV map or a colour attribute goes,
times a constant, or mixed by one. Of anything else the viewport colour stands in, and it is named.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..running.cache import digest
from .kept_images import IMAGES
from .pictures import LUMINANCE, read_image

PAPER = 0.8  # Blender's own base colour: what is as light is white paper, and nothing is whiter
WRAPS = {"REPEAT": "repeat", "MIRROR": "mirror", "EXTEND": "extend", "CLIP": "clip"}
COLOURED = {
    "BSDF_PRINCIPLED": "Base Color",
    "BSDF_DIFFUSE": "Color",
    "BSDF_GLOSSY": "Color",
    "BSDF_TOON": "Color",
    "BSDF_SHEEN": "Color",
    "SUBSURFACE_SCATTERING": "Color",
    "EMISSION": "Color",
}
CLEAR = {"BSDF_GLASS", "BSDF_TRANSPARENT", "BSDF_REFRACTION"}
HALF = 0.5  # of the light that goes through: more is clear


@dataclass(frozen=True)
class Look:
    """The lightness of a material: the product of what it has."""

    value: float = PAPER
    image: Any = None
    wrap: str = "repeat"
    uv_map: str = ""  # empty: the one that is rendered
    mapping: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)  # rows of a (2, 3) matrix
    attribute: str | None = None  # of colours; empty: the one that is rendered
    is_whole: bool = True  # False: its nodes do more than is followed
    is_clear: bool = False  # seen through
    is_cut_out: bool = False  # nodes say where (alpha/looks.py)

    @property
    def is_plain(self) -> bool:
        """True for one value all over."""
        return self.image is None and self.attribute is None


def luminance(colour: Any) -> float:
    """Of a linear RGB(A) colour."""
    return float(np.dot(LUMINANCE, tuple(colour)[:3]))


# --- Materials ----------------------------------------------------------------------------------


def look_of(material: Any) -> Look:
    """The look of a material; of none: Blender's own."""
    if material is None:
        return Look()
    viewport = Look(luminance(material.diffuse_color))
    tree = material.node_tree if material.use_nodes else None
    output = tree and tree.get_output_node("ALL")
    if not output:
        return viewport
    found = _shader(_source(output.inputs["Surface"])) if output.inputs["Surface"].links else None
    return found or replace(viewport, is_whole=False)


def _source(socket: Any) -> Any:
    """The node that a linked socket gets its value from, past reroutes."""
    node = socket.links[0].from_node
    while node.type == "REROUTE" and node.inputs[0].links:
        node = node.inputs[0].links[0].from_node
    return node


def _shader(node: Any) -> Look | None:
    """The look of a shader; None where it is not followed."""
    if node.type in CLEAR:
        return Look(is_clear=True)
    if node.type == "MIX_SHADER":
        return _mixed_shaders(node)
    if node.type not in COLOURED:
        return None
    look = _colour(node.inputs[COLOURED[node.type]])
    if look is None:
        return None
    if _passing(node) >= HALF:
        return replace(look, is_clear=True)
    if _is_cut_out(node):
        look = replace(look, is_cut_out=True)
    if node.type == "EMISSION":
        return replace(look, value=look.value * _constant(node.inputs["Strength"], 1.0))
    shining = _emission(node)
    if shining and look.is_plain:
        return replace(look, value=look.value + shining)
    return Look(max(shining, PAPER)) if shining else look


def _emission(node: Any) -> float:
    """The light of a Principled shader's own, as far as it is constant."""
    colour = node.inputs.get("Emission Color") or node.inputs.get("Emission")
    strength = node.inputs.get("Emission Strength")
    if colour is None or strength is None or colour.links or strength.links:
        return 0.0
    return luminance(colour.default_value) * float(strength.default_value)


def _passing(node: Any) -> float:
    """The share of light that a shader lets through, as far as it is constant."""
    passing = node.inputs.get("Transmission Weight") or node.inputs.get("Transmission")
    alpha = node.inputs.get("Alpha")
    through = 0.0 if passing is None else _constant(passing, 0.0)
    return max(through, 0.0 if alpha is None else 1.0 - _constant(alpha, 1.0))


def _is_cut_out(node: Any) -> bool:
    alpha = node.inputs.get("Alpha")
    return alpha is not None and bool(alpha.links)


def _mixed_shaders(node: Any) -> Look | None:
    sides = [_shader(_source(s)) if s.links else None for s in node.inputs[1:3]]
    if node.inputs[0].links:
        return _mixed_by_nodes(sides)
    return _mixed(sides[0], sides[1], float(node.inputs[0].default_value))


def _mixed_by_nodes(sides: list[Look | None]) -> Look | None:
    """The first side that is followed; where the other one is clear it is cut out."""
    known = [side for side in sides if side is not None]
    solid = [side for side in known if not side.is_clear]
    if solid and len(solid) < len(known):
        return replace(solid[0], is_cut_out=True)
    clear = not solid and len(known) == len(sides)
    return replace(known[0], is_whole=False, is_clear=clear) if known else None


def _mixed(a: Look | None, b: Look | None, share: float) -> Look | None:
    """Of two looks in the shares 1 - share and share; of textures the one that counts for more."""
    if share in (0.0, 1.0):
        return b if share else a
    if a is None or b is None:
        return _part(a or b)
    if a.is_plain and b.is_plain:
        value = (1 - share) * a.value + share * b.value
        clear = (1 - share) * a.is_clear + share * b.is_clear >= HALF
        return Look(value, is_whole=a.is_whole and b.is_whole, is_clear=clear)
    return _part(b if share > 0.5 else a)


def _part(look: Look | None) -> Look | None:
    """The look as one that is not all there is."""
    return look and replace(look, is_whole=False)


def _multiplied(a: Look | None, b: Look | None, share: float) -> Look | None:
    if a is None or b is None:
        return _part(a or b)
    whole = a.is_whole and b.is_whole
    if b.is_plain:
        return replace(a, value=a.value * (1 - share + share * b.value), is_whole=whole)
    if share < 1.0:
        return _part(a)
    # An attribute and an image can be had together, but no two of either.
    with_both = replace(b, value=a.value * b.value, is_whole=whole)
    if a.is_plain:
        return with_both
    if a.image is None and b.attribute is None:
        return replace(with_both, attribute=a.attribute)
    if b.image is None and a.attribute is None:
        return replace(a, value=with_both.value, attribute=b.attribute, is_whole=whole)
    return _part(a)


def _constant(socket: Any, otherwise: float) -> float:
    return otherwise if socket.links else float(socket.default_value)


def _colour(socket: Any) -> Look | None:
    """The look of a colour socket; None where its nodes are not followed."""
    if not socket.links:
        return Look(luminance(socket.default_value))
    node = _source(socket)
    if node.type == "RGB":
        return Look(luminance(node.outputs[0].default_value))
    if node.type == "TEX_IMAGE":
        return image_of(node)
    if node.type == "VERTEX_COLOR":
        return Look(1.0, attribute=node.layer_name)
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY":
        return Look(1.0, attribute=node.attribute_name)
    if node.type in ("MIX", "MIX_RGB"):
        return _mixed_colours(node)
    through = node.inputs.get("Color")
    return _part(_colour(through) if through is not None else None)


def _mixed_colours(node: Any) -> Look | None:
    factor, a, b = [socket for socket in node.inputs if socket.enabled][:3]
    if getattr(node, "data_type", "RGBA") != "RGBA" or node.blend_type not in ("MIX", "MULTIPLY"):
        return None
    looks = _colour(a), _colour(b)
    if factor.links:
        return _part(looks[0] or looks[1])
    mix = _mixed if node.blend_type == "MIX" else _multiplied
    return mix(*looks, min(max(float(factor.default_value), 0.0), 1.0))


def image_of(node: Any) -> Look | None:
    """The look of an image texture; None where it does not lie by a UV map."""
    if node.image is None or node.projection != "FLAT":
        return None
    look = Look(1.0, image=node.image, wrap=WRAPS.get(node.extension, "repeat"))
    vector = node.inputs["Vector"]
    return _through(vector, look) if vector.links else look


def _through(vector: Any, look: Look) -> Look | None:
    """The look with the UV map and mapping that a linked vector socket has."""
    node = _source(vector)
    if node.type == "UVMAP":
        return replace(look, uv_map=node.uv_map)
    if node.type == "TEX_COORD":
        return look if vector.links[0].from_socket.name == "UV" else None
    if node.type != "MAPPING" or node.vector_type not in ("POINT", "TEXTURE"):
        return None
    if any(node.inputs[name].links for name in ("Location", "Rotation", "Scale")):
        return None
    mapped = replace(look, mapping=_mapping(node))
    inner = node.inputs["Vector"]
    return _through(inner, mapped) if inner.links else None


def _mapping(node: Any) -> tuple[float, ...]:
    """Rows of the (2, 3) matrix that a Mapping node applies to UVs."""
    place, turn, size = (
        node.inputs[name].default_value for name in ("Location", "Rotation", "Scale")
    )
    cosine, sine = np.cos(turn[2]), np.sin(turn[2])
    matrix = np.array([[cosine, -sine, place[0]], [sine, cosine, place[1]], [0.0, 0.0, 1.0]])
    matrix = matrix @ np.diag([size[0], size[1], 1.0])
    if node.vector_type == "TEXTURE":
        if abs(np.linalg.det(matrix)) < 1e-12:
            return (0.0,) * 6
        matrix = np.linalg.inv(matrix)
    return tuple(float(x) for x in matrix[:2].reshape(-1))


# --- Meshes -------------------------------------------------------------------------------------


@dataclass
class TextureArrays:
    """Arguments of `illustrate_native.Texture`."""

    luminance: Any  # (h, w) float32
    wrap: str = "repeat"

    @cached_property
    def key(self) -> str:
        """A name for what it shows, found once however many meshes share it."""
        return f"{self.wrap} {digest(self.luminance)}"


class LightnessReader:
    """Reads the lightness of meshes, each image once; notes what it cannot follow."""

    def __init__(self) -> None:
        self.unread: dict[str, str] = {}  # what is wrong with an image, by its name
        self.partly: list[str] = []  # names of materials
        self._looks: dict[Any, Look] = {}
        self._textures: dict[tuple[Any, str], TextureArrays | None] = {}

    def read(self, arrays: Any, mesh: Any, materials: Iterable[Any]) -> None:
        """Sets what `arrays` (MeshArrays) says of the reflectance of a Blender mesh."""
        looks = [self.look(material) for material in materials] or [Look()]
        of_faces = np.clip(arrays.face_materials, 0, len(looks) - 1)
        used = set(np.unique(of_faces).tolist())
        values = np.array([look.value / PAPER for look in looks])
        if not any(looks[i].value < PAPER or not looks[i].is_plain for i in used):
            return
        arrays.reflectance = values[of_faces]
        of_corners = np.repeat(of_faces, arrays.face_sizes)
        for i in sorted(used):
            if looks[i].attribute is not None:
                self._tint(arrays, mesh, looks[i].attribute, of_corners == i)
        self._cover(arrays, mesh, looks, of_faces, of_corners)

    def is_clear(self, materials: list[Any]) -> bool:
        """True where there are materials and all are seen through."""
        return bool(materials) and all(self.look(material).is_clear for material in materials)

    def look(self, material: Any) -> Look:
        """The look of a material; it is noted where it is followed in part."""
        look = self._looks.get(material) or look_of(material)
        self._looks[material] = look
        if material is not None and not look.is_whole and material.name not in self.partly:
            self.partly.append(material.name)
        return look

    def _tint(self, arrays: Any, mesh: Any, attribute: Any, chosen: Any) -> None:
        """Multiplies the lightness of the chosen corners by an attribute."""
        colours = _corner_colours(mesh, attribute)
        if colours is None:
            return
        if len(arrays.reflectance) == len(arrays.face_sizes):
            arrays.reflectance = np.repeat(arrays.reflectance, arrays.face_sizes)
        arrays.reflectance[chosen] *= colours[chosen]

    def _cover(
        self, arrays: Any, mesh: Any, looks: list[Look], of_faces: Any, of_corners: Any
    ) -> None:
        """Sets textures and UVs."""
        numbers = np.full(len(looks), -1, np.int32)
        uv = np.zeros((len(of_corners), 2))
        for i, look in enumerate(looks):
            layer = uv_layer(mesh, look.uv_map) if look.image is not None else None
            texture = self._texture(look) if layer is not None else None
            if texture is None:
                continue
            numbers[i] = len(arrays.textures)
            arrays.textures.append(texture)
            chosen = of_corners == i
            uv[chosen] = mapped_uv(layer, look)[chosen]
        if arrays.textures:
            arrays.uv, arrays.face_textures = uv, numbers[of_faces]

    def _texture(self, look: Look) -> TextureArrays | None:
        key = (look.image, look.wrap)
        if key not in self._textures:
            try:
                self._textures[key] = IMAGES.of(look.image, look.wrap, lambda: _texture_of(look))
            except ValueError as error:
                self.unread[look.image.name] = str(error)
                self._textures[key] = None
        return self._textures[key]


def _texture_of(look: Look) -> TextureArrays:
    return TextureArrays(read_image(look.image), look.wrap)


def uv_layer(mesh: Any, name: str) -> Any:
    """The named UV map, else the one that is rendered; None where there is none."""
    found = mesh.uv_layers.get(name) if name else None
    return found or next((layer for layer in mesh.uv_layers if layer.active_render), None)


def uv_of(layer: Any) -> Any:
    """(corners, 2)."""
    values = np.zeros(2 * len(layer.data), np.float32)
    layer.data.foreach_get("uv", values)
    return values.reshape(-1, 2).astype(float)


def mapped_uv(layer: Any, look: Look) -> Any:
    """(corners, 2) places on the image of a look."""
    matrix = np.reshape(look.mapping, (2, 3))
    return uv_of(layer) @ matrix[:, :2].T + matrix[:, 2]


def _corner_colours(mesh: Any, name: str) -> Any:
    """(corners,) luminance of a colour attribute; None where there is none."""
    colours = mesh.color_attributes
    layer = colours.get(name) if name else None
    if layer is None and not name and len(colours):
        layer = colours[max(colours.render_color_index, 0)]
    if layer is None or layer.domain not in ("POINT", "CORNER"):
        return None
    values = np.zeros(4 * len(layer.data), np.float32)
    layer.data.foreach_get("color", values)
    grey = values.reshape(-1, 4)[:, :3] @ np.array(LUMINANCE)
    if layer.domain == "CORNER":
        return grey
    corners = np.zeros(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    return grey[corners]


# --- Images -------------------------------------------------------------------------------------
