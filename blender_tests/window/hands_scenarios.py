"""Hands on the drawing in a window: picking, guides, singularities, the gallery, a first click."""

import pathlib
import unittest
from typing import Any

import bpy
import hands
import numpy as np
from illustrate.ui import panel
from illustrate.viewport.inspect import INSPECTOR
from illustrate.viewport.live import LIVE, WHOLE
from illustrate.viewport.pick import PICKER
from mathutils import Vector
from staging import Steps, has_brushes, new_scene, open_panel, strokes


def through_camera() -> Any:
    """The largest viewport looks through the camera; its 3D view."""
    view = hands.viewport().spaces.active.region_3d
    view.view_perspective = "CAMERA"
    hands.redraw()
    return view


def place_of(point: Any) -> tuple[int, int]:
    """Where a place in the world is in the region of the largest viewport."""
    view, region = hands.viewport().spaces.active.region_3d, hands.region("WINDOW")
    clip = view.perspective_matrix @ Vector((*map(float, point), 1.0))
    return (
        round((clip.x / clip.w + 1) / 2 * region.width),
        round((clip.y / clip.w + 1) / 2 * region.height),
    )


def undo() -> None:
    with hands.override():
        bpy.ops.ed.undo()


def is_whole() -> bool:
    return LIVE.is_idle() and any(seen.drawing_of(WHOLE) for seen in LIVE.views.values())


def clear_strokes() -> int:
    from staging import pencils

    found = 0
    for layer in pencils()[0].data.layers:
        for frame in layer.frames:
            is_new = hasattr(frame, "drawing")
            if is_new and frame.drawing.attributes.get("opacity") is None:
                continue  # all are seen
            for stroke in frame.drawing.strokes if is_new else frame.strokes:
                name = "opacity" if is_new else "strength"
                found += getattr(stroke.points[0], name) == 0
    return found


def a_stroke_is_picked_and_hidden(out: pathlib.Path) -> Steps:
    """With the mouse; what it is stands in the panel; hiding it and its hatches, undone."""
    new_scene()
    with hands.override():
        bpy.ops.illustrate.illustrate()
        bpy.ops.ed.undo_push(message="Drawn")
    yield from open_panel()
    through_camera()
    drawing = INSPECTOR.made.drawing
    longest = int(np.argmax(np.diff(drawing.offsets)))
    point = drawing.points[(drawing.offsets[longest] + drawing.offsets[longest + 1]) // 2]
    x, y = place_of(point)
    region = hands.region("WINDOW")
    with hands.override():
        bpy.ops.illustrate.pick("INVOKE_DEFAULT")
    yield 0.3
    hands.click(region.x + x - 1, region.y + y)
    yield lambda: PICKER.picked is not None
    picked: Any = PICKER.picked
    assert picked.thing == "Suzanne" and picked.layers == 0
    with hands.opened(panel.ILLUSTRATE_PT_hands):
        hands.redraw()
        hands.scroll_to_the_end(hands.viewport(), "UI")
        yield 0.1
        hands.picture(out / "40_picked.png")
    with hands.override():
        assert bpy.ops.illustrate.hide_stroke() == {"FINISHED"}
        bpy.ops.ed.undo_push(message="Hidden")
    assert clear_strokes() == 1
    undo()
    yield 0.3
    assert clear_strokes() == 0
    count = strokes()
    PICKER.pick(picked)
    with hands.override():
        assert bpy.ops.illustrate.hide_hatches() == {"FINISHED"}
        bpy.ops.ed.undo_push(message="No hatches")
    assert strokes() < count / 2
    hands.picture(out / "41_no_hatches.png")
    undo()
    yield 0.3
    assert strokes() == count and bpy.data.objects["Suzanne"].illustrate.hatching


def live_drawing() -> Any:
    """The whole drawing of the only viewport."""
    return LIVE.wholes()[0].drawing


def darkness_near(path: pathlib.Path, place: tuple[int, int]) -> float:
    """Of the darkest of some pixels round a place of the region."""
    x, y = place
    seen = hands.pixels(path)[::-1]
    return float(1 - seen[y - 2 : y + 3, x - 2 : x + 3].mean(axis=2).min())


def a_stroke_of_the_live_drawing_is_hidden(out: pathlib.Path) -> Steps:
    """With the mouse; it is gone from the viewport, undo and redo have it, and Keep hides it."""
    new_scene(1).illustrate.hatching = False
    hands.show_side_panel(False)
    with hands.override():
        bpy.ops.illustrate.toggle_paper()
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    drawing = live_drawing()
    longest = int(np.argmax(np.diff(drawing.offsets)))
    place = place_of(drawing.points[drawing.offsets[longest : longest + 2].sum() // 2])
    with hands.override():
        bpy.ops.illustrate.pick("INVOKE_DEFAULT")
    yield 0.3
    region = hands.region("WINDOW")
    hands.click(region.x + place[0] - 1, region.y + place[1])
    yield lambda: PICKER.picked is not None
    picked: Any = PICKER.picked
    assert picked.number == longest and picked.thing == "Suzanne"
    PICKER.pick(None)
    drawn = darkness_near(hands.picture(out / "47_live_stroke.png"), place)
    PICKER.pick(picked)
    with hands.override():
        assert bpy.ops.illustrate.hide_stroke() == {"FINISHED"}
        bpy.ops.ed.undo_push(message="Hidden")
    hidden = darkness_near(hands.picture(out / "48_live_stroke_hidden.png"), place)
    assert hidden < drawn - 0.5, (drawn, hidden)
    for step, wanted in ((bpy.ops.ed.undo, drawn), (bpy.ops.ed.redo, hidden)):
        with hands.override():
            step()
        hands.redraw()
        yield is_whole
        shown = darkness_near(hands.picture(out / f"48_live_{step.idname_py()}.png"), place)
        assert abs(shown - wanted) < 0.05, (step.idname_py(), shown, wanted)
    with hands.override():
        assert bpy.ops.illustrate.keep_live("EXEC_DEFAULT") == {"FINISHED"}
    assert clear_strokes() == 1 and strokes() == len(drawing.kinds)


def hatches_follow_a_guide(out: pathlib.Path) -> Steps:
    """A stroke drawn on the surface while the drawing is live; then it is undone."""
    if not has_brushes():
        raise unittest.SkipTest("this Blender has no brushes")
    scene = new_scene(1)
    hands.show_side_panel(False)
    through_camera()
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    before = LIVE.prepared.field.directions.copy()
    with hands.override():
        assert bpy.ops.illustrate.draw_guide() == {"FINISHED"}
        bpy.ops.ed.undo_push(message="Guide")
    yield is_whole
    region, window = hands.region("WINDOW"), hands.window()
    middle = place_of((0.0, -0.5, 0.3))
    path = [
        (region.x + middle[0] - 60 + 6 * i, region.y + middle[1] + 40 + 2 * i) for i in range(20)
    ]
    hands.move(*path[0])
    yield 0.2
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=path[0][0], y=path[0][1])
    for x, y in path[1:]:
        hands.move(x, y)
        yield 0.02
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=path[-1][0], y=path[-1][1])
    yield 0.5
    yield lambda: bool(LIVE.arrays and LIVE.arrays.guides.strokes)
    yield is_whole
    after = LIVE.prepared.field.directions
    hands.picture(out / "42_guided.png")
    assert len(after) == len(before) and np.abs(np.asarray(after) - before).max() > 0.1
    with hands.override():
        bpy.ops.ed.undo()
    yield lambda: not (LIVE.arrays and LIVE.arrays.guides.strokes)
    yield is_whole
    hands.manager().illustrate_live = False
    assert scene is not None


def a_singularity_is_dragged(out: pathlib.Path) -> Steps:
    """Held by an empty that moves; the live hatches turn where it is."""
    new_scene(1)
    bpy.data.objects.remove(bpy.data.objects["Suzanne"])
    with hands.override():
        bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16)
        bpy.ops.object.shade_smooth()
    hands.show_side_panel(False)
    through_camera()
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    with hands.override():
        assert bpy.ops.illustrate.hold_singularities() == {"FINISHED"}
        bpy.ops.ed.undo_push(message="Held")
    hands.redraw()
    yield is_whole
    hands.picture(out / "43_held.png")
    empties = [t for t in bpy.data.objects if t.type == "EMPTY"]
    dragged = max(empties, key=lambda thing: thing.location.z)
    before = LIVE.prepared
    with hands.override():
        bpy.ops.object.select_all(action="DESELECT")
        dragged.select_set(True)
        bpy.ops.transform.translate(value=(0.15, -0.1, 0.0))
        bpy.ops.ed.undo_push(message="Dragged")
    yield lambda: LIVE.prepared is not before
    yield is_whole
    hands.picture(out / "44_dragged.png")
    assert not LIVE.problem, LIVE.problem
    undo()
    yield 0.2
    hands.redraw()
    yield is_whole
    hands.manager().illustrate_live = False


def an_empty_scene_is_drawn_after_one_click(out: pathlib.Path) -> Steps:
    """Set Up Scene from the panel of an empty file; the panel at 280 px."""
    new_scene()
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    yield from open_panel()
    hands.picture(out / "45_empty.png")
    with hands.override():
        assert bpy.ops.illustrate.set_up() == {"FINISHED"}
        bpy.ops.illustrate.illustrate()
    assert strokes() > 50
    through_camera()
    hands.picture(out / "46_set_up.png")
    side = hands.region("UI")
    print(f"side panel: {side.width} px", flush=True)


ALL = [
    a_stroke_is_picked_and_hidden,
    a_stroke_of_the_live_drawing_is_hidden,
    hatches_follow_a_guide,
    a_singularity_is_dragged,
    an_empty_scene_is_drawn_after_one_click,
]
