"""One pen of 0.3 mm on a page of 200 mm."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.unit = "MILLIMETRE"
settings.page_width_mm = 200.0
settings.line_width_mm = 0.3
settings.feature_width_mm = 0.3
settings.hatch_width_mm = 0.3
settings.hatch_width_by_light = 0.0
settings.spacing_mm = 1.2
settings.undercut_spacing_mm = 0.9
settings.min_length_mm = 1.5
settings.taper_mm = 0.0
