"""The list of own pens: adding, removing and moving."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import EnumProperty

ACTIONS = [
    ("ADD", "Add", "Add a pen", 0),
    ("REMOVE", "Remove", "Remove the pen", 1),
    ("UP", "Up", "Draw with the pen before the one above it", 2),
    ("DOWN", "Down", "Draw with the pen after the one below it", 3),
]


class ILLUSTRATE_OT_edit_pens(bpy.types.Operator):
    """Changes the list of own pens."""

    bl_idname = "illustrate.edit_pens"
    bl_label = "Edit Pens"
    bl_description = "Change the list of pens"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    action: EnumProperty(items=ACTIONS, options={"SKIP_SAVE"})

    def execute(self, context: Any) -> set[str]:
        """Does what the button says; at the ends of the list nothing."""
        chosen = context.scene.illustrate_plot
        active, count = chosen.active_pen, len(chosen.pens)
        if self.action == "ADD":
            pen = chosen.pens.add()
            pen.name = f"Pen {count + 1}"
            chosen.active_pen = count
        elif self.action == "REMOVE" and count:
            chosen.pens.remove(active)
            chosen.active_pen = min(active, max(count - 2, 0))
        elif self.action in ("UP", "DOWN"):
            target = active + (1 if self.action == "DOWN" else -1)
            if 0 <= target < count:
                chosen.pens.move(active, target)
                chosen.active_pen = target
        return {"FINISHED"}


class ILLUSTRATE_UL_pens(bpy.types.UIList):
    """The pens, first drawn on top."""

    bl_idname = "ILLUSTRATE_UL_pens"

    def draw_item(
        self,
        _context: Any,
        layout: Any,
        _data: Any,
        pen: Any,
        _icon: Any,
        _active_data: Any,
        _active_name: str,
    ) -> None:
        """Shows colour, name and width."""
        row = layout.row(align=True)
        colour = row.row()
        colour.scale_x = 0.25
        colour.prop(pen, "colour", text="")
        row.prop(pen, "name", text="", emboss=False)
        row.prop(pen, "width_mm", text="", emboss=False)


register, unregister = bpy.utils.register_classes_factory(
    (ILLUSTRATE_OT_edit_pens, ILLUSTRATE_UL_pens)
)
