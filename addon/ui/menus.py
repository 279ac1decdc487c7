"""Entries in Blender's own menus: Render, and Object in the 3D viewport."""

from typing import Any

import bpy

from ..farm.operator import ILLUSTRATE_OT_import_frames
from ..plot.export import ILLUSTRATE_OT_export_drawing
from ..running.bake import ILLUSTRATE_OT_bake
from ..running.operators import ILLUSTRATE_OT_clear, ILLUSTRATE_OT_illustrate

MENUS = ("TOPBAR_MT_render", "VIEW3D_MT_object")


class ILLUSTRATE_MT_main(bpy.types.Menu):
    """All that the add-on does."""

    bl_idname = "ILLUSTRATE_MT_main"
    bl_label = "Illustrate"

    def draw(self, _context: Any) -> None:
        """Shows the operators."""
        # Else Blender calls `execute`, which waits for the drawing with the window frozen.
        self.layout.operator_context = "INVOKE_DEFAULT"
        self.layout.operator(ILLUSTRATE_OT_illustrate.bl_idname, icon="GREASEPENCIL")
        self.layout.operator(ILLUSTRATE_OT_bake.bl_idname, icon="RENDER_ANIMATION")
        self.layout.operator(ILLUSTRATE_OT_import_frames.bl_idname, icon="IMPORT")
        self.layout.operator(ILLUSTRATE_OT_export_drawing.bl_idname, icon="EXPORT")
        self.layout.operator(ILLUSTRATE_OT_clear.bl_idname)


def _entry(self: Any, _context: Any) -> None:
    self.layout.separator()
    self.layout.menu(ILLUSTRATE_MT_main.bl_idname, icon="GREASEPENCIL")


def register() -> None:
    """Registers the menu and hangs it into Blender's."""
    bpy.utils.register_class(ILLUSTRATE_MT_main)
    for name in MENUS:
        getattr(bpy.types, name).append(_entry)


def unregister() -> None:
    """Takes it out again."""
    for name in MENUS:
        getattr(bpy.types, name).remove(_entry)
    bpy.utils.unregister_class(ILLUSTRATE_MT_main)
