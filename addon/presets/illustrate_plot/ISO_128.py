"""ISO 128: outlines 0.7, other lines 0.35, hatches 0.18 mm, dashes of twelve widths."""

import bpy

plot = bpy.context.scene.illustrate_plot
plot.restore_defaults()
plot.paper = "A3"
plot.orientation = "landscape"
plot.margins_mm = (20, 10, 10, 10)
plot.pens_by = "OWN"
LINES = {
    "Hidden": (0.35, {"Hidden"}),
    "Hatching": (0.18, {"Hatch", "Cross-hatch", "Undercut"}),
    "Outline": (0.7, {"Silhouette", "Boundary"}),
    "Edges": (0.35, set()),
}
for name, (width, kinds) in LINES.items():
    pen = plot.pens.add()
    pen.name, pen.width_mm, pen.kinds = name, width, kinds
plot.pens[0].dash_mm, plot.pens[0].gap_mm = 12 * 0.35, 3 * 0.35
