"""Import Illustration Frames: the artist's way to what `illustrate merge` does."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import BoolProperty, StringProperty

from ..messages import IllustrateError, amount, said
from ..running.tasks import is_running
from .merge import find_frames, merge


class ILLUSTRATE_OT_import_frames(bpy.types.Operator):
    """Makes keyframes of the JSON files of drawn frames."""

    bl_idname = "illustrate.import_frames"
    bl_label = "Import Illustration Frames"
    bl_description = (
        "Make a keyframe of each JSON file in a folder of drawn frames; frames with strokes of "
        "yours are left as they are"
    )
    bl_options = {"REGISTER", "UNDO"}

    directory: StringProperty(subtype="DIR_PATH", options={"SKIP_SAVE"})
    filter_folder: BoolProperty(default=True, options={"HIDDEN", "SKIP_SAVE"})
    partial: BoolProperty(
        name="Partial",
        default=False,
        description="Take what is whole and of the same settings, though some frames are not",
    )

    @classmethod
    def poll(cls, _context: Any) -> bool:
        """Not while a drawing is made."""
        return not is_running()

    def invoke(self, context: Any, _event: Any) -> set[str]:
        """Asks for the folder."""
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        """Merges into the scene."""
        try:
            found = find_frames(bpy.path.abspath(self.directory))
            warnings = merge(context.scene, found, self.partial)
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for warning in warnings:
            self.report({"WARNING"}, warning)
        frames = amount(len(found.sheets), "frame")
        self.report({"INFO"}, said("Imported {frames}", frames=frames))
        return {"FINISHED"}


register, unregister = bpy.utils.register_classes_factory((ILLUSTRATE_OT_import_frames,))
