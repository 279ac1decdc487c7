"""A range of frames into keyframes."""

import time
from typing import Any

import bpy

from .. import native, output
from ..messages import IllustrateError, amount, said
from ..plot.areas import check_fills, fills_of
from ..reading.tone_images import tone_of
from .illustration import computing, hatches_render, read_request
from .operators import DrawingOperator, still_there
from .rendering import render_steps
from .tasks import Task


def frames_of(scene: Any) -> range:
    """The frames that a bake draws. Raises IllustrateError for a range that ends too early."""
    chosen = scene.illustrate
    start, end = chosen.frame_start, chosen.frame_end
    if chosen.use_scene_range:
        start, end = scene.frame_start, scene.frame_end
    if end < start:
        raise IllustrateError(
            said(
                "The bake ends at frame {end}, before it starts: set End to {start}",
                end=end,
                start=start,
            )
        )
    return range(start, end + 1, chosen.frame_step)


class ILLUSTRATE_OT_bake(DrawingOperator, bpy.types.Operator):
    """Writes the illustrations of a range of frames."""

    bl_idname = "illustrate.bake"
    bl_label = "Bake Animation"
    bl_description = (
        "Draw every frame of the range into a keyframe of its own; frames with strokes of yours "
        "are left as they are"
    )

    def task(self, context: Any) -> Task:
        """Draws frame after frame beside Blender; writes them together at the end."""
        scene, start = context.scene, time.perf_counter()
        name = scene.name
        output.check_can_bake(scene.illustrate.output)
        check_fills(scene)
        frames, shown = frames_of(scene), (scene.frame_current, scene.frame_subframe)
        sheets, warnings, previous = [], [], None
        try:
            for done, frame in enumerate(frames):
                scene = still_there(name)
                scene.frame_set(frame)
                rendered = None
                if hatches_render(scene.illustrate):
                    at = done / len(frames)
                    rendered = yield from render_steps(scene, self.is_modal, tone_of, at, at)
                    scene = still_there(name)
                request = read_request(scene, context.evaluated_depsgraph_get(), rendered)
                request.expose_as(previous)
                if scene.illustrate.keep_strokes and native.can_seed():
                    request.previous = previous
                share = done / len(frames), (done + 1) / len(frames)
                made = yield from computing(request, share, said("Frame {frame}", frame=frame))
                areas = fills_of(still_there(name), made)
                camera = made.arrays.camera
                sheets.append(output.sheet_of(made.drawing, camera, frame, made.names, areas))
                warnings += [w for w in made.warnings if w not in warnings]
                previous = made.drawing
        finally:
            _go_back(name, *shown)
        warnings += output.bake_drawings(still_there(name), sheets)
        strokes = sum(len(group.sizes) for sheet in sheets for group in sheet.groups)
        done_text = said(
            "Baked {frames}: {strokes} in {seconds:.2f} s",
            frames=amount(len(sheets), "frame"),
            strokes=amount(strokes, "stroke"),
            seconds=time.perf_counter() - start,
        )
        return [*(("WARNING", warning) for warning in warnings), ("INFO", done_text)]


def _go_back(scene_name: str, frame: int, subframe: float) -> None:
    """To the frame that was shown before; a file that was loaded meanwhile has its own."""
    scene = bpy.data.scenes.get(scene_name)
    if scene is not None:
        scene.frame_set(frame, subframe=subframe)


register, unregister = bpy.utils.register_classes_factory((ILLUSTRATE_OT_bake,))
