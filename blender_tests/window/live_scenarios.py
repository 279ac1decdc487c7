"""The live drawing in a window: what is seen while one works, and what it leaves."""

import pathlib
import statistics
import time
from typing import Any

import bpy
import hands
import numpy as np
from illustrate.viewport.live import LINES, LIVE, WHOLE
from illustrate.viewport.live_view import VIEW
from mathutils import Matrix, Quaternion
from staging import Steps, has_brushes, new_scene, pencils, strokes


def dark(path: pathlib.Path) -> int:
    """Black pixels of the 3D view."""
    return int((hands.pixels(path).max(axis=2) < 0.06).sum())


def region_view() -> Any:
    return hands.viewport().spaces.active.region_3d


def seen() -> Any:
    """What is known of the largest viewport."""
    return LIVE.views.get(hands.region("WINDOW").as_pointer())


def is_whole() -> bool:
    return seen() is not None and LIVE.is_idle() and seen().drawing_of(WHOLE) is not None


def is_hatched() -> bool:
    made = seen().drawing_of(WHOLE) if seen() is not None else None
    return made is not None and bool((np.asarray(made.drawing.kinds) == 4).any())


def turn(angle: float) -> None:
    view = region_view()
    view.view_rotation = Quaternion((0, 0, 1), angle) @ view.view_rotation


def live_lines_follow_the_view(out: pathlib.Path) -> Steps:
    """Rough lines while orbiting; exact lines and hatches at rest; nothing is left afterwards."""
    new_scene()
    hands.show_side_panel(False)
    yield 0.3
    plain = dark(hands.picture(out / "8_without_lines.png"))
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    rested = dark(hands.picture(out / "9_live_at_rest.png"))
    assert rested > plain + 1000, (plain, rested)
    VIEW.seconds.clear()
    for i in range(25):
        turn(0.02)
        hands.redraw()
        assert seen().drawing_of(LINES) is None, "hatches of another view"
        if i % 20 == 19:
            yield 0.01
    shown = dark(hands.picture(out / "9_live_lines.png"))
    assert shown > plain + 300, (plain, shown)
    median = statistics.median(VIEW.seconds)
    print(f"live lines: median {1000 * median:.1f} ms a redraw", flush=True)
    start = time.monotonic()
    yield is_hatched
    print(f"live hatches: {time.monotonic() - start:.2f} s after rest", flush=True)
    hands.manager().illustrate_live_eye = "CAMERA"
    hands.picture(out / "10_lines_of_the_camera.png")
    hands.manager().illustrate_live_eye = "VIEW"
    hands.manager().illustrate_live = False
    assert not VIEW.is_on
    assert dark(hands.picture(out / "11_lines_off.png")) < shown - 300


def live_drawing_follows_the_scene(out: pathlib.Path) -> Steps:
    """A moved light, a slider, a dragged vertex in edit mode, frames; the last drawing stays."""
    scene = new_scene(1)
    hands.show_side_panel(False)
    hands.manager().illustrate_live = True
    with hands.override():
        bpy.ops.view3d.view_camera()
    hands.redraw()
    yield is_whole
    hands.picture(out / "20_live_camera.png")
    for change in (move_light, move_slider, move_vertex, next_frame):
        before = seen().drawing_of(WHOLE)
        change(scene)
        hands.redraw()
        assert seen().drawing_of(WHOLE) is before, "the last one stays"
        yield lambda before=before: is_whole() and seen().drawing_of(WHOLE) is not before
        hands.picture(out / f"21_live_{change.__name__}.png")
    current = seen().drawing_of(WHOLE)
    yield 0.6
    assert seen().drawing_of(WHOLE) is current, "drawn again although nothing changed"
    hands.manager().illustrate_live = False


def move_light(_scene: Any) -> None:
    bpy.data.objects["Sun"].rotation_euler = (1.2, -0.8, 0)


def move_slider(scene: Any) -> None:
    scene.illustrate.spacing_px *= 2


def move_vertex(_scene: Any) -> None:
    import bmesh  # type: ignore[import-not-found]

    with hands.override():
        bpy.ops.object.mode_set(mode="EDIT")
    mesh = bpy.data.objects["Suzanne"].data
    edited = bmesh.from_edit_mesh(mesh)
    edited.verts.ensure_lookup_table()
    edited.verts[0].co.z += 0.4
    bmesh.update_edit_mesh(mesh)


def next_frame(scene: Any) -> None:
    with hands.override():
        bpy.ops.object.mode_set(mode="OBJECT")
    monkey = bpy.data.objects["Suzanne"]
    for frame, turned in ((1, 0.0), (2, 0.4)):
        monkey.rotation_euler.z = turned
        monkey.keyframe_insert("rotation_euler", frame=frame)
    scene.frame_set(2)


def what_stands_before_hides_the_drawing(out: pathlib.Path) -> Steps:
    """A thing that is not drawn hides what lies behind it, and nothing where it stands behind."""
    new_scene()
    hands.show_side_panel(False)
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    bare = dark(hands.picture(out / "23_nothing_before.png"))
    with hands.override():
        bpy.ops.mesh.primitive_plane_add(size=1.2)
    screen = hands.window().view_layer.objects.active
    screen.hide_render = True
    screen.select_set(False)
    counts = {}
    for place, distance in (("before", 3.0), ("behind", 9.0)):
        eye = region_view().view_matrix.inverted()
        screen.matrix_world = eye @ Matrix.Translation((0.6, 0, -distance))
        hands.redraw()
        yield is_whole
        counts[place] = dark(hands.picture(out / f"24_something_{place}.png"))
    assert 0.2 * bare < counts["before"] < 0.8 * bare, (bare, counts)
    assert counts["behind"] > 0.9 * bare, (bare, counts)
    hands.manager().illustrate_live = False


def sculpt(_scene: Any) -> Steps:
    """A stroke of the brush over the monkey's face; it is followed before the button is let go."""
    with hands.override():
        bpy.ops.object.mode_set(mode="SCULPT")
    yield is_whole
    before = seen().made[LINES]
    region, window = hands.region("WINDOW"), hands.window()
    x, y = region.x + region.width // 2, region.y + region.height // 2
    hands.move(x, y)
    yield 0.2
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    for i in range(1, 9):
        hands.move(x + 8 * i, y + 4 * i)
        yield 0.05
    yield lambda: not is_same_shape(seen().made[LINES], before)
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=x + 64, y=y + 32)


def is_same_shape(made: Any, before: Any) -> bool:
    return np.array_equal(made.drawing.points, before.drawing.points)


def pose(_scene: Any) -> Steps:
    """The bone turns that the monkey hangs on."""
    monkey = bpy.data.objects["Suzanne"]
    with hands.override():
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.ops.object.armature_add()
        armature = hands.window().view_layer.objects.active
        monkey.modifiers.new("Bones", "ARMATURE").object = armature
        group = monkey.vertex_groups.new(name=armature.data.bones[0].name)
        group.add(range(len(monkey.data.vertices)), 1.0, "ADD")
        bpy.ops.object.mode_set(mode="POSE")
    bone = armature.pose.bones[0]
    bone.rotation_mode, bone.rotation_euler = "XYZ", (0.0, 0.6, 0.0)
    yield 0.0


def live_drawing_follows_modes(out: pathlib.Path) -> Steps:
    """Sculpting, where there are brushes, and posing are followed while their modes are on."""
    scene = new_scene(0)
    hands.show_side_panel(False)
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    for change, mode in ((sculpt, "SCULPT"), (pose, "POSE"))[not has_brushes() :]:
        before = seen().drawing_of(WHOLE)
        yield from change(scene)
        hands.redraw()
        yield lambda before=before: is_whole() and not is_same_shape(seen().made[WHOLE], before)
        assert hands.window().view_layer.objects.active.mode == mode
        hands.picture(out / f"26_live_{mode.lower()}.png")
    with hands.override():
        bpy.ops.object.mode_set(mode="OBJECT")
    hands.manager().illustrate_live = False


def live_drawing_skips_frames(_out: pathlib.Path) -> Steps:
    """Playback goes on while lines are drawn of some of its frames, and none waits in line."""
    scene = new_scene(1)
    next_frame(scene)
    scene.frame_start, scene.frame_end = 1, 100
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    with hands.override():
        bpy.ops.screen.animation_play()
    first, versions, start = scene.frame_current, LIVE.version, time.monotonic()
    yield lambda: scene.frame_current > first + 3 and seen().of[LINES][0] > versions + 1
    frames, seconds = scene.frame_current - first, time.monotonic() - start
    prepared = LIVE.version - versions
    print(f"playback: {frames} frames in {seconds:.1f} s, {prepared} prepared", flush=True)
    with hands.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    yield is_whole
    hands.manager().illustrate_live = False


def what_is_seen_is_kept(out: pathlib.Path) -> Steps:
    """Keep writes the strokes that the viewport shows, in one step of undo."""
    new_scene()
    hands.show_side_panel(False)
    hands.manager().illustrate_live = True
    with hands.override():
        bpy.ops.view3d.view_camera()
    hands.redraw()
    yield is_whole
    count = len(seen().drawing_of(WHOLE).drawing.kinds)
    with hands.override():
        assert bpy.ops.illustrate.keep_live("EXEC_DEFAULT") == {"FINISHED"}
    assert strokes() == count and len(pencils()) == 1 and not VIEW.is_on
    hands.picture(out / "22_kept.png")
    with hands.override():
        bpy.ops.ed.undo()
    yield 0.3
    assert not pencils()


def live_drawing_ends_with_the_file(_out: pathlib.Path) -> Steps:
    """Loading a file turns it off, while it is shown and while it is made."""
    for pause in (0.0, 0.1, 1.0):
        new_scene(4)
        hands.manager().illustrate_live = True
        hands.redraw()
        yield pause
        new_scene()
        assert not VIEW.is_on and LIVE.prepared is None and LIVE.running is None
        yield 0.5
        hands.redraw()


ALL = [
    live_lines_follow_the_view,
    live_drawing_follows_the_scene,
    what_stands_before_hides_the_drawing,
    live_drawing_follows_modes,
    live_drawing_skips_frames,
    what_is_seen_is_kept,
    live_drawing_ends_with_the_file,
]
