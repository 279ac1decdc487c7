"""Tone from an image, in fine even hatches: as dark as the picture, without bands along folds."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.tone_source = "IMAGE"
settings.spacing_px = 5.0
settings.hatch_width_px = 1.2
settings.hatch_width_by_light = 0.7
settings.highlight_threshold = 0.9
settings.shadow_threshold = 0.5
settings.mach_bands = False
settings.undercuts = False
settings.line_width_px = 1.4
settings.feature_width_px = 1.0
