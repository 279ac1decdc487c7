"""Export Drawing: the scene's drawing as a file for plotters, print and CAD."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

import os
from dataclasses import dataclass, field
from typing import Any

import bpy
from bpy.props import BoolProperty, StringProperty

from ..messages import amount
from ..output.files import write_bytes
from ..reading.tone_images import tone_of
from ..running.bake import frames_of
from ..running.illustration import Illustration, computing, hatches_render, read_request
from ..running.jobs import Moment, Step, Steps
from ..running.operators import DrawingOperator, still_there
from ..running.rendering import render_steps
from ..running.tasks import Task
from .areas import areas_of
from .plots import PLANNED, bytes_of, check_plot, masks_of, plot_of, summary


class ILLUSTRATE_OT_export_drawing(DrawingOperator, bpy.types.Operator):
    """Writes the scene's drawing on its page."""

    bl_idname = "illustrate.export_drawing"
    bl_label = "Export Drawing"
    bl_description = "Draw the scene and write it on its page, as SVG, PDF or DXF"
    bl_options = {"REGISTER"}

    filepath: StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE"})
    filter_glob: StringProperty(default="*.svg;*.pdf;*.dxf", options={"HIDDEN"})
    check_existing: BoolProperty(default=True, options={"HIDDEN"})
    is_asked = False  # whether the artist was asked for the file
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
        self.is_asked = True
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        """Exports beside Blender where the artist has named the file, else at once."""
        if self.is_asked:
            return DrawingOperator.invoke(self, context, None)
        return DrawingOperator.execute(self, context)

    def task(self, context: Any) -> Task:
        """Draws, puts on paper and writes."""
        path = bpy.path.abspath(self.filepath)
        extension = os.path.splitext(path)[1][1:].lower()
        scene = context.scene
        check_plot(scene, extension, self.sequence)
        name, rate = scene.name, scene.render.fps / scene.render.fps_base
        now = scene.frame_current
        frames = frames_of(scene) if self.sequence else range(now, now + 1)
        made = yield from _made(self, context, name, frames, path)
        yield Step(Moment("file"), 1.0)
        write_bytes(path, bytes_of(extension, made.plots, rate=rate))
        for mask, data in made.masks.items():
            write_bytes(os.path.join(os.path.dirname(path), mask), data)
        PLANNED.remember(name, made.plots[0])
        told = summary(path, made.plots)
        told += f", {amount(len(made.masks), 'mask')}" if made.masks else ""
        return [*(("WARNING", warning) for warning in made.warnings), ("INFO", told)]


@dataclass
class _Made:
    """What is to be written and said."""

    plots: list[Any] = field(default_factory=list)
    masks: dict[str, bytes] = field(default_factory=dict)  # by the names of files
    warnings: list[str] = field(default_factory=list)  # each once


def _made(operator: Any, context: Any, name: str, frames: range, path: str) -> Steps[_Made]:
    """Plots and masks of frames; the frame that was shown is shown again."""
    scene = still_there(name)
    shown = scene.frame_current, scene.frame_subframe
    stem = os.path.splitext(os.path.basename(path))[0]
    made, exposed = _Made(), None
    try:
        for done, frame in enumerate(frames):
            share = done / len(frames), (done + 1) / len(frames)
            if len(frames) > 1:
                still_there(name).frame_set(frame)
            drawn = yield from _drawn(operator, context, name, exposed, share)
            exposed = exposed or drawn.drawing
            numbered = f"{stem}_{frame:04d}" if len(frames) > 1 else stem
            yield from _put_on_paper(name, drawn, share[1], numbered, made)
    finally:
        scene = bpy.data.scenes.get(name)
        if scene is not None and len(frames) > 1:
            scene.frame_set(shown[0], subframe=shown[1])
    return made


def _put_on_paper(
    name: str, drawn: Illustration, share: float, stem: str, made: _Made
) -> Steps[None]:
    """Adds the plot of a drawing, in pieces between which ESC is heard."""
    chosen = still_there(name).illustrate_plot
    if chosen.fill_regions or chosen.masks:
        yield Step(Moment("areas"), share, share)
        areas_of(still_there(name), drawn)
    yield Step(Moment("order"), share, share)
    plot = plot_of(still_there(name), drawn)
    for layer in plot.layers:
        yield Step(Moment("curves"), share, share)
        plot.curves(layer)
    if chosen.masks:
        made.masks |= masks_of(still_there(name), drawn, stem)
    made.plots.append(plot)
    found = [*drawn.warnings, *plot.warnings]
    made.warnings += [warning for warning in found if warning not in made.warnings]


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
