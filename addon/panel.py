"""The tab "Illustrate" in the side panel of the 3D viewport."""

from typing import Any

import bpy

from .operators import (
    ILLUSTRATE_OT_hide_field,
    ILLUSTRATE_OT_illustrate,
    ILLUSTRATE_OT_show_field,
)
from .settings import LINE_KINDS


class _SidePanel:
    """Where the panels are."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Illustrate"


class _Fields(_SidePanel):
    """A closed panel that shows settings one below the other."""

    bl_parent_id = "ILLUSTRATE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}
    fields: tuple[str, ...] = ()
    layout: Any

    def draw(self, context: Any) -> None:
        """Shows the fields."""
        _show(self.layout, context.scene.illustrate, self.fields)


def _show(layout: Any, settings: Any, fields: tuple[str, ...]) -> None:
    layout.use_property_split = True
    layout.use_property_decorate = False
    for field in fields:
        layout.prop(settings, field)


class ILLUSTRATE_PT_main(_SidePanel, bpy.types.Panel):
    """The button, and what is changed most often."""

    bl_idname = "ILLUSTRATE_PT_main"
    bl_label = "Illustrate"
    fields = ("source", "output", "lighting", "line_width_px", "hatching", "spacing_px")

    def draw(self, context: Any) -> None:
        """Shows the button and the first settings."""
        row = self.layout.row()
        row.scale_y = 2.0
        row.operator(ILLUSTRATE_OT_illustrate.bl_idname, icon="GREASEPENCIL")
        _show(self.layout, context.scene.illustrate, self.fields)


class ILLUSTRATE_PT_lines(_Fields, bpy.types.Panel):
    """Which lines are drawn."""

    bl_idname = "ILLUSTRATE_PT_lines"
    bl_label = "Lines"
    fields = (
        "feature_width_px",
        *LINE_KINDS,
        "hidden",
        "hidden_layers",
    )


class ILLUSTRATE_PT_hatching(_Fields, bpy.types.Panel):
    """Light and shadow."""

    bl_idname = "ILLUSTRATE_PT_hatching"
    bl_label = "Hatching"
    fields = (
        "hatch_width_px",
        "highlight_threshold",
        "shadow_threshold",
        "undercuts",
        "mach_bands",
    )


class ILLUSTRATE_PT_directions(_Fields, bpy.types.Panel):
    """Where hatches run."""

    bl_idname = "ILLUSTRATE_PT_directions"
    bl_label = "Hatch Directions"
    fields = (
        "guides",
        "guide_weight",
        "rings",
        "parabolic_ratio",
        "least_curvature",
        "largest_energy",
    )

    def draw(self, context: Any) -> None:
        """Shows the fields and the buttons for the overlay."""
        super().draw(context)
        row = self.layout.row(align=True)
        row.operator(ILLUSTRATE_OT_show_field.bl_idname)
        row.operator(ILLUSTRATE_OT_hide_field.bl_idname)


class ILLUSTRATE_PT_performance(_Fields, bpy.types.Panel):
    """How much is computed."""

    bl_idname = "ILLUSTRATE_PT_performance"
    bl_label = "Performance"
    fields = ("triangle_budget", "threads")


CLASSES = (
    ILLUSTRATE_PT_main,
    ILLUSTRATE_PT_lines,
    ILLUSTRATE_PT_hatching,
    ILLUSTRATE_PT_directions,
    ILLUSTRATE_PT_performance,
)


def register() -> None:
    """Registers the panels."""
    for panel in CLASSES:
        bpy.utils.register_class(panel)


def unregister() -> None:
    """Takes the panels away again."""
    for panel in reversed(CLASSES):
        bpy.utils.unregister_class(panel)
