"""A torus bent into a smile (paper, figure 4).

A coarse mesh of quads stands for a smooth surface: the silhouettes are those of the surface,
without the corners of the mesh.
"""

import bpy
import formulas
import numpy as np
import scenes


def build() -> None:
    """A torus whose ends are pulled up and forward."""
    positions, faces = formulas.torus(1.0, 0.36, rows=24, columns=10)
    bend = np.array([1.35, 1.0, 1.0]) * positions
    bend[:, 2] += 0.42 * positions[:, 0] ** 2
    bend[:, 1] -= 0.3 * positions[:, 0] ** 2
    torus = scenes.add("Torus", (bend, faces))
    scenes.subdivide(torus)
    scenes.finish([torus], toward_camera=(0.12, -1.0, 0.55), size=(1500, 850))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.line_width_px, settings.spacing_px = "SIDE", 4.0, 12.0
    settings.undercut_px, settings.mach_band_px = 20.0, 9.0
