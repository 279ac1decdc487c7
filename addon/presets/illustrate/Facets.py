"""Every edge between flat-shaded faces, as low polygons are meant."""

import bpy

settings = bpy.context.scene.illustrate
settings.restore_defaults()
settings.crease_angle = 0.0
