"""Bold outlines, open hatches that swell, wide bands behind folds."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.line_width_px = 3.0
settings.feature_width_px = 1.6
settings.spacing_px = 12.0
settings.undercut_spacing_px = 6.0
settings.hatch_width_px = 1.2
settings.hatch_width_by_light = 0.6
settings.highlight_threshold = 0.65
settings.shadow_threshold = 0.25
settings.mach_band_px = 6.0
settings.undercut_px = 14.0
settings.taper_px = 12.0
settings.line_width_by_light = 0.3
settings.inner_width_scale = 0.7
