"""Renders that are hatched. They come last.

Cycles calls Python from a thread of its own. Where that meets Blender while it draws its panels, as
on a busy machine, Blender 3.4 may forbid Python to change anything from then on ("can't modify
blend data in this state"), and whatever comes after fails.
"""

import pathlib

import bpy
import hands
from illustrate.running import tasks
from scenarios import state
from staging import Steps, new_scene, open_panel, strokes


def a_render_is_hatched_or_stopped(out: pathlib.Path) -> Steps:
    """Tone from a render: ESC ends the task, and nothing is written when the render is over (keys
    that are simulated do not reach Blender's render job); a render that is whole becomes strokes.
    """
    scene = new_scene(1)
    scene.render.engine, scene.illustrate.tone_source = "CYCLES", "RENDER"
    scene.cycles.use_denoising, scene.cycles.samples = False, 16
    yield from open_panel()
    before = state()
    hands.click(*hands.button_place())
    yield tasks.is_running
    yield lambda: bpy.app.is_job_running("RENDER")
    hands.picture(out / "17_rendering.png")
    hands.press("ESC")
    yield lambda: not tasks.is_running()
    yield lambda: not bpy.app.is_job_running("RENDER")
    assert state() == before and not strokes()
    assert not scene.render.use_freestyle
    scene.cycles.samples, scene.render.resolution_percentage = 2, 30
    yield 0.5
    hands.redraw()
    hands.click(*hands.button_place())
    yield tasks.is_running
    yield lambda: not tasks.is_running()
    assert strokes() > 10
    hands.picture(out / "18_hatched_render.png")


ALL = [a_render_is_hatched_or_stopped]
