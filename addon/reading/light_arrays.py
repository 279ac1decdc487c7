"""Blender's lights as arrays.

Strengths are the radiance that a white diffuse surface has in Cycles, facing the light: that of a
sun everywhere, that of other lights one unit away from them.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from .lightness import luminance

SKY = (0.5, 0.5, 0.5)  # what stands in for a sky or an image all round


@dataclass
class LightArrays:
    """Arguments of `illustrate_native.Light`."""

    kind: str
    vector: Any  # (3,)
    strength: float
    direction: Any = None  # (3,)
    angle_rad: float | None = None
    blend: float = 0.0
    falloff_distance: float = 0.0
    edges: Any = None  # (2, 3)
    ellipse: bool = False
    casts_shadows: bool = True
    contours: bool = True


def read_light(data: Any, matrix: Any) -> LightArrays:
    """The light `data` placed by `matrix` (4, 4). Lights shine along their own -z."""
    watts = data.energy * 2.0 ** getattr(data, "exposure", 0.0)
    watts *= luminance(data.color)
    position, backward = matrix[:3, 3], _unit(matrix[:3, 2])
    if data.type == "SUN":
        light = LightArrays("sun", backward, watts / math.pi)
    elif data.type == "AREA":
        light = LightArrays("area", position, watts / (4 * math.pi), -backward)
        light.edges = _edges(data, matrix)
        light.ellipse = data.shape in ("DISK", "ELLIPSE")
    elif data.type == "SPOT":
        strength = watts / (4 * math.pi**2)
        light = LightArrays("spot", position, strength, -backward, data.spot_size / 2)
        light.blend = data.spot_blend
    else:
        light = LightArrays("point", position, watts / (4 * math.pi**2))
    light.falloff_distance = 0.0 if light.kind == "sun" else 1.0
    light.casts_shadows = data.use_shadow
    # Of the light itself: its evaluated copy hears of changes when something else changes too.
    light.contours = data.original.illustrate.contours
    return light


def read_world(world: Any) -> list[LightArrays]:
    """The light of a world's background, as far as it is one colour; none where it is black."""
    if world is None:
        return []
    colour, strength = world.color, 1.0
    tree = world.node_tree if world.use_nodes else None
    output = tree and tree.get_output_node("ALL")
    if output and output.inputs["Surface"].links:
        node = output.inputs["Surface"].links[0].from_node
        if node.type != "BACKGROUND" or node.inputs["Strength"].links:
            return []
        strength = float(node.inputs["Strength"].default_value)
        colour = SKY if node.inputs["Color"].links else node.inputs["Color"].default_value
    grey = luminance(colour) * strength
    return [LightArrays("ambient", None, grey, casts_shadows=False)] if grey > 0 else []


def _edges(data: Any, matrix: Any) -> Any:
    """(2, 3) sides of an area light, None where it has no extent."""
    height = data.size_y if data.shape in ("RECTANGLE", "ELLIPSE") else data.size
    edges = np.array([data.size * matrix[:3, 0], height * matrix[:3, 1]])
    return edges if np.linalg.norm(np.cross(*edges)) > 1e-12 else None


def _unit(vector: Any) -> Any:
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.array([0.0, 0.0, 1.0])
