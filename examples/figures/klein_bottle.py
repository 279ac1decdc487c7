"""The Klein bottle (paper, figure 2).

Its neck enters through its own side: dense undercuts behind the neck and white Mach bands in front
set the two apart, and the line of intersection is drawn.
"""

import bpy
import scenes


def build() -> None:
    """The bottle, seen so that the neck is seen to enter."""
    scenes.klein()
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.line_width_px, settings.feature_width_px = "SIDE", 4.0, 2.4
    settings.spacing_px, settings.undercut_px, settings.mach_band_px = 11.0, 22.0, 9.0
