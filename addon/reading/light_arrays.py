"""Blender's lights as arrays.

Strengths are the radiance that a white diffuse surface has in Cycles, facing the light: that of a
sun everywhere, that of other lights one unit away from them. Cycles has changed what its lamps do:
spots have lost the cosine from their axis in 3.6, and areas shine 4 / pi times as brightly since
4.0. A drawing has the light of the Blender that it is made in.
"""

import math
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np

from ..messages import said
from .lightness import luminance

SKY = (0.5, 0.5, 0.5)  # what stands in for a sky or an image all round
SPOTS_HAVE_A_COSINE = bpy.app.version < (3, 6, 0)
WATTS_OF_AREAS = 4 * math.pi if bpy.app.version < (4, 0, 0) else math.pi**2
WATTS_OF_POINTS = 4 * math.pi**2
"""Watts of a lamp that has a strength of 1."""
LEAST_SPREAD = 1e-3  # of an area's light: a narrower one is a ray


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
    cosine: bool = SPOTS_HAVE_A_COSINE
    spread_rad: float = math.pi
    radius: float = 0.0


def read_light(data: Any, matrix: Any) -> LightArrays:
    """The light `data` placed by `matrix` (4, 4). Lights shine along their own -z."""
    watts = _watts(data)
    position, backward = matrix[:3, 3], _unit(matrix[:3, 2])
    if data.type == "SUN":
        light = LightArrays("sun", backward, watts / math.pi)
    elif data.type == "AREA":
        light = LightArrays("area", position, watts / WATTS_OF_AREAS, -backward)
        light.edges = _edges(data, matrix)
        light.ellipse = data.shape in ("DISK", "ELLIPSE")
        light.spread_rad = min(max(data.spread, LEAST_SPREAD), math.pi)
    elif data.type == "SPOT":
        strength = watts / WATTS_OF_POINTS
        light = LightArrays("spot", position, strength, -backward, data.spot_size / 2)
        light.blend = data.spot_blend
    else:
        light = LightArrays("point", position, watts / WATTS_OF_POINTS)
    if data.type in ("POINT", "SPOT") and getattr(data, "use_soft_falloff", True):
        light.radius = data.shadow_soft_size
    light.falloff_distance = 0.0 if light.kind == "sun" else 1.0
    light.casts_shadows = data.use_shadow
    # Of the light itself: its evaluated copy hears of changes when something else changes too.
    light.contours = data.original.illustrate.contours
    return light


def strength_problem(data: Any) -> str:
    """What is wrong with the strength of a light, empty where it can be drawn with."""
    watts = _watts(data)
    if not math.isfinite(watts):
        return said("it is infinitely strong")
    return said("its strength is negative") if watts < 0 else ""


def _watts(data: Any) -> float:
    """The power of a light, with all that its settings multiply it by."""
    colour = np.array(data.color[:])
    if getattr(data, "use_temperature", False):
        colour = colour * np.array(data.temperature_color[:])
    watts = data.energy * 2.0 ** getattr(data, "exposure", 0.0)
    if not getattr(data, "normalize", True):
        watts *= _extent(data)
    return float(watts * luminance(colour * _emission(data)))


def _extent(data: Any) -> float:
    """By how much more a light shines whose power is that of each unit of its area."""
    if data.type == "SUN":
        return math.pi * math.sin(data.angle / 2) ** 2 or 1.0
    if data.type != "AREA":
        return 4 * math.pi * data.shadow_soft_size**2 or 4.0
    share = math.pi / 4 if data.shape in ("DISK", "ELLIPSE") else 1.0
    return float(data.size * _height(data) * share)


def _emission(data: Any) -> Any:
    """(3,) what the nodes of a light multiply its colour by, as far as they are constant."""
    tree = data.node_tree if data.use_nodes else None
    output = tree and tree.get_output_node("CYCLES")
    links = output.inputs["Surface"].links if output else ()
    if not links or links[0].from_node.type != "EMISSION":
        return np.ones(3)
    colour, strength = (links[0].from_node.inputs[name] for name in ("Color", "Strength"))
    grey = 1.0 if strength.links else float(strength.default_value)
    return grey * (np.ones(3) if colour.links else np.array(colour.default_value[:3]))


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
    edges = np.array([data.size * matrix[:3, 0], _height(data) * matrix[:3, 1]])
    return edges if np.linalg.norm(np.cross(*edges)) > 1e-12 else None


def _height(data: Any) -> float:
    return float(data.size_y if data.shape in ("RECTANGLE", "ELLIPSE") else data.size)


def _unit(vector: Any) -> Any:
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.array([0.0, 0.0, 1.0])
