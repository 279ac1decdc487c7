"""Fine lines and dense hatches down to the highlights."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.line_width_px = 1.4
settings.feature_width_px = 1.0
settings.spacing_px = 4.5
settings.undercut_spacing_px = 3.0
settings.hatch_width_px = 0.8
settings.hatch_width_by_light = 0.8
settings.highlight_threshold = 0.9
settings.shadow_threshold = 0.5
settings.mach_band_px = 3.0
settings.undercut_px = 8.0
settings.line_width_by_light = 0.4
settings.line_width_by_depth = 0.2
settings.inner_width_scale = 0.8
