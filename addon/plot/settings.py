"""The settings of a plot: paper, pens, order; `scene.illustrate_plot`."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

PAPERS = [
    *((name, name, f"{name} paper", i) for i, name in enumerate(
        ("A0", "A1", "A2", "A3", "A4", "A5", "A6", "Letter", "Legal", "Tabloid"))),
    ("OWN", "Own", "Paper of the size below", 20),
]  # fmt: skip
ORIENTATIONS = [
    ("auto", "Automatic", "Lay the paper as the picture is", 0),
    ("portrait", "Portrait", "Higher than wide", 1),
    ("landscape", "Landscape", "Wider than high", 2),
]
FITS = [
    ("frame", "Frame", "The whole picture between the margins", 0),
    ("fill", "Fill", "The picture over all of the page that is printed", 1),
    ("lines", "Lines", "What is drawn, as large as it is between the margins", 2),
    ("scale", "Scale", "So many times smaller than the scene; of parallel cameras", 3),
]
ORDERS = [
    ("shortest", "Shortest Way", "With the pen up for as short as can be", 0),
    ("drawing", "As Drawn", "In the order of the drawing", 1),
    ("wet", "Wet Ink", "Lines near each other one pass later, so that ink dries", 2),
]
PENS = [
    ("LINES", "By Line", "A pen each for outlines, other lines, hatching and hidden lines", 0),
    ("ONE", "One Pen", "One pen for everything", 1),
    ("OWN", "Own Pens", "The pens of the list below", 2),
]
KINDS = (
    "Silhouette", "Boundary", "Crease", "Intersection", "Mark", "Material", "Flat Outline",
    "Suggestive Contour", "Ridge", "Valley", "Loose Edge", "Hatch", "Cross-hatch", "Undercut",
    "Hidden", "Terminator", "Shadow Outline",
)  # fmt: skip
"""Titles of groups of lines; a pen keeps its choice as bits in this order."""


def _mm(name: str, default: float, text: str, least: float = 0.0) -> Any:
    return FloatProperty(
        name=name, default=default, min=least, soft_max=100.0, description=f"{text}, millimetres"
    )


class ILLUSTRATE_PG_pen(bpy.types.PropertyGroup):
    """What draws a layer."""

    name: StringProperty(name="Name", default="Pen", description="Name of the layer")
    width_mm: _mm("Width", 0.3, "How wide the pen draws")
    colour: FloatVectorProperty(
        name="Colour", size=3, default=(0.0, 0.0, 0.0), min=0.0, max=1.0, subtype="COLOR_GAMMA",
        description="Colour of the layer",
    )  # fmt: skip
    pauses: BoolProperty(
        name="Pause", default=False, description="Stop before it, for the pen to be changed"
    )
    is_plotted: BoolProperty(
        name="Plot", default=True, description="Plot the layer, not only show it"
    )
    is_tapered: BoolProperty(
        name="Tapered", default=False, description="Filled outlines as wide as strokes, for print"
    )
    dash_mm: _mm("Dash", 0.0, "Length of dashes, 0 for whole lines")
    gap_mm: _mm("Gap", 1.0, "Length of gaps between dashes")
    kinds: EnumProperty(
        name="Lines",
        items=[(kind, kind, f"{kind} lines", 1 << i) for i, kind in enumerate(KINDS)],
        options={"ENUM_FLAG"},
        description="Which lines it draws; none chosen: all that no pen above draws",
    )
    target: PointerProperty(
        type=bpy.types.Object, name="Object", description="Draw the lines of this object only"
    )
    material: PointerProperty(
        type=bpy.types.Material,
        name="Material",
        description="Draw the lines on faces of this material only",
    )
    collection: PointerProperty(
        type=bpy.types.Collection,
        name="Collection",
        description="Draw the lines of this collection's objects only",
    )


class ILLUSTRATE_PG_plot(bpy.types.PropertyGroup):
    """How a drawing is put on paper."""

    paper: EnumProperty(name="Paper", items=PAPERS, default="A4", description="Size of the page")
    size_mm: FloatVectorProperty(
        name="Size", size=2, default=(210.0, 297.0), min=1.0, soft_max=2000.0,
        description="Width and height of own paper, millimetres",
    )  # fmt: skip
    orientation: EnumProperty(
        name="Orientation", items=ORIENTATIONS, default="auto", description="How the paper lies"
    )
    margins_mm: FloatVectorProperty(
        name="Margins", size=4, default=(10.0,) * 4, min=0.0, soft_max=100.0,
        description="Left, top, right, bottom: nothing is drawn there, millimetres",
    )  # fmt: skip
    bleed_mm: _mm("Bleed", 0.0, "How far print goes on beyond edges without a margin")
    fit: EnumProperty(name="Fit", items=FITS, default="frame", description="How large it is drawn")
    scale: FloatProperty(
        name="Scale 1:", default=50.0, min=1e-6, soft_max=1000.0,
        description="How many times smaller than the scene the drawing is",
    )  # fmt: skip
    fill_regions: BoolProperty(
        name="Fill Objects",
        default=False,
        description="Fill what is seen of objects with their materials' colours, below the lines",
    )
    masks: BoolProperty(
        name="Masks",
        default=False,
        description="Write an image beside the file for each object and material, white where it "
        "is seen",
    )
    pens_by: EnumProperty(name="Pens", items=PENS, default="LINES", description="What draws what")
    pen_width_mm: _mm("Pen Width", 0.3, "How wide the only pen draws")
    hidden_dash_mm: _mm("Hidden Dash", 2.0, "Dashes of hidden lines, 0 for whole lines")
    hidden_gap_mm: _mm("Hidden Gap", 1.0, "Gaps between dashes of hidden lines")
    pens: CollectionProperty(type=ILLUSTRATE_PG_pen, name="Pens")
    active_pen: IntProperty(name="Active Pen", default=0, options={"HIDDEN"})
    order: EnumProperty(
        name="Order", items=ORDERS, default="shortest", description="Which stroke is drawn next"
    )
    wet_mm: _mm("Wet Within", 2.0, "Lines nearer than this are drawn in another pass", 0.1)
    wet_passes: IntProperty(
        name="Passes", default=4, min=1, max=100, description="How often the pen goes over the page"
    )
    tolerance_mm: _mm("Curves Within", 0.02, "How far curves may be off, 0 for straight pieces")
    down_mm_s: _mm("Drawing Speed", 50.0, "How far the lowered pen goes in a second", 0.001)
    up_mm_s: _mm("Travel Speed", 150.0, "How far the lifted pen goes in a second", 0.001)
    lift_s: FloatProperty(
        name="Lift", default=0.3, min=0.0, soft_max=5.0, subtype="TIME_ABSOLUTE", unit="NONE",
        description="Seconds that lifting and lowering the pen take",
    )  # fmt: skip

    def restore_defaults(self) -> None:
        """Sets all that presets hold to what it is in a new scene."""
        for name in preset_fields():
            self.property_unset(name)
        self.pens.clear()


def preset_fields() -> list[str]:
    """Names of the settings that a preset holds."""
    return [name for name in ILLUSTRATE_PG_plot.__annotations__ if name != "active_pen"]


CLASSES = (ILLUSTRATE_PG_pen, ILLUSTRATE_PG_plot)


def register() -> None:
    """Puts the settings on every scene."""
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.illustrate_plot = PointerProperty(type=ILLUSTRATE_PG_plot)


def unregister() -> None:
    """Takes the settings away again."""
    del bpy.types.Scene.illustrate_plot
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
