"""AxiDraw on A4 with one pen of 0.3 mm."""

import bpy

plot = bpy.context.scene.illustrate_plot
plot.restore_defaults()
plot.paper = "A4"
plot.margins_mm = (10, 10, 10, 10)
plot.pens_by = "ONE"
plot.pen_width_mm = 0.3
plot.order = "shortest"
