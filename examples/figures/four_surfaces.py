"""Four surfaces with one side (paper, figure 13).

Above the Roman surface and the Etruscan Venus, which pinch; below Boy's surface and Ida, swept by
the same ovals, lifted past each other: no more pinch points, and the surface passes through itself
in smooth lines.
"""

from typing import Any

import bpy
import formulas
import numpy as np
import scenes

BEND = 0.75  # as far as the pinch points need, and rounder than all the way


def build() -> None:
    """All four at one size, two above and two below."""
    places = {
        "Roman Surface": (formulas.romboy(0.0), (-1.0, 0.95)),
        "Etruscan Venus": (formulas.venus(0.0), (1.0, 0.95)),
        "Boy's Surface": (formulas.romboy(BEND), (-1.0, -0.95)),
        "Ida": (formulas.venus(BEND), (1.0, -0.95)),
    }
    things = [scenes.add(name, placed(*there)) for name, there in places.items()]
    scenes.finish(things, toward_camera=(0.0, -1.0, 0.0), size=(1600, 1550))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.line_width_px, settings.spacing_px = "SIDE", 3.2, 8.5
    settings.undercut_px, settings.mach_band_px = 14.0, 6.0


def placed(mesh: tuple[Any, Any], place: tuple[float, float]) -> tuple[Any, Any]:
    """The mesh as large as a ball of radius 1, leaning towards the viewer, at (x, z)."""
    positions, faces = mesh
    turn, lean = np.radians(20), np.radians(50)
    about = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    over = np.array([[1, 0, 0], [0, np.cos(lean), -np.sin(lean)], [0, np.sin(lean), np.cos(lean)]])
    turned = positions * (1, 1, 0.75) @ (over @ about).T
    turned -= (turned.min(axis=0) + turned.max(axis=0)) / 2
    return turned / np.linalg.norm(turned, axis=1).max() + (place[0], 0, place[1]), faces
