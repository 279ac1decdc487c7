"""Night: a lamp on a post.

One lamp is all the light: what is near it stays white, the hatches grow with the distance, and the
shadows of the posts run away from it. Shadows have one level more, along the diagonals.
"""

import bpy
import formulas
import modelling
import numpy as np
import scenes
from modelling import box

LAMP = [(0.02, 0), (0.09, 0), (0.16, 0.3), (0.2, 0.33), (0.2, 0.37), (0.05, 0.47), (0.02, 0.55)]
POST = [(0.22, 0), (0.22, 0.06), (0.12, 0.1), (0.08, 0.25), (0.05, 0.4), (0.045, 2.3), (0.1, 2.36)]
POST += [(0.1, 2.4), (0.02, 2.4)]


def build() -> None:
    """A street corner: the post, three bollards, a ball, and a wall behind."""
    things = [
        scenes.add("Post", modelling.turned(POST, 32)),
        scenes.add("Lamp", moved(modelling.turned(LAMP, 32), (0, 0, 2.4))),
        scenes.add("Ground", box((5, 4, 0.1), (0.3, 0, -0.05)), smooth=False),
        scenes.add("Wall", box((5, 0.15, 2.6), (0.3, 1.9, 1.3)), smooth=False),
    ]
    for x, y in ((-1.2, -0.7), (1.1, -0.9), (1.7, 0.6)):
        bollard = modelling.turned([(0.14, 0), (0.13, 0.55), (0.1, 0.64), (0.01, 0.67)], 32)
        things.append(scenes.add("Bollard", moved(bollard, (x, y, 0))))
    things.append(scenes.add("Ball", moved(formulas.sphere(0.3), (-0.75, 0.7, 0.3))))
    scenes.finish(things, toward_camera=(-0.35, -1.4, 0.5), size=(1400, 1250))
    bpy.data.objects.remove(bpy.data.objects["Sun"])
    light = bpy.data.objects.new("Light", bpy.data.lights.new("Light", "POINT"))
    light.data.energy, light.location = 300.0, (-0.35, -0.45, 2.15)
    bpy.context.scene.collection.objects.link(light)
    settings = bpy.context.scene.illustrate
    settings.spacing_px, settings.line_width_px, settings.extra_levels = 6.0, 2.6, 1
    settings.undercut_px, settings.mach_band_px = 9.0, 3.0


def moved(mesh: modelling.Mesh, way: tuple[float, float, float]) -> modelling.Mesh:
    """The mesh in another place."""
    return mesh[0] + np.array(way), mesh[1]
