"""A portrait bust (in the place of the paper's figure 1).

Suzanne on a turned socle, in light from the side: cast shadows below the chin and on the socle, and
hatches that swell towards the dark.
"""

import bpy
import modelling
import scenes

SOCLE = [(0.05, 0), (0.85, 0), (0.88, 0.05), (0.85, 0.12), (0.7, 0.15), (0.62, 0.2), (0.5, 0.3)]
SOCLE += [(0.38, 0.45), (0.33, 0.62), (0.36, 0.75), (0.46, 0.82), (0.5, 0.88), (0.44, 0.95)]
SOCLE += [(0.3, 1.05), (0.26, 1.3), (0.3, 1.6), (0.36, 2.2)]


def build() -> None:
    """The head stands a little turned and bowed."""
    socle = scenes.add("Socle", modelling.turned(SOCLE))
    bpy.ops.mesh.primitive_monkey_add(location=(0, -0.05, 2.25), rotation=(-0.12, 0, 0.35))
    head = bpy.context.object
    scenes.subdivide(head)
    scenes.finish([socle, head], toward_camera=(0.15, -1.5, 0.22), size=(1100, 1500))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 8.0, 3.2
    settings.hatch_width_by_light, settings.line_width_by_light = 0.8, 0.4
    settings.undercut_px, settings.mach_band_px = 15.0, 6.0
