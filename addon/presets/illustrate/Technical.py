"""All edges, hidden ones thin, no hatching."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.hatching = False
settings.line_width_px = 2.5
settings.feature_width_px = 1.5
settings.taper_px = 0.0
settings.marks = True
settings.materials = True
settings.flat_outlines = True
settings.hidden = True
settings.hidden_layers = 64
settings.hidden_width_scale = 0.4
