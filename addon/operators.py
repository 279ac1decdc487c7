"""The operators: they join reading, drawing and writing."""

import time
from typing import Any

import bpy

from .illustration import illustrate, prepare_scene
from .messages import IllustrateError, counted
from .output import field_overlay, write_drawing


class ILLUSTRATE_OT_illustrate(bpy.types.Operator):
    """Writes the scene's illustration."""

    bl_idname = "illustrate.illustrate"
    bl_label = "Illustrate"
    bl_description = "Draw the scene as its camera sees it, in place of the last illustration"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        """Does the whole job; an error leaves the scene as it was."""
        scene, start = context.scene, time.perf_counter()
        try:
            made = illustrate(scene, context.evaluated_depsgraph_get())
            write_drawing(scene, made.drawing, made.arrays.camera, scene.illustrate.output)
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for warning in made.warnings:
            self.report({"WARNING"}, warning)
        self.report(
            {"INFO"},
            f"Illustrated {counted(len(made.names), 'object')}: "
            f"{counted(len(made.drawing.kinds), 'stroke')} in "
            f"{time.perf_counter() - start:.2f} s",
        )
        return {"FINISHED"}


class ILLUSTRATE_OT_show_field(bpy.types.Operator):
    """Shows the field that hatches follow."""

    bl_idname = "illustrate.show_field"
    bl_label = "Show Field"
    bl_description = (
        "Show the directions that hatches follow as crosses on the surfaces, with a red or blue "
        "mark where they turn round a point"
    )
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        """Puts the field in place of the one shown last; an error leaves the scene as it was."""
        try:
            prepared = prepare_scene(context.scene, context.evaluated_depsgraph_get())
            field_overlay.write(context.scene, prepared.surface, prepared.field)
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        count = len(prepared.field.singular_indices)
        self.report({"INFO"}, f"The field has {counted(count, 'singularity', 'singularities')}")
        return {"FINISHED"}


class ILLUSTRATE_OT_hide_field(bpy.types.Operator):
    """Takes the shown field away."""

    bl_idname = "illustrate.hide_field"
    bl_label = "Hide Field"
    bl_description = "Take the crosses that show the field away"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a field to be hidden."""
        return field_overlay.find(context.scene) is not None

    def execute(self, context: Any) -> set[str]:
        """Removes what Show Field made."""
        field_overlay.clear(context.scene)
        return {"FINISHED"}


CLASSES = (ILLUSTRATE_OT_illustrate, ILLUSTRATE_OT_show_field, ILLUSTRATE_OT_hide_field)


def register() -> None:
    """Registers the operators."""
    for operator in CLASSES:
        bpy.utils.register_class(operator)


def unregister() -> None:
    """Takes the operators away again."""
    for operator in reversed(CLASSES):
        bpy.utils.unregister_class(operator)
