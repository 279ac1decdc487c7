"""Where pipes meet.

Two, three and six pipes, each joint one smooth surface. Far from the joint hatches run round the
pipes and along them; between two pipes they pass from one round to the other, and the places where
neither can go on hide in the crotches.
"""

import bpy
import modelling
import scenes
from mathutils import Matrix

ARM = 2  # cubes
JOINTS = (
    ("Bend", ((1, 0, 0), (0, 0, 1))),
    ("Branch", ((1, 0, 0), (-1, 0, 0), (0, 0, 1))),
    ("Star", ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))),
)
PLACES = ((-5.0, -1.9, -0.4), (-0.2, 0, -0.4), (5.3, 2.0, 0.2))


def build() -> None:
    """Three joints side by side, each a heap of cubes that is subdivided."""
    joints = []
    for (name, arms), place in zip(JOINTS, PLACES, strict=True):
        cells = [(x * n, y * n, z * n) for x, y, z in arms for n in range(ARM + 1)]
        joint = scenes.add(name, modelling.blocks(cells))
        joint.matrix_world = Matrix.Translation(place)
        scenes.subdivide(joint)
        joints.append(joint)
    scenes.finish(joints, toward_camera=(0.5, -1.3, 0.75), size=(1500, 560))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 8.0, 2.8
