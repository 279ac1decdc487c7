"""Drapery: a cloth over a round table.

The cloth lies flat, turns over the edge and falls in folds that grow towards the hem; below it the
hatches follow the folds down.
"""

from typing import Any

import bpy
import formulas
import numpy as np
import scenes


def build() -> None:
    """Eleven folds, no two alike."""
    cloth = scenes.add("Cloth", table_cloth())
    ball = scenes.add("Ball", formulas.sphere(0.3))
    ball.location = (0.52, -0.05, 0.3)
    bowl = scenes.add("Goblet", formulas.goblet())
    scenes.subdivide(bowl)
    bowl.scale, bowl.location = (0.42,) * 3, (0.0, 0.0, 0.0)
    scenes.finish([cloth, ball, bowl], toward_camera=(0.25, -1.3, 0.55), size=(1400, 1450))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 8.0, 3.2
    settings.undercut_px, settings.mach_band_px = 16.0, 6.0


def table_cloth(rows: int = 120, columns: int = 360) -> tuple[Any, Any]:
    """Positions and quads; the middle is a small hole below the goblet."""
    s, a = np.meshgrid(np.linspace(0.02, 2.35, rows),
                       2 * np.pi * np.arange(columns) / columns, indexing="ij")  # fmt: skip
    bend, radius = 0.12, 1.0
    turn = np.clip((s - radius) / bend, 0, np.pi / 2 * 0.97)
    fallen = np.maximum(s - radius - bend * np.pi / 2 * 0.97, 0)
    rho = np.minimum(s, radius) + bend * np.sin(turn) + 0.05 * fallen
    z = -bend * (1 - np.cos(turn)) - fallen
    phase = 11 * a + 0.7 * np.sin(2 * a + 1) + 0.5 * np.sin(3 * a)
    depth = 0.15 * np.clip(fallen / 1.1, 0, 1) ** 0.8 * (1 + 0.3 * np.sin(2 * a))
    rho = rho + depth * np.cos(phase)
    around = a - 0.55 * depth * np.sin(2 * phase)
    z = z + 0.05 * fallen * np.sin(4 * a + 0.4)
    positions = np.stack([rho * np.cos(around), rho * np.sin(around), z], axis=-1)
    index = np.pad(np.arange(s.size).reshape(s.shape), ((0, 0), (0, 1)), mode="wrap")
    return positions.reshape(-1, 3), formulas.grid_quads(index)
