"""Anatomy: a rib cage.

Twelve pairs of ribs, the spine and the breastbone. Ribs behind ribs: silhouettes end where they
pass behind one another, to the pixel.
"""

from typing import Any

import bpy
import modelling
import numpy as np
import scenes


def build() -> None:
    """The ribs, the gristle that ties them to the breastbone, and twelve vertebrae."""
    things = []
    for number in range(12):
        for side in (-1, 1):
            path, thick = rib(number, side)
            things.append(scenes.add(f"Rib {number} {side}", modelling.tube(path, thick, 14)))
        things.append(scenes.add(f"Vertebra {number}", vertebra(number)))
    things.append(scenes.add("Breastbone", breastbone()))
    scenes.finish(things, toward_camera=(0.75, -1.4, 0.22), size=(1250, 1500))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 6.0, 2.6
    settings.undercut_px, settings.mach_band_px = 10.0, 4.0


def rib(number: int, side: int) -> tuple[Any, Any]:
    """Points along a rib from the spine to the front, and how thick it is there."""
    share = number / 11
    wide = 0.62 + 0.5 * np.sin(np.pi * min(share * 0.8 + 0.12, 0.5)) - 0.1 * share**3
    deep = 0.72 - 0.25 * (1 - share) ** 2
    reach = np.pi * (0.985 if number < 7 else 0.97 - 0.11 * (number - 6))
    angle = np.linspace(0.05, reach, 60)
    x = side * wide * np.sin(angle) ** 0.9
    y = deep * np.cos(angle)
    fall = 0.28 + 0.5 * share
    climb = np.clip((angle - 2.2) / 0.9, 0, 1) ** 2 * (0.15 + 0.75 * max(share - 0.25, 0))
    z = 1.9 - 2.2 * share - fall * (1 - np.cos(angle)) / 2 + climb
    thick = 0.052 * np.ones(60)
    thick[:8] *= np.linspace(1.2, 1, 8)
    thick[-7:] *= [0.97, 0.9, 0.82, 0.72, 0.6, 0.42, 0.05]
    return np.column_stack([x, y, z]), thick


def vertebra(number: int) -> modelling.Mesh:
    """A drum with a waist."""
    height = 1.93 - 2.2 * number / 11
    profile = [(0.01, -0.09), (0.13, -0.09), (0.15, -0.07), (0.12, 0), (0.15, 0.07), (0.13, 0.09)]
    positions, faces = modelling.turned([*profile, (0.01, 0.09)], 28)
    return positions + np.array((0, 0.78 - 0.22 * (1 - number / 11) ** 2, height)), faces


def breastbone() -> modelling.Mesh:
    """A flattened rod that narrows downward."""
    forward, height = np.linspace(-0.5, -0.74, 20), np.linspace(1.72, 0.45, 20)
    path = np.column_stack([np.zeros(20), forward, height])
    thick = 0.13 - 0.05 * np.sin(np.linspace(0, np.pi, 20)) ** 2
    thick[[0, -1]] *= 0.45
    positions, faces = modelling.tube(path, thick, 20)
    return positions * (1, 0.55, 1) + (0, -0.34, 0), faces
