"""Bold outlines and nothing else."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.hatching = False
settings.line_width_px = 3.0
settings.feature_width_px = 2.0
settings.taper_px = 20.0
