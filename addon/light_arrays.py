"""Blender's lights as arrays.

Strengths are the radiance that a white diffuse surface has in Cycles, facing the light: that of a
sun everywhere, that of other lights one unit away from them.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

LUMINANCE = (0.2126, 0.7152, 0.0722)


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

    def strength_at(self, place: Any) -> float:
        """What a surface at a place (3,) that faces the light receives, cones left aside."""
        if self.kind == "sun":
            return self.strength
        squared = float(np.sum((self.vector - place) ** 2))
        return self.strength / max(squared, 1e-12)


def read_light(data: Any, matrix: Any) -> LightArrays:
    """The light `data` placed by `matrix` (4, 4). Lights shine along their own -z."""
    watts = data.energy * 2.0 ** getattr(data, "exposure", 0.0)
    watts *= float(np.dot(LUMINANCE, data.color))
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
    return light


def exposed(lights: Iterable[LightArrays], place: Any) -> list[LightArrays]:
    """Those lights that shine, scaled so that the strongest gives 1 at a place (3,)."""
    lights = [light for light in lights if light.strength > 0]
    strongest = max((light.strength_at(place) for light in lights), default=0.0)
    for light in lights:
        light.strength /= strongest
    return lights


def _edges(data: Any, matrix: Any) -> Any:
    """(2, 3) sides of an area light, None where it has no extent."""
    height = data.size_y if data.shape in ("RECTANGLE", "ELLIPSE") else data.size
    edges = np.array([data.size * matrix[:3, 0], height * matrix[:3, 1]])
    return edges if np.linalg.norm(np.cross(*edges)) > 1e-12 else None


def _unit(vector: Any) -> Any:
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.array([0.0, 0.0, 1.0])
