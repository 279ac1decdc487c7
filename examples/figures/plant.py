"""A plant: a rosette of leaves.

Sixty leaves, each turned from the last by the golden angle. Dense undercuts below every leaf and
white bands along its edge keep them apart.
"""

from typing import Any

import bpy
import formulas
import numpy as np
import scenes

GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))
LEAVES = 60


def build() -> None:
    """Old leaves lie outside and low, young ones stand in the middle."""
    things = [scenes.add(f"Leaf {n}", leaf(n, n / (LEAVES - 1))) for n in range(LEAVES)]
    scenes.finish(things, toward_camera=(0.1, -0.75, 1.0), size=(1400, 1150))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 6.5, 2.6
    settings.undercut_px, settings.mach_band_px = 12.0, 4.0


def leaf(number: int, age: float) -> tuple[Any, Any]:
    """A pointed, hollow leaf; age from 0, the youngest, to 1."""
    along, across = np.meshgrid(np.linspace(0, 1, 25), np.linspace(-1, 1, 13), indexing="ij")
    length, rise = 0.35 + 0.95 * age**0.8, np.radians(80 - 68 * age**0.7)
    wide = 0.36 * length * np.sin(np.pi * along**0.75) ** 0.8 * (1 - 0.25 * along) + 0.006
    out = length * along
    lift = 0.10 * length * across**2 * np.sin(np.pi * along) + 0.22 * length * along**2
    heading = number * GOLDEN_ANGLE
    ahead = np.array([np.cos(heading), np.sin(heading), 0])
    side = np.array([-np.sin(heading), np.cos(heading), 0])
    up = np.array([0, 0, 1.0])
    stem = np.cos(rise) * ahead + np.sin(rise) * up
    over = np.cos(rise) * up - np.sin(rise) * ahead
    points = out[..., None] * stem + (wide * across)[..., None] * side + lift[..., None] * over
    points = points + 0.1 * age * ahead - 0.12 * age * up
    return points.reshape(-1, 3), formulas.grid_quads(np.arange(along.size).reshape(along.shape))
