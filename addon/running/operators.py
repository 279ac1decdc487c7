"""The operators: they join reading, drawing and writing."""

import time
from typing import Any

import bpy

from .. import output
from ..messages import IllustrateError, amount, said
from ..output import field_overlay
from ..plot.areas import check_fills, fills_of
from ..reading.tone_images import tone_of
from ..viewport.inspect import INSPECTOR
from ..viewport.paper import offer
from .illustration import (
    Illustration,
    computing,
    hatches_render,
    preparing,
    read_request,
    start_preparing,
)
from .jobs import Step
from .problems import stopping_problem
from .rendering import kept, render_steps
from .tasks import Task, TaskOperator, is_running

RENDERING = 0.5  # share of the progress that a render has


class DrawingOperator(TaskOperator):
    """Mixin of tasks that draw: one at a time, and only where there is something to draw."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """True when a drawing can be made; else the operator's button says why it is grey."""
        problem = said("An illustration is being drawn: ESC cancels it") if is_running() else ""
        problem = problem or stopping_problem(context.scene, context.view_layer)
        if problem:
            cls.poll_message_set(problem)  # type: ignore[attr-defined]
        return not problem


class ILLUSTRATE_OT_illustrate(DrawingOperator, bpy.types.Operator):
    """Writes the scene's illustration."""

    bl_idname = "illustrate.illustrate"
    bl_label = "Illustrate"
    bl_description = "Draw the scene as its camera sees it, in place of the last illustration"

    def task(self, context: Any) -> Task:
        """Renders where that is asked for, reads, draws beside Blender, writes."""
        scene, start = context.scene, time.perf_counter()
        name, rendered, begun = scene.name, None, 0.0
        check_fills(scene)
        if hatches_render(scene.illustrate):
            rendered = yield from render_steps(scene, self.is_modal, tone_of, 0.0, RENDERING)
            scene, begun = still_there(name), RENDERING
        request = read_request(scene, context.evaluated_depsgraph_get(), rendered)
        INSPECTOR.let_go()
        made = yield from computing(request, (begun, 1.0))
        scene = still_there(request.scene_name)
        output.write_drawing(
            scene,
            made.drawing,
            made.arrays.camera,
            scene.illustrate.output,
            made.names,
            fills_of(scene, made),
        )
        INSPECTOR.remember(made)
        if self.is_modal:
            offer(context)
        return reports(made, time.perf_counter() - start)


def reports(made: Illustration, seconds: float) -> list[tuple[str, str]]:
    """What the artist is told: warnings, and what was done."""
    done = said(
        "Illustrated {objects}: {strokes} in {seconds:.2f} s",
        objects=amount(len(made.names), "object"),
        strokes=amount(len(made.drawing.kinds), "stroke"),
        seconds=seconds,
    )
    return [*(("WARNING", warning) for warning in made.warnings), ("INFO", done)]


def still_there(scene_name: str) -> Any:
    """The scene after a while in which anything may have happened."""
    # By name: after an undo or a loaded file old references are of data that is gone.
    scene = bpy.data.scenes.get(scene_name)
    if scene is None:
        raise IllustrateError(
            said('Scene "{scene}" is gone: its illustration is not written', scene=scene_name)
        )
    return scene


class ILLUSTRATE_OT_render_tone(DrawingOperator, bpy.types.Operator):
    """Hatches a render, and keeps it for more drawings."""

    bl_idname = "illustrate.render_tone"
    bl_label = "Render and Hatch"
    bl_description = (
        "Render the scene with its own engine, keep the picture as the image that tone is from, "
        "and draw"
    )

    def task(self, context: Any) -> Task:
        """Renders, then draws as the first button does."""
        scene_name = context.scene.name
        image = yield from render_steps(context.scene, self.is_modal, kept, 0.0, RENDERING)
        chosen = still_there(scene_name).illustrate
        chosen.tone_source, chosen.tone_image = "IMAGE", bpy.data.images[image]
        return (yield from ILLUSTRATE_OT_illustrate.task(self, context))


class ILLUSTRATE_OT_clear(bpy.types.Operator):
    """Takes the illustration away."""

    bl_idname = "illustrate.clear"
    bl_label = "Clear Illustration"
    bl_description = "Remove the strokes that Illustrate drew, on all frames, and nothing else"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is one."""
        return output.has_illustration(context.scene)

    def execute(self, context: Any) -> set[str]:
        """Removes what carries the add-on's mark."""
        output.clear(context.scene)
        return {"FINISHED"}


class ILLUSTRATE_OT_show_field(DrawingOperator, bpy.types.Operator):
    """Shows the field that hatches follow."""

    bl_idname = "illustrate.show_field"
    bl_label = "Show Field"
    bl_description = (
        "Show the directions that hatches follow as crosses on the surfaces, with a red or blue "
        "mark where they turn round a point"
    )

    def task(self, context: Any) -> Task:
        """Puts the field in place of the one shown last."""
        request = read_request(context.scene, context.evaluated_depsgraph_get())
        request.draw["hatching"] = True
        prepared = yield from preparing(request, (0.0, 0.5))
        # One that was kept may have left its field for later.
        prepared = yield Step(start_preparing(request, prepared), 0.5)
        field = prepared.field
        field_overlay.write(still_there(request.scene_name), prepared.surface, field)
        points = amount(len(field.singular_indices), "singularity", "singularities")
        return [("INFO", said("The field has {points}", points=points))]


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


CLASSES = (
    ILLUSTRATE_OT_illustrate,
    ILLUSTRATE_OT_render_tone,
    ILLUSTRATE_OT_clear,
    ILLUSTRATE_OT_show_field,
    ILLUSTRATE_OT_hide_field,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
