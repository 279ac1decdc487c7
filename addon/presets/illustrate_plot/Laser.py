"""Laser cutter: outlines are cut last, red; all else is engraved, black."""

import bpy

plot = bpy.context.scene.illustrate_plot
plot.restore_defaults()
plot.paper = "A3"
plot.margins_mm = (5, 5, 5, 5)
plot.pens_by = "OWN"
engraved, cut = plot.pens.add(), plot.pens.add()
engraved.name, engraved.width_mm = "Engrave", 0.1
engraved.kinds = {
    "Crease", "Intersection", "Mark", "Material", "Flat Outline", "Suggestive Contour", "Ridge",
    "Valley", "Loose Edge", "Hatch", "Cross-hatch", "Undercut", "Terminator", "Shadow Outline",
}  # fmt: skip
cut.name, cut.width_mm, cut.colour = "Cut", 0.1, (1, 0, 0)
cut.kinds = {"Silhouette", "Boundary"}
plot.order = "shortest"
