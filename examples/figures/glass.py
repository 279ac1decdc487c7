"""Glass: a jar that is seen through.

The jar has a style of its own, seen through: its outlines are drawn, it is not hatched, and it
hides nothing of the knot inside.
"""

import bpy
import formulas
import modelling
import scenes

JAR = [(0.02, -1.05), (0.95, -1.05), (1.05, -0.98), (1.08, -0.85), (1.08, 0.75), (1.0, 0.95)]
JAR += [(0.78, 1.08), (0.74, 1.15), (0.74, 1.3), (0.8, 1.33), (0.8, 1.38), (0.72, 1.38)]


def build() -> None:
    """A trefoil knot in a jar with a wide neck."""
    path = formulas.torus_knot(2, 3) * 0.58
    knot = scenes.add("Knot", modelling.tube(path, 0.125, 24, closed=True))
    knot.rotation_euler = (1.1, 0.15, 0.3)
    knot.location = (0, 0, -0.1)
    jar = scenes.add("Jar", modelling.turned(JAR, 64))
    jar.illustrate.use_own = jar.illustrate.see_through = True
    jar.illustrate.hatching = False
    scenes.finish([jar], toward_camera=(0.2, -1.4, 0.32), size=(1150, 1350))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 7.0, 3.0
    settings.undercut_px, settings.mach_band_px = 13.0, 5.0
