"""Three pens of ISO 128: outlines 0.7, other lines 0.35, hatches 0.18 mm."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.unit = "MILLIMETRE"
settings.line_width_mm = 0.7
settings.feature_width_mm = 0.35
settings.hatch_width_mm = 0.18
settings.hatch_width_by_light = 0.0
settings.hidden_width_scale = 0.5
settings.spacing_mm = 0.9
settings.undercut_spacing_mm = 0.6
settings.min_length_mm = 1.5
settings.taper_mm = 0.0
