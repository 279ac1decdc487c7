"""The panel Plot: page, pens, order, and Export Drawing."""

from typing import Any

import bpy

from ..plot.export import ILLUSTRATE_OT_export_drawing
from ..plot.pens import ILLUSTRATE_OT_edit_pens, ILLUSTRATE_UL_pens
from .panel import SidePanel
from .presets import ILLUSTRATE_PT_plot_presets

PEN_FIELDS = ("kinds", "target", "collection", "material", "dash_mm", "gap_mm", "pauses",
              "is_plotted", "is_tapered")  # fmt: skip
ONLY_WITH = {
    "size_mm": ("paper", "OWN"),
    "orientation": ("paper", None),
    "scale": ("fit", "scale"),
    "pen_width_mm": ("pens_by", "ONE"),
    "hidden_dash_mm": ("pens_by", "LINES"),
    "hidden_gap_mm": ("pens_by", "LINES"),
    "wet_mm": ("order", "wet"),
    "wet_passes": ("order", "wet"),
}
"""Settings that are shown only where another has a value; None: any but Own."""


def is_shown(chosen: Any, field: str) -> bool:
    """True where a setting counts."""
    other, value = ONLY_WITH.get(field, ("", ""))
    if not other:
        return True
    found = getattr(chosen, other)
    return bool(found != "OWN" if value is None else found == value)


class _Plot(SidePanel):
    """A closed panel of settings of the plot."""

    bl_options = {"DEFAULT_CLOSED"}
    fields: tuple[str, ...] = ()

    def draw(self, context: Any) -> None:
        """Shows the settings that count."""
        layout, chosen = self.layout, context.scene.illustrate_plot
        layout.use_property_split = True
        layout.use_property_decorate = False
        for field in self.fields:
            if is_shown(chosen, field):
                layout.column().prop(chosen, field)


class ILLUSTRATE_PT_plot(_Plot, bpy.types.Panel):
    """Page and file."""

    bl_idname = "ILLUSTRATE_PT_plot"
    bl_label = "Plot"
    bl_parent_id = "ILLUSTRATE_PT_main"
    fields = ("paper", "size_mm", "orientation", "margins_mm", "bleed_mm", "fit", "scale")

    def draw_header_preset(self, _context: Any) -> None:
        """Shows the presets."""
        ILLUSTRATE_PT_plot_presets.draw_panel_header(self.layout)

    def draw(self, context: Any) -> None:
        """Shows the page, the overlay's switches and the button."""
        _Plot.draw(self, context)
        row = self.layout.row(align=True)
        row.use_property_split = False
        row.prop(context.window_manager, "illustrate_show_page", toggle=True)
        row.prop(context.window_manager, "illustrate_show_travel", toggle=True)
        self.layout.operator(ILLUSTRATE_OT_export_drawing.bl_idname, icon="EXPORT")


class ILLUSTRATE_PT_pens(_Plot, bpy.types.Panel):
    """What draws what."""

    bl_idname = "ILLUSTRATE_PT_pens"
    bl_label = "Pens"
    bl_parent_id = "ILLUSTRATE_PT_plot"
    fields = ("fill_regions", "masks", "pens_by", "pen_width_mm", "hidden_dash_mm", "hidden_gap_mm")

    def draw(self, context: Any) -> None:
        """Shows the choice, and own pens as a list."""
        _Plot.draw(self, context)
        chosen = context.scene.illustrate_plot
        if chosen.pens_by != "OWN":
            return
        row = self.layout.row()
        row.template_list(
            ILLUSTRATE_UL_pens.bl_idname, "", chosen, "pens", chosen, "active_pen", rows=4
        )
        column = row.column(align=True)
        for action, icon in (("ADD", "ADD"), ("REMOVE", "REMOVE"), ("UP", "TRIA_UP"),
                             ("DOWN", "TRIA_DOWN")):  # fmt: skip
            button = column.operator(ILLUSTRATE_OT_edit_pens.bl_idname, text="", icon=icon)
            button.action = action
        if chosen.active_pen < len(chosen.pens):
            for field in PEN_FIELDS:
                self.layout.column().prop(chosen.pens[chosen.active_pen], field)


class ILLUSTRATE_PT_plot_order(_Plot, bpy.types.Panel):
    """Order, curves and the plotter's speed."""

    bl_idname = "ILLUSTRATE_PT_plot_order"
    bl_label = "Order"
    bl_parent_id = "ILLUSTRATE_PT_plot"
    fields = ("order", "wet_mm", "wet_passes", "tolerance_mm", "down_mm_s", "up_mm_s", "lift_s")


CLASSES = (ILLUSTRATE_PT_plot, ILLUSTRATE_PT_pens, ILLUSTRATE_PT_plot_order)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
