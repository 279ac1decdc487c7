"""The live drawing without a window: what it computes, when, and what it would show."""

import time
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate.reading.scene import read_camera
from illustrate.running import illustration
from illustrate.viewport import live, live_view, overlay
from illustrate.viewport.live import DRAFT, LINES, LIVE, REST_S, VIEW, WHOLE, Seen
from illustrate.viewport.live_strokes import has_others
from illustrate.viewport.ribbons import ribbons_of
from illustrate.viewport.views import AHEAD, FOREMOST, View, depths_of, view_of

import tools


@pytest.fixture(autouse=True)
def _live() -> Any:
    LIVE.forget()
    yield
    LIVE.forget()


def camera_view(scene: Any) -> View:
    camera = read_camera(scene, bpy.context.evaluated_depsgraph_get())
    return View(camera, np.array([1.0, -1.0]), np.array([0.0, camera.height_px]))


def drawn(view: View | None = None, changed: bool = True) -> Seen:
    """What there is of a viewport that rests, when all is drawn."""
    seen = LIVE.look(1, view or camera_view(bpy.context.scene))
    seen.moved_at -= REST_S
    LIVE.shapes_are_stale = LIVE.shapes_are_stale or changed
    for _ in ticks():
        pass
    return seen


def ticks() -> Iterator[None]:
    """Until all is drawn, or cannot be."""
    for _ in range(6000):
        LIVE.tick(bpy.context)
        yield
        if LIVE.is_idle() or LIVE.problem:
            return
        time.sleep(0.005)
    raise AssertionError("the live drawing was never ready")


def test_it_draws_what_illustrate_draws(scene: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.hidden, scene.illustrate.triangle_budget = True, 50_000
    seen = drawn()
    made = seen.drawing_of(WHOLE)
    assert made is not None
    plain = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get()).drawing
    for name in ("points", "widths", "kinds", "invisibility"):
        assert np.array_equal(getattr(made.drawing, name), getattr(plain, name))
    assert len(set(made.drawing.kinds)) > 1 and made.names == ["Box"]


def test_nothing_is_drawn_again_when_nothing_changed(scene: Any) -> None:
    tools.cube_scene(scene)
    made = drawn().drawing_of(WHOLE)
    assert drawn(changed=False).drawing_of(WHOLE) is made


def test_the_last_drawing_stays_until_the_next_is_whole(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    seen = drawn()
    before, prepared = seen.drawing_of(WHOLE), LIVE.prepared
    cube.location.x += 0.5
    bpy.context.view_layer.update()
    LIVE.shapes_are_stale = True
    LIVE.tick(bpy.context)
    assert seen.drawing_of(WHOLE) is before
    after = drawn().drawing_of(WHOLE)
    assert after is not None and before is not None and LIVE.prepared is not prepared
    assert after.drawing.points[:, 0].max() == pytest.approx(
        before.drawing.points[:, 0].max() + 0.5, abs=0.01
    )


def test_a_view_that_moves_has_no_drawing_until_it_rests(scene: Any) -> None:
    tools.cube_scene(scene)
    drawn()
    scene.camera.location.x += 0.3
    bpy.context.view_layer.update()
    seen = LIVE.look(1, camera_view(scene))
    assert seen.drawing_of(LINES) is None and seen.drawing_of(WHOLE) is None
    LIVE.tick(bpy.context)
    assert LIVE.running is None, "it does not rest yet"
    prepared = LIVE.prepared
    assert drawn(changed=False).drawing_of(WHOLE) is not None and LIVE.prepared is prepared


def parts_drawn(whole_s: float, tones_s: float) -> list[str]:
    """Of a view that rests, one after another, where the last ones took so long."""
    LIVE.whole_s, LIVE.tones_s = whole_s, tones_s
    parts: list[str] = []
    for _ in ticks():
        if LIVE.running is not None and parts[-1:] != [LIVE.running.part]:
            parts.append(LIVE.running.part)
    assert LIVE.is_idle()
    return parts


def test_parts_come_one_after_another_where_hatches_take_long(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    whole = seen.made[WHOLE].drawing
    seen.of.clear()
    assert parts_drawn(10.0, 0.0) == [VIEW, LINES, DRAFT, WHOLE]
    assert np.array_equal(seen.made[WHOLE].drawing.points, whole.points)
    assert seen.ahead is None and DRAFT not in seen.made, "nobody asks for it any more"
    seen.of.clear()
    assert parts_drawn(10.0, 10.0) == [LINES, VIEW, DRAFT, WHOLE], "tones take long, too"
    seen.of.clear()
    assert parts_drawn(0.0, 0.0) == [WHOLE]
    scene.illustrate.hatching = False
    assert parts_drawn(10.0, 0.0) == [WHOLE]


def test_no_draft_takes_the_place_of_a_whole(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    whole = seen.made[WHOLE]
    LIVE.look_is_stale = True
    assert parts_drawn(10.0, 0.0) == [VIEW, LINES, WHOLE]
    assert seen.hatched() is seen.made[WHOLE] is not whole


def test_a_drawing_without_hatches_shows_its_lines(scene: Any, monkeypatch: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.hatching = False
    seen, shown = drawn(), []
    monkeypatch.setattr(overlay, "ribbon_batch", lambda r: r if len(r.triangles) else None)
    monkeypatch.setattr(overlay, "draw_ribbons", lambda batch, _region: shown.append(batch))
    region = SimpleNamespace(as_pointer=lambda: 1)
    context = SimpleNamespace(scene=scene, region=region, region_data=None)
    live_view.LiveView()._draw_strokes(context, seen)
    assert len(shown) == 1 and shown[0] is not None


def test_a_view_that_moves_forgets_what_was_found_of_it(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    seen.of.clear()
    LIVE.whole_s, LIVE.tones_s = 10.0, 0.0
    next(_ for _ in ticks() if seen.ahead is not None)
    assert seen.hatched() is None
    scene.camera.location.x += 0.3
    bpy.context.view_layer.update()
    LIVE.look(1, camera_view(scene))
    assert seen.ahead is None and drawn(changed=False).hatched() is not None


@pytest.mark.parametrize("hatching", [True, False])
def test_lines_follow_shapes_that_never_rest(scene: Any, hatching: bool) -> None:
    cube = tools.cube_scene(scene)
    scene.illustrate.hatching = hatching
    seen = drawn()
    whole, begun = seen.made[WHOLE], LIVE.version
    assert whole is not None
    for _ in range(3000):
        cube.location.x += 0.01
        bpy.context.view_layer.update()
        LIVE.shapes_are_stale = True
        LIVE.tick(bpy.context)
        if seen.of[LINES][0] >= begun + 3:
            break
        time.sleep(0.001)
    assert seen.made[LINES] is not None and seen.of[LINES][0] >= begun + 3
    assert seen.made[LINES].drawing.points[:, 0].max() > whole.drawing.points[:, 0].max() + 0.02
    assert seen.made[WHOLE] is whole or not hatching, "hatches wait for rest"


def test_reading_and_preparing_are_looks_of_their_own(scene: Any) -> None:
    tools.cube_scene(scene)
    LIVE.look(1, camera_view(scene))
    LIVE.tick(bpy.context)
    read: Any = LIVE.read
    assert read is not None and LIVE.running is None and not LIVE.is_idle()
    assert len(read.placed) == 1 and not read.meshes, "what needs no Blender is left to the next"
    LIVE.tick(bpy.context)
    assert not read.placed and len(read.meshes) == 1
    assert LIVE.read is None and LIVE.running is not None


def test_looks_come_when_there_may_be_something_to_do(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    assert LIVE.next_look_s() == live.TICK_S
    seen.moved_at = time.monotonic() + 0.001 - REST_S
    assert LIVE.next_look_s() <= 0.001
    seen.moved_at = 0.0
    seen.of.clear()
    LIVE.tick(bpy.context)
    assert LIVE.running is not None and LIVE.next_look_s() == live.POLL_S < live.TICK_S


def test_a_view_that_moves_on_stops_its_drawing(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    seen.of.clear()
    LIVE.tick(bpy.context)
    assert LIVE.running is not None
    scene.camera.location.x += 0.3
    bpy.context.view_layer.update()
    LIVE.look(1, camera_view(scene))
    assert LIVE.running is None


def test_lights_and_settings_need_no_new_surface(scene: Any) -> None:
    tools.cube_scene(scene)
    before = drawn().drawing_of(WHOLE)
    prepared = LIVE.prepared
    scene.illustrate.spacing_px *= 2
    wider = drawn(changed=False).drawing_of(WHOLE)
    assert wider is not None and before is not None
    assert len(wider.drawing.kinds) < len(before.drawing.kinds)
    bpy.data.objects["Sun"].rotation_euler = (2.5, 0.3, 0)
    bpy.context.view_layer.update()
    LIVE.look_is_stale = True
    lit = drawn(changed=False).drawing_of(WHOLE)
    assert lit is not None and len(lit.drawing.points) != len(wider.drawing.points)
    assert LIVE.prepared is prepared
    scene.illustrate.scheme = "none"
    drawn(changed=False)
    assert LIVE.prepared is not prepared


def test_updates_tell_shapes_from_lights(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    live_view.VIEW._seen = live_view._what_is_seen(scene)

    def stale(change: Any) -> tuple[bool, bool]:
        LIVE.shapes_are_stale = LIVE.look_is_stale = False
        change()
        found: list[Any] = []
        bpy.app.handlers.depsgraph_update_post.append(
            keep := lambda s, d: found.append(live_view.VIEW.look_at(s, d))
        )
        bpy.context.view_layer.update()
        bpy.app.handlers.depsgraph_update_post.remove(keep)
        return LIVE.shapes_are_stale, LIVE.look_is_stale

    assert stale(lambda: setattr(cube.location, "x", 2.0)) == (True, False)
    assert stale(lambda: setattr(bpy.data.objects["Sun"].location, "x", 2.0)) == (False, True)
    assert stale(lambda: setattr(bpy.data.lights["Sun"], "energy", 3.0)) == (False, True)
    assert stale(lambda: setattr(scene.camera.location, "x", 2.0)) == (False, False)
    assert stale(lambda: cube.hide_set(True)) == (True, False)


def test_a_changed_image_is_read_again(scene: Any, monkeypatch: Any) -> None:
    cube = tools.cube_scene(scene)
    made, image = bpy.data.materials.new("Ink"), bpy.data.images.new("Picture", 4, 4)
    made.use_nodes = True
    node = made.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    cube.data.materials.append(made)
    bpy.context.view_layer.update()
    forgotten: list[int] = []
    monkeypatch.setattr(live_view.IMAGES, "forget", lambda: forgotten.append(1))
    seen: list[Any] = []
    look = lambda s, d: seen.append(live_view.VIEW.look_at(s, d))  # noqa: E731
    bpy.app.handlers.depsgraph_update_post.append(look)
    try:
        cube.location.x += 1
        bpy.context.view_layer.update()
        assert seen and not forgotten
        image.update_tag()
        bpy.context.view_layer.update()
        assert forgotten
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(look)


def test_what_is_wrong_is_told_and_tried_again_after_a_change(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    cube.hide_render = True
    bpy.context.view_layer.update()
    drawn()
    assert "can be drawn" in LIVE.problem and LIVE.prepared is None
    cube.hide_render = False
    bpy.context.view_layer.update()
    LIVE.problem = ""
    assert drawn().drawing_of(WHOLE) is not None


def test_meshes_without_an_area_leave_the_last_drawing(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    seen = drawn()
    made = seen.drawing_of(WHOLE)
    for vertex in cube.data.vertices:
        vertex.co = (float("nan"),) * 3
    cube.data.update()
    bpy.context.view_layer.update()
    drawn()
    assert "has an area" in LIVE.problem
    assert seen.drawing_of(WHOLE) is made and len(LIVE.prepared.surface.triangles)


def test_surfaces_keep_to_their_triangles(scene: Any) -> None:
    tools.subdivide(tools.cube_scene(scene))
    scene.illustrate.level = 7
    drawn()
    assert 100 < len(LIVE.prepared.surface.triangles) <= 100_000


def test_a_free_view_and_the_view_of_the_camera(scene: Any) -> None:
    tools.cube_scene(scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = read_camera(scene, depsgraph)
    region = SimpleNamespace(width=640, height=480)
    data = SimpleNamespace(
        view_perspective="PERSP", window_matrix=camera.projection, view_matrix=camera.view,
        perspective_matrix=camera.projection @ camera.view,
    )  # fmt: skip
    free = view_of(scene, depsgraph, region, data)
    assert free is not None and (free.camera.width_px, free.zoom) == (640, 1.0)
    assert free.to_region([[0, 0], [640, 480]]).tolist() == [[0, 480], [640, 0]]
    data.view_perspective = "CAMERA"
    through = view_of(scene, depsgraph, region, data)
    assert through is not None and through.camera.width_px == 320
    # The same projection fills the region with the frame.
    assert through.to_region([[0, 0], [320, 240]]) == pytest.approx(
        np.array([[0, 480], [640, 0]]), abs=1e-3
    )
    assert through.zoom == pytest.approx(2.0)
    scene.camera = None
    assert view_of(scene, depsgraph, region, data) is None


def test_views_that_no_drawing_fits_are_none(scene: Any) -> None:
    tools.cube_scene(scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = read_camera(scene, depsgraph)
    region = SimpleNamespace(width=640, height=480)
    data = SimpleNamespace(
        view_perspective="PERSP", window_matrix=camera.projection, view_matrix=camera.view,
        perspective_matrix=-camera.projection @ camera.view,
    )  # fmt: skip
    assert view_of(scene, depsgraph, region, data) is not None
    assert view_of(scene, depsgraph, SimpleNamespace(width=640, height=1), data) is None
    data.view_perspective = "CAMERA"  # whose frame lies behind the viewer
    assert view_of(scene, depsgraph, region, data) is None
    data.view_perspective, data.window_matrix = "PERSP", np.zeros((4, 4))
    assert view_of(scene, depsgraph, region, data) is None


def area_of(ribbons: Any, least: float) -> float:
    """Of the triangles, each times the mean of its alpha, where that is at least so much."""
    corners = ribbons.points[ribbons.triangles].astype(float)
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    alphas = ribbons.colours[ribbons.triangles][:, :, 3].mean(axis=1)
    return float((areas * alphas)[alphas >= least].sum())


@pytest.mark.parametrize("width", [0.3, 1.0, 4.0, 11.5])
def test_ribbons_have_the_ink_of_their_strokes(width: float) -> None:
    points = np.array([[10.0, 10], [40, 10], [110, 10]])
    ribbons = ribbons_of(points, [width] * 3, [0, 3], [False], [(0, 0, 0, 1)])
    assert area_of(ribbons, 0) == pytest.approx(100 * width, rel=1e-5)
    assert ribbons.points[:, 1].max() == pytest.approx(10 + max(width, 1) / 2 + 0.5)


def test_ribbons_close_bend_and_keep_apart() -> None:
    square = np.array([[0.0, 0], [100, 0], [100, 100], [0, 100]])
    lone = np.array([[300.0, 300], [300, 300]])  # of no length
    ribbons = ribbons_of(
        np.concatenate([square, lone, square + 500]), [6.0] * 10, [0, 4, 6, 10],
        [True, False, False], [(0, 0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 0.5)],
    )  # fmt: skip
    assert np.isfinite(ribbons.points).all()
    first = ribbons.triangles[(ribbons.triangles < 16).all(axis=1)]
    assert len(first) == 4 * 6 and len(ribbons.triangles) == (4 + 1 + 3) * 6
    corner = ribbons.points[:4, :2]
    assert corner[0] == pytest.approx(-corner[3]) and abs(corner[0][0]) == pytest.approx(3.5)
    assert ribbons.colours[-16:, 3].max() == pytest.approx(0.5)


def test_no_strokes_are_no_ribbons() -> None:
    ribbons = ribbons_of(np.zeros((0, 2)), [], [0], [], np.zeros((0, 4)))
    assert len(ribbons.points) == len(ribbons.triangles) == 0


def test_depths_are_ahead_of_points_by_a_share_of_their_distance() -> None:
    near, far = 0.5, 100.0
    projection = np.diag([1.0, 1, -(far + near) / (far - near), 0])
    projection[2, 3], projection[3, 2] = -2 * far * near / (far - near), -1
    distances = np.array([near, 1.0, 10.0, far])
    points = np.array([[0.3, 0.1, 5 - z] for z in distances])
    view = np.eye(4)
    view[2, 3] = -5
    found = depths_of(points, projection, view)
    z = np.maximum(distances * (1 - AHEAD), near)
    assert found == pytest.approx((far + near - 2 * far * near / z) / (far - near))
    assert found[0] == FOREMOST and (np.diff(found) > 0).all()
    parallel = np.diag([1 / 3, 1 / 3, -2 / far, 1.0])
    parallel[2, 3] = -1
    found = depths_of(points, parallel, view)
    assert found == pytest.approx(2 * (distances - 3 * AHEAD) / far - 1)


def test_things_that_are_not_drawn_may_hide_what_is(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    assert not has_others(scene, {cube.name})
    other = bpy.data.objects.new("Other", cube.data)
    scene.collection.objects.link(other)
    assert has_others(scene, {cube.name}) and not has_others(scene, {cube.name, "Other"})
    other.hide_set(True)
    assert not has_others(scene, {cube.name})
