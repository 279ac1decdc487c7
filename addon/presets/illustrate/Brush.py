"""Lines alone, as with a brush: heavy in the shadow and near the eye, fine inside."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.hatching = False
settings.line_width_px = 4.0
settings.feature_width_px = 2.5
settings.line_width_by_light = 0.6
settings.line_width_by_depth = 0.3
settings.inner_width_scale = 0.6
settings.taper_px = 20.0
