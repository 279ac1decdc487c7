"""Hatches round a corner (paper, figure 10).

Three families of hatches meet where three walls do. No two fields of directions could be followed
through that point; a cross field can, since it tells hatches from cross-hatches nowhere.
"""

import bpy
import formulas
import scenes


def build() -> None:
    """The corner, seen along its diagonal, hatched in both directions."""
    corner = scenes.add("Corner", formulas.smooth_corner())
    scenes.finish([corner], toward_camera=(1.0, 0.9, 0.85), size=(1200, 1200))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.line_width_px, settings.spacing_px = "HEADLIGHT", 3.5, 14.0
    settings.highlight_threshold = settings.shadow_threshold = 1.0
    settings.hatch_width_px = 1.5
