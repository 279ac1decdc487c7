"""The rules of hatching (paper, figure 12).

Left: highlights, midtones and shadows have none, one and two directions of hatches. Middle: with
undercuts, dense hatches just behind a fold. Right: with Mach bands as well, white along its near
side.
"""

from typing import Any

import bpy
import scenes

PANELS: tuple[dict[str, Any], ...] = (
    {"undercuts": False, "mach_bands": False},
    {"mach_bands": False},
    {},
)


def build() -> None:
    """A cloth in folds that lie over each other."""
    scenes.drape()
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 820, 760
    settings = scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 7.0, 2.6
    settings.undercut_px, settings.mach_band_px = 16.0, 6.0
