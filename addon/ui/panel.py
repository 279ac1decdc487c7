"""The tab "Illustrate" in the side panel of the 3D viewport."""

import textwrap
from typing import Any

import bpy

from ..messages import amount, said
from ..running.bake import ILLUSTRATE_OT_bake
from ..running.first_use import ILLUSTRATE_OT_reset, ILLUSTRATE_OT_set_up, missing
from ..running.operators import (
    ILLUSTRATE_OT_clear,
    ILLUSTRATE_OT_hide_field,
    ILLUSTRATE_OT_illustrate,
    ILLUSTRATE_OT_render_tone,
    ILLUSTRATE_OT_show_field,
)
from ..running.problems import slowing_problem, stopping_problem
from ..settings.native_options import DRAW, PREPARE
from ..settings.styles import OPTIONS as OBJECT_OPTIONS
from ..viewport.guiding import (
    ILLUSTRATE_OT_draw_guide,
    ILLUSTRATE_OT_hold_singularities,
    is_drawing_guide,
)
from ..viewport.live import LIVE
from ..viewport.live_view import VIEW, ILLUSTRATE_OT_keep_live
from ..viewport.paper import PAPER, ILLUSTRATE_OT_toggle_paper
from ..viewport.pick import (
    PICKER,
    ILLUSTRATE_OT_hide_hatches,
    ILLUSTRATE_OT_hide_stroke,
    ILLUSTRATE_OT_pick,
    thing_of,
)
from . import gallery
from .presets import ILLUSTRATE_PT_presets

PIXELS_PER_LETTER = 7.0  # of the interface's font at scale 1
OPTIONS = {option.key: option for option in (*PREPARE, *DRAW)}
NEEDS = {
    "suggestive_threshold": "suggestive_contours",
    "ridge_threshold": "ridges",
    "valley_threshold": "valleys",
    "hidden_layers": "hidden",
    "hidden_width_scale": "hidden",
    "mach_band_px": "mach_bands",
    "undercut_px": "undercuts",
    "undercut_contact": "undercuts",
    "undercut_spacing_px": "undercuts",
    "spacing_px": "hatching",
    "guide_weight": "guides",
    "guide_radius": "guides",
}
"""Settings that count for nothing without another: they are shown grey."""
OF_LIGHTS = ("lighting", "reflectance", "cast_shadows")
"""Settings that count for nothing where tone is from an image."""
UNUSED_WITH_TONES = {
    "LIGHT": ("highlight_share", "shadow_share"),
    "AREA": ("highlight_threshold", "shadow_threshold"),
}
"""Settings that are not shown."""


def fields_of(panel: str, *first: str) -> tuple[str, ...]:
    """Properties that belong to a panel: `first`, and those of its native options."""
    own = (key for key, option in OPTIONS.items() if option.panel == panel)
    return tuple(dict.fromkeys((*first, *own)))


class SidePanel:
    """Where the panels are."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Illustrate"
    layout: Any


class _Fields(SidePanel):
    """A closed panel that shows settings one below the other."""

    bl_parent_id = "ILLUSTRATE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}
    fields: tuple[str, ...] = ()

    def draw(self, context: Any) -> None:
        """Shows the fields."""
        show(self.layout, context.scene.illustrate, self.fields)


def show(layout: Any, settings: Any, fields: tuple[str, ...]) -> None:
    """Shows settings one below the other, lengths in the unit of the page."""
    layout.use_property_split = True
    layout.use_property_decorate = False
    for field in fields:
        if field in UNUSED_WITH_TONES[settings.tones]:
            continue
        if field == "tone_image":
            if settings.tone_source == "IMAGE":
                layout.template_ID(settings, field, open="image.open")
            continue
        key = field
        if settings.unit == "MILLIMETRE" and field in OPTIONS:
            key = OPTIONS[field].key_mm or field
        row = layout.row()
        row.active = field not in NEEDS or bool(getattr(settings, NEEDS[field]))
        if field in OF_LIGHTS:
            row.active = settings.tone_source == "LIGHTS"
        row.prop(settings, key)


def show_text(layout: Any, text: str, width_px: float, icon: str) -> None:
    """Shows a text in as many lines as it needs."""
    column = layout.column(align=True)
    letters = max(16, int(width_px / PIXELS_PER_LETTER))
    for number, line in enumerate(textwrap.wrap(text, letters)):
        column.label(text=line, icon="BLANK1" if number else icon)


def _told(picked: Any) -> str:
    """What a picked stroke is, and what stands before it."""
    kind, thing = said(picked.kind.capitalize().replace("_", " ")), picked.thing
    if not picked.layers:
        return said("{kind} of {thing}, visible", kind=kind, thing=thing)
    layers = amount(picked.layers, "surface")
    return said("{kind} of {thing}, behind {layers}", kind=kind, thing=thing, layers=layers)


def _show_problem(layout: Any, context: Any, problem: str) -> None:
    if problem:
        show_text(layout, problem, _room(context), "ERROR")


def _room(context: Any) -> float:
    """The width that a text has, in pixels of the interface at scale 1."""
    return float(context.region.width / context.preferences.system.ui_scale - 50)


def _show_live(layout: Any, context: Any) -> None:
    """The switch of the live drawing; while it is on, whose it is and what is in its way."""
    row = layout.row(align=True)
    row.use_property_split = False
    row.prop(context.window_manager, "illustrate_live", toggle=True, icon="HIDE_OFF")
    if VIEW.is_on:
        row.operator(ILLUSTRATE_OT_keep_live.bl_idname, icon="CHECKMARK")
        row.prop(context.window_manager, "illustrate_live_eye", text="")
        _show_problem(layout, context, LIVE.problem)


class ILLUSTRATE_PT_main(SidePanel, bpy.types.Panel):
    """The button, and what is changed most often."""

    bl_idname = "ILLUSTRATE_PT_main"
    bl_label = "Illustrate"
    fields = ("source", "line_width_px", "hatching", "spacing_px", "hidden")

    def draw_header_preset(self, _context: Any) -> None:
        """Shows the way back and the presets."""
        self.layout.operator(ILLUSTRATE_OT_reset.bl_idname, text="", icon="LOOP_BACK", emboss=False)
        ILLUSTRATE_PT_presets.draw_panel_header(self.layout)

    def draw(self, context: Any) -> None:
        """Shows the button, what is in its way, and the first settings."""
        row = self.layout.row()
        row.scale_y = 2.0
        row.operator(ILLUSTRATE_OT_illustrate.bl_idname, icon="GREASEPENCIL")
        row.operator(
            ILLUSTRATE_OT_toggle_paper.bl_idname,
            text="",
            icon="FILE",
            depress=PAPER.is_on(context.space_data),
        )
        scene, layer = context.scene, context.view_layer
        problem = stopping_problem(scene, layer) or slowing_problem(scene, layer)
        _show_problem(self.layout, context, problem)
        if missing(scene, layer):
            self.layout.operator(ILLUSTRATE_OT_set_up.bl_idname, icon="ADD")
        gallery.show(self.layout, context)
        show(self.layout, context.scene.illustrate, self.fields)
        _show_live(self.layout, context)


class ILLUSTRATE_PT_lines(_Fields, bpy.types.Panel):
    """Which lines are drawn."""

    bl_idname = "ILLUSTRATE_PT_lines"
    bl_label = "Lines"
    fields = fields_of("lines", "feature_width_px", "hidden_width_scale", "hidden_layers")


class ILLUSTRATE_PT_hatching(_Fields, bpy.types.Panel):
    """How hatches look."""

    bl_idname = "ILLUSTRATE_PT_hatching"
    bl_label = "Hatching"
    fields = fields_of("hatching")


class ILLUSTRATE_PT_light(_Fields, bpy.types.Panel):
    """Light and shadow."""

    bl_idname = "ILLUSTRATE_PT_light"
    bl_label = "Light"
    fields = fields_of(
        "light",
        "tone_source",
        "tone_image",
        "lighting",
        "auto_exposure",
        "tones",
        "highlight_share",
        "shadow_share",
    )

    def draw(self, context: Any) -> None:
        """Shows the fields, and the way to a render as tone."""
        _Fields.draw(self, context)
        self.layout.operator(ILLUSTRATE_OT_render_tone.bl_idname, icon="RENDER_STILL")


class ILLUSTRATE_PT_surface(_Fields, bpy.types.Panel):
    """What surfaces meshes stand for, and where hatches run."""

    bl_idname = "ILLUSTRATE_PT_surface"
    bl_label = "Surface and Field"
    fields = fields_of(
        "surface",
        "crease_angle",
        "cut_by_alpha",
        "scheme",
        "guides",
        "guide_weight",
        "guide_radius",
    )

    def draw(self, context: Any) -> None:
        """Shows the fields and what can be looked at."""
        _Fields.draw(self, context)
        row = self.layout.row(align=True)
        row.operator(ILLUSTRATE_OT_show_field.bl_idname)
        row.operator(ILLUSTRATE_OT_hide_field.bl_idname)
        self.layout.prop(context.window_manager, "illustrate_inspect")


class ILLUSTRATE_PT_hands(SidePanel, bpy.types.Panel):
    """A stroke that was picked, and guides."""

    bl_idname = "ILLUSTRATE_PT_hands"
    bl_label = "Hands On"
    bl_parent_id = "ILLUSTRATE_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Any) -> None:
        """Shows what the stroke is, and what can be done with it."""
        layout = self.layout
        layout.operator(ILLUSTRATE_OT_pick.bl_idname, icon="EYEDROPPER")
        picked, thing = PICKER.picked, thing_of(context.scene)
        if picked is not None:
            show_text(layout, _told(picked), _room(context), "CURVE_DATA")
            row = layout.row(align=True)
            row.operator(ILLUSTRATE_OT_hide_stroke.bl_idname)
            row.operator(ILLUSTRATE_OT_hide_hatches.bl_idname)
        if thing is not None:
            layout.prop(thing.illustrate, "use_own")
            column = layout.column()
            column.active = thing.illustrate.use_own
            for name in OBJECT_OPTIONS:
                column.prop(thing.illustrate, name)
        if is_drawing_guide(context):
            layout.operator(
                ILLUSTRATE_OT_draw_guide.bl_idname, text="End Drawing", icon="CHECKMARK"
            )
        else:
            layout.operator(ILLUSTRATE_OT_draw_guide.bl_idname, icon="GREASEPENCIL")
        layout.operator(ILLUSTRATE_OT_hold_singularities.bl_idname, icon="EMPTY_AXIS")


class ILLUSTRATE_PT_output(_Fields, bpy.types.Panel):
    """What strokes become."""

    bl_idname = "ILLUSTRATE_PT_output"
    bl_label = "Output"
    fields = (
        "output",
        "unit",
        "page_width_mm",
        "paper",
        "line_color",
        "feature_color",
        "hatch_color",
        "hidden_color",
        "fill_regions",
        "in_front",
        "keep_frames",
    )

    def draw(self, context: Any) -> None:
        """Shows the fields and the way back."""
        _Fields.draw(self, context)
        self.layout.operator(ILLUSTRATE_OT_clear.bl_idname)


class ILLUSTRATE_PT_animation(_Fields, bpy.types.Panel):
    """Frames into keyframes."""

    bl_idname = "ILLUSTRATE_PT_animation"
    bl_label = "Animation"
    fields = ("use_scene_range", "frame_start", "frame_end", "frame_step", "keep_strokes")

    def draw(self, context: Any) -> None:
        """Shows the range that is not the scene's only where it counts."""
        settings = context.scene.illustrate
        unused = ("frame_start", "frame_end") if settings.use_scene_range else ()
        show(self.layout, settings, tuple(field for field in self.fields if field not in unused))
        self.layout.operator(ILLUSTRATE_OT_bake.bl_idname, icon="RENDER_ANIMATION")


CLASSES = (
    ILLUSTRATE_PT_main,
    ILLUSTRATE_PT_lines,
    ILLUSTRATE_PT_hatching,
    ILLUSTRATE_PT_light,
    ILLUSTRATE_PT_surface,
    ILLUSTRATE_PT_hands,
    ILLUSTRATE_PT_output,
    ILLUSTRATE_PT_animation,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
