"""The operators: they join reading, drawing and writing."""

import time
from typing import Any

import bpy

from .illustration import illustrate
from .messages import IllustrateError, counted
from .output import write_drawing


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


def register() -> None:
    """Registers the operators."""
    bpy.utils.register_class(ILLUSTRATE_OT_illustrate)


def unregister() -> None:
    """Takes the operators away again."""
    bpy.utils.unregister_class(ILLUSTRATE_OT_illustrate)
