"""What artists do with the add-on in a window, one scenario after the other."""

import contextlib
import pathlib
import time
from typing import Any

import bpy
import hands
import numpy as np
from illustrate.running import jobs, tasks
from illustrate.ui import panel as side_panel
from illustrate.ui import plot_panel, style_panel
from illustrate.viewport.inspect import INSPECTOR, KINDS
from staging import Steps, new_scene, open_panel, pencils, strokes

SUB_PANELS = [p for p in (*side_panel.CLASSES, *plot_panel.CLASSES) if hasattr(p, "bl_parent_id")]


def the_button_draws(out: pathlib.Path) -> Steps:
    """Click, progress, strokes; then undo, redo, and a second click."""
    scene = new_scene()
    yield 0.5
    yield from open_panel()
    hands.picture(out / "1_panel.png")
    start = time.perf_counter()
    hands.click(*hands.button_place())
    yield tasks.is_running
    yield lambda: not tasks.is_running()
    print(f"click to strokes: {time.perf_counter() - start:.2f} s", flush=True)
    assert strokes() > 50
    count = strokes()
    hands.picture(out / "2_illustration.png")
    with hands.override():
        bpy.ops.ed.undo()
    yield 0.3
    assert not pencils() and "Suzanne" in bpy.data.objects
    with hands.override():
        bpy.ops.ed.redo()
    yield 0.3
    assert strokes() == count
    scene = hands.window().scene
    scene.camera.location.x += 0.5
    start = time.perf_counter()
    hands.click(*hands.button_place())
    yield lambda: tasks.is_running() or strokes() != count
    yield lambda: not tasks.is_running()
    print(f"click to strokes after the camera moved: {time.perf_counter() - start:.2f} s")
    assert len(pencils()) == 1
    hands.picture(out / "3_second_click.png")


def escape_stops_a_run(out: pathlib.Path) -> Steps:
    """ESC while a heavy drawing is made, at five moments; the scene stays as it was."""
    scene = new_scene(1)
    scene.illustrate.level, scene.illustrate.threads = 6, 1
    yield from open_panel()
    before = state()
    ended = watch_cancel()
    latencies = []
    for moment in (0.0, 0.15, 0.4, 0.8, 1.5):
        hands.redraw()
        hands.click(*hands.button_place())
        yield tasks.is_running
        yield moment
        if moment == 0.8:
            hands.picture(out / "4_progress.png")
        assert tasks.is_running(), "too quick to be stopped"
        start = time.perf_counter()
        hands.press("ESC")
        yield lambda: not tasks.is_running()
        latencies.append(ended[-1] - start)
        yield 0.2
        assert state() == before
    print("ESC to its end:", *(f"{1000 * s:.0f} ms" for s in latencies), flush=True)
    yield lambda: not jobs.are_leaving()
    hands.picture(out / "5_after_escape.png")


def watch_cancel() -> list[float]:
    """When the last runs were cancelled; Blender's own redraw comes after that."""
    ended: list[float] = []
    cancel = tasks.TaskOperator.cancel

    def watched(self: Any, context: Any) -> None:
        cancel(self, context)
        ended.append(time.perf_counter())

    tasks.TaskOperator.cancel = watched
    return ended


def state() -> Any:
    """All data that a run might have touched."""
    names = ("objects", "meshes", "scenes", "materials", "collections", "grease_pencils", "curves")
    blocks = {name: sorted(block.name for block in getattr(bpy.data, name)) for name in names}
    return blocks, hands.window().scene.frame_current


def the_view_moves_while_it_works(out: pathlib.Path) -> Steps:
    """Orbiting is allowed during a run, a click on another object is not."""
    new_scene(4).illustrate.level = 5
    yield from open_panel()
    view = hands.viewport().spaces.active.region_3d
    hands.click(*hands.button_place())
    yield tasks.is_running
    distance = view.view_distance
    middle = hands.region("WINDOW")
    x, y = middle.x + middle.width // 3, middle.y + middle.height // 3
    hands.move(x, y)
    hands.window().event_simulate(type="WHEELUPMOUSE", value="PRESS", x=x, y=y)
    yield lambda: view.view_distance != distance
    assert tasks.is_running()
    hands.press("ESC")
    yield lambda: not tasks.is_running()
    hands.picture(out / "6_zoomed.png")


def saved_and_reopened(out: pathlib.Path) -> Steps:
    """Strokes, settings and marks are in the file: a click replaces what was drawn before."""
    scene = new_scene()
    scene.illustrate.spacing_px = 12
    yield 0.3
    with hands.override():
        bpy.ops.illustrate.illustrate()
    count, path = strokes(), str(out / "saved.blend")
    with hands.override():
        bpy.ops.wm.save_as_mainfile(filepath=path, check_existing=False)
        bpy.ops.wm.open_mainfile(filepath=path, load_ui=False)
    yield 0.5
    scene = hands.window().scene
    assert strokes() == count and scene.illustrate.spacing_px == 12
    with hands.override():
        assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    assert len(pencils()) == 1 and strokes() == count
    pathlib.Path(path).unlink()


def a_bake_is_stopped_between_frames(out: pathlib.Path) -> Steps:
    """ESC in the middle of a bake sets the frame back and writes nothing; then a whole bake."""
    scene = new_scene()
    scene.frame_start, scene.frame_end = 1, 8
    monkey = bpy.data.objects["Suzanne"]
    for frame, turn in ((1, 0.0), (8, 1.0)):
        monkey.rotation_euler.z = turn
        monkey.keyframe_insert("rotation_euler", frame=frame)
    scene.frame_set(1)
    yield 0.3
    before = state()
    with hands.override():
        assert bpy.ops.illustrate.bake("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    yield lambda: scene.frame_current == 3
    hands.press("ESC")
    yield lambda: not tasks.is_running()
    assert state() == before
    with hands.override():
        bpy.ops.illustrate.bake("INVOKE_DEFAULT")
    yield lambda: not tasks.is_running()
    layers = pencils()[0].data.layers
    assert max(len(layer.frames) for layer in layers) == 8
    scene.frame_set(5)
    hands.picture(out / "7_baked.png")


def overlays_are_shown(out: pathlib.Path) -> Steps:
    """Each overlay is seen."""
    new_scene()
    yield 0.3
    with hands.override():
        bpy.ops.illustrate.illustrate()
        bpy.ops.illustrate.clear()
        bpy.ops.view3d.view_camera()
    yield 0.5
    plain = hands.pixels(hands.picture(out / "12_plain.png"))
    for kind in KINDS:
        hands.manager().illustrate_inspect = kind
        shown = hands.pixels(hands.picture(out / f"13_{kind.lower()}.png"))
        changed = int((np.abs(shown - plain).max(axis=2) > 0.1).sum())
        assert changed > 30, (kind, changed)
        yield 0.05
    hands.manager().illustrate_inspect = "NONE"
    assert INSPECTOR._handle is None


def the_page_is_shown(out: pathlib.Path) -> Steps:
    """Paper and margins about the camera's frame, and the ways with the pen up of an export."""
    scene = new_scene()
    scene.illustrate_plot.margins_mm = (20, 20, 20, 20)
    yield 0.3
    with hands.override():
        bpy.ops.illustrate.export_drawing(filepath=str(out / "16_plot.svg"))
        bpy.ops.view3d.view_camera()
    yield 0.5
    hands.viewport().spaces.active.region_3d.view_camera_zoom = 0.0
    plain = hands.pixels(hands.picture(out / "16_without_page.png"))
    for name in ("page", "travel"):
        switch = f"illustrate_show_{name}"
        setattr(hands.manager(), switch, True)
        shown = hands.pixels(hands.picture(out / f"16_{name}.png"))
        changed = int((np.abs(shown - plain).max(axis=2) > 0.1).sum())
        assert changed > 300, (name, changed)
        setattr(hands.manager(), switch, False)
        yield 0.05
    after = hands.pixels(hands.picture(out / "16_page_off.png"))
    assert np.abs(after - plain).max() < 0.1


def the_panel_says_what_is_wrong(out: pathlib.Path) -> Steps:
    """Without a camera the button is grey, and the panel says why."""
    scene = new_scene()
    scene.camera = None
    yield from open_panel()
    hands.picture(out / "14_no_camera.png")
    hands.click(*hands.button_place())
    yield 0.5
    assert not tasks.is_running() and not pencils()
    with hands.override(), contextlib.suppress(RuntimeError):
        assert not bpy.ops.illustrate.illustrate.poll()
    scene.camera = bpy.data.objects["Eye"]


def every_panel_is_shown(out: pathlib.Path) -> Steps:
    """Each sub-panel open, in pixels and in millimetres, and the style of an object."""
    scene = new_scene()
    yield 0.3
    yield from open_panel()
    scene.illustrate.guides = bpy.data.collections.new("Guides")
    for unit in ("PIXEL", "MILLIMETRE"):
        scene.illustrate.unit = unit
        for panel in SUB_PANELS:
            with hands.opened(panel):
                hands.redraw()
                yield 0.1  # from 5 on a panel grows to its height
                hands.redraw()
                hands.scroll_to_the_end(hands.viewport(), "UI")
                yield 0.1
                hands.picture(out / f"15_{panel.bl_label}_{unit}.png".lower().replace(" ", "_"))
    bpy.data.objects["Suzanne"].illustrate.use_own = True
    with hands.opened(style_panel.ILLUSTRATE_PT_object_style):
        properties = hands.show_properties("OBJECT")
        hands.redraw()
        hands.scroll_to_the_end(properties, "WINDOW")
        yield 0.1
        hands.picture(out / "16_style.png")


ALL = [
    the_button_draws,
    escape_stops_a_run,
    the_view_moves_while_it_works,
    saved_and_reopened,
    a_bake_is_stopped_between_frames,
    overlays_are_shown,
    the_page_is_shown,
    the_panel_says_what_is_wrong,
    every_panel_is_shown,
]
