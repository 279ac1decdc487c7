"""Export Drawing: the scene's drawing as a file for plotters, print and CAD."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

import os
from typing import Any

import bpy
from bpy.props import BoolProperty, StringProperty

from ..output.files import write_bytes
from ..reading.tone_images import tone_of
from ..running.bake import frames_of
from ..running.illustration import Illustration, computing, hatches_render, read_request
from ..running.jobs import Steps
from ..running.operators import DrawingOperator, still_there
from ..running.rendering import render_steps
from ..running.tasks import Task
from .plots import PLANNED, bytes_of, check_format, plot_of, summary


class ILLUSTRATE_OT_export_drawing(DrawingOperator, bpy.types.Operator):
    """Writes the scene's drawing on its page."""

    bl_idname = "illustrate.export_drawing"
    bl_label = "Export Drawing"
    bl_description = "Draw the scene and write it on its page, as SVG, PDF or DXF"
    bl_options = {"REGISTER"}

    filepath: StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE"})
    filter_glob: StringProperty(default="*.svg;*.pdf;*.dxf", options={"HIDDEN"})
    check_existing: BoolProperty(default=True, options={"HIDDEN"})
    sequence: BoolProperty(
        name="Sequence",
        default=False,
        description="All frames that Bake would draw: pages of a PDF, or an animated SVG",
    )

    def invoke(self, context: Any, _event: Any) -> set[str]:
        """Asks for the file."""
        if not self.filepath:
            stem = os.path.splitext(bpy.data.filepath)[0] or "drawing"
            self.filepath = f"{stem}.svg"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def task(self, context: Any) -> Task:
        """Draws, puts on paper and writes."""
        path = bpy.path.abspath(self.filepath)
        extension = os.path.splitext(path)[1][1:].lower()
        scene = context.scene
        check_format(scene, extension, self.sequence)
        name, rate = scene.name, scene.render.fps / scene.render.fps_base
        now = scene.frame_current
        frames = frames_of(scene) if self.sequence else range(now, now + 1)
        plots, warnings = yield from _plots(self, context, name, frames)
        write_bytes(path, bytes_of(extension, plots, rate=rate))
        PLANNED.remember(name, plots[0])
        return [*(("WARNING", warning) for warning in warnings), ("INFO", summary(path, plots))]


def _plots(
    operator: Any, context: Any, name: str, frames: range
) -> Steps[tuple[list[Any], list[str]]]:
    """Plots of frames, and warnings, each once; the frame that was shown is shown again."""
    scene = still_there(name)
    shown = scene.frame_current, scene.frame_subframe
    plots: list[Any] = []
    warnings: list[str] = []
    exposed: Any = None
    try:
        for done, frame in enumerate(frames):
            share = done / len(frames), (done + 1) / len(frames)
            if len(frames) > 1:
                still_there(name).frame_set(frame)
            made = yield from _drawn(operator, context, name, exposed, share)
            exposed = exposed or made.drawing
            plots.append(plot_of(still_there(name), made))
            found = [*made.warnings, *plots[-1].warnings]
            warnings += [warning for warning in found if warning not in warnings]
    finally:
        scene = bpy.data.scenes.get(name)
        if scene is not None and len(frames) > 1:
            scene.frame_set(shown[0], subframe=shown[1])
    return plots, warnings


def _drawn(
    operator: Any, context: Any, name: str, exposed: Any, share: tuple[float, float]
) -> Steps[Illustration]:
    """The illustration of the frame that is shown, with the light as strong as in another."""
    scene, rendered = still_there(name), None
    if hatches_render(scene.illustrate):
        rendered = yield from render_steps(scene, operator.is_modal, tone_of, share[0], share[0])
        scene = still_there(name)
    request = read_request(scene, context.evaluated_depsgraph_get(), rendered)
    request.expose_as(exposed)
    return (yield from computing(request, share))


register, unregister = bpy.utils.register_classes_factory((ILLUSTRATE_OT_export_drawing,))
