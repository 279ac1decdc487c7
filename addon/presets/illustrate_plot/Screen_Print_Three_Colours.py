"""Screen print: a film each for hatching, lines and outlines, as wide as strokes, bled."""

import bpy

plot = bpy.context.scene.illustrate_plot
plot.restore_defaults()
plot.paper = "A3"
plot.margins_mm = (0, 0, 0, 0)
plot.bleed_mm = 3
plot.fit = "fill"
plot.order = "drawing"
plot.pens_by = "OWN"
FILMS = {
    "Hatching": ((0.95, 0.55, 0.1), {"Hatch", "Cross-hatch", "Undercut"}),
    "Lines": ((0.1, 0.35, 0.7), {
        "Crease", "Intersection", "Mark", "Material", "Flat Outline", "Suggestive Contour",
        "Ridge", "Valley", "Loose Edge", "Terminator", "Shadow Outline",
    }),
    "Outline": ((0.05, 0.05, 0.05), {"Silhouette", "Boundary"}),
}  # fmt: skip
for name, (colour, kinds) in FILMS.items():
    pen = plot.pens.add()
    pen.name, pen.colour, pen.kinds, pen.is_tapered = name, colour, kinds, True
