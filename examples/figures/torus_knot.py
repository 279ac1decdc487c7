"""A knot, and what smooth silhouettes are (paper, figure 3).

Silhouettes of the smooth surface end in simple cusps, wherever one strand turns away behind itself;
none of them zigzags along the edges of the mesh, however near one looks.
"""

import bpy
import formulas
import modelling
import scenes


def build() -> None:
    """The knot that goes twice round and winds five times."""
    path = formulas.torus_knot(2, 5)
    knot = scenes.add("Knot", modelling.tube(path, 0.19, 24, closed=True))
    scenes.finish([knot], toward_camera=(0.25, -0.7, 1.0), size=(1400, 1300))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.line_width_px, settings.spacing_px = "SIDE", 4.0, 11.0
    settings.undercut_px, settings.mach_band_px = 20.0, 9.0
