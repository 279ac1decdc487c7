"""Live lines and overlays without a window: what they would draw, and what they leave behind."""

import time
from typing import Any

import bpy
import formulas
import illustrate
import numpy as np
import pytest
from illustrate import illustration, native
from illustrate.viewport import inspect, live
from illustrate.viewport.inspect import INSPECTOR
from illustrate.viewport.live import LIVE
from illustrate.viewport.view_lines import ViewLines, eye_of

import tools


def handlers() -> list[str]:
    """The add-on's, by list and name."""
    lists = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    return [
        f"{name}: {handler.__module__}.{handler.__name__}"
        for name, found in lists.items()
        if isinstance(found, list)
        for handler in found
        if handler.__module__.startswith(illustrate.__name__)
    ]


def classes() -> set[str]:
    return {name for name in dir(bpy.types) if name.startswith("ILLUSTRATE_")}


def surface_of(positions: Any, faces: Any, **options: Any) -> Any:
    ill = native.load()
    sizes = [len(face) for face in faces]
    mesh = ill.PolygonMesh(positions, sizes, np.concatenate(faces))
    return ill.prepare([mesh], ill.PrepareOptions(field=False, **options)).surface


@pytest.mark.parametrize(("count", "most"), [(12, 0.02), (24, 0.005)])
def test_silhouettes_of_a_sphere_converge(count: int, most: float) -> None:
    positions, faces = formulas.sphere(1, count)
    lines = ViewLines(surface_of(positions, faces, level=1))
    ends = lines.silhouettes([0, 0, 3, 1])
    assert len(ends) >= 8
    assert np.abs(ends[:, 2] - 1 / 3).max() < most  # the circle of tangents from the eye
    ends = lines.silhouettes([0, 0, 1, 0])
    assert np.abs(ends[:, 2]).max() < most


def test_silhouettes_are_closed_and_where_the_exact_search_finds_them() -> None:
    positions, faces = formulas.torus(1, 0.4, 24, 16)
    ill = native.load()
    mesh = ill.PolygonMesh(positions, [4] * len(faces), np.concatenate(faces))
    prepared = ill.prepare([mesh], ill.PrepareOptions(field=False, level=1))
    camera = ill.Camera(
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1.02, -0.2], [0, 0, -1, 0]],
        [[1, 0, 0, 0], [0, 0.8, -0.6, 0], [0, 0.6, 0.8, -6], [0, 0, 0, 1]],
        100, 100,
    )  # fmt: skip
    eye = eye_of(camera.projection, camera.view)
    ends = ViewLines(prepared.surface).silhouettes(eye).reshape(-1, 2, 3)
    assert len(ends) == len(ill.silhouettes(prepared, camera).triangles)
    rounded, counts = np.unique(ends.reshape(-1, 3).round(4), axis=0, return_counts=True)
    assert (counts % 2 == 0).mean() > 0.99  # each end is shared with the next triangle
    assert len(rounded)


def test_silhouettes_of_faces_are_edges_between_front_and_back() -> None:
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    lines = ViewLines(surface_of(corners, faces, scheme="none"))
    ends = lines.silhouettes([0.1, 0.2, 5, 1]).reshape(-1, 2, 3)
    assert len(ends) == 4 and (ends[:, :, 2] == 1).all()
    assert len(lines.silhouettes([5, 4, 3, 1])) == 12  # a hexagon


def test_the_eye_of_a_view() -> None:
    view = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5], [0, 0, 0, 1]], float)
    assert eye_of(np.diag([1, 1, 1, 0]), view) == pytest.approx([0, 0, 5, 1])
    assert eye_of(np.eye(4), view) == pytest.approx([0, 0, 1, 0])


def wait_for_lines() -> None:
    for _ in range(500):
        LIVE.tick()
        if LIVE._worker is None and not LIVE._is_stale:
            return
        time.sleep(0.01)
    raise AssertionError("live lines were never ready")


@pytest.fixture
def _live() -> Any:
    """Handlers for drawing are only taken by a Blender with a window in some versions."""
    bpy.context.window_manager.illustrate_live = True
    yield
    bpy.context.window_manager.illustrate_live = False


def test_live_lines_follow_the_scene(scene: Any, _live: Any) -> None:
    cube = tools.cube_scene(scene)
    wait_for_lines()
    assert LIVE.lines is not None
    first = LIVE.lines.features
    assert len(first) and len(first) % 48 == 0  # ends of both sides of 12 edges
    wait_for_lines()
    assert LIVE.lines.features is first  # nothing changed, nothing was read again
    cube.location.x += 1
    bpy.context.view_layer.update()
    wait_for_lines()
    assert LIVE.lines.features[:, 0].max() == pytest.approx(first[:, 0].max() + 1)
    scene.camera.location.x += 1
    bpy.data.objects["Sun"].location.x += 1
    bpy.context.view_layer.update()
    moved = LIVE.lines
    wait_for_lines()
    assert LIVE.lines is moved
    cube.hide_set(True)
    bpy.context.view_layer.update()
    wait_for_lines()
    assert LIVE.lines is None and "can be drawn" in LIVE.problem


def test_live_lines_need_no_camera(_live: Any) -> None:
    tools.add_cube()
    wait_for_lines()
    assert LIVE.lines is not None


def test_live_lines_keep_to_their_triangles(scene: Any, _live: Any) -> None:
    tools.subdivide(tools.cube_scene(scene))
    scene.illustrate.level = 7
    wait_for_lines()
    assert LIVE.lines is not None and 100 < LIVE.lines.triangle_count <= 100_000


def test_live_lines_leave_nothing(scene: Any) -> None:
    tools.cube_scene(scene)
    before = handlers()
    manager = bpy.context.window_manager
    for _ in range(3):
        assert bpy.ops.illustrate.toggle_live() == {"FINISHED"}
        assert manager.illustrate_live and handlers() != before
        bpy.ops.illustrate.toggle_live()
        assert not manager.illustrate_live and handlers() == before
        assert not bpy.app.timers.is_registered(LIVE._tick_again)
    manager.illustrate_live = True
    tools.new_file()
    assert not LIVE.is_on and LIVE.lines is None and handlers() == before


def test_enable_disable_enable(scene: Any) -> None:
    before, registered = handlers(), classes()
    tools.cube_scene(scene)
    for _ in range(3):
        bpy.context.window_manager.illustrate_live = True
        INSPECTOR.show("FIELD")
        illustrate.unregister()
        assert not classes() and not hasattr(scene, "illustrate")
        assert not hasattr(bpy.types.Object, "illustrate")
        assert not hasattr(bpy.types.WindowManager, "illustrate_live")
        assert LIVE._handle is None and INSPECTOR._handle is None
        illustrate.register()
        assert classes() == registered and handlers() == before


def made_scene(scene: Any) -> Any:
    tools.cube_scene(scene)
    bpy.ops.mesh.primitive_monkey_add(location=(0, -2, 0.5))
    tools.subdivide(bpy.context.object)
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


@pytest.mark.parametrize("kind", list(inspect.KINDS))
def test_overlays_lie_on_the_surface(scene: Any, kind: str) -> None:
    made = made_scene(scene)
    marks = inspect.KINDS[kind][2](made)
    assert sum(len(mark.points) for mark in marks) or kind == "CUSPS"
    positions = np.asarray(made.prepared.surface.positions)
    low, high = positions.min(axis=0) - 0.1, positions.max(axis=0) + 0.1
    for mark in marks:
        assert mark.points.dtype == np.float32 and np.isfinite(mark.points).all()
        assert (mark.points >= low).all() and (mark.points <= high).all()
        assert len(mark.points) % {"LINES": 2, "POINTS": 1, "TRIS": 3}[mark.shape] == 0


def test_cusps_and_singularities_are_all_shown(scene: Any) -> None:
    made = made_scene(scene)
    cusps = sum(len(mark.points) for mark in inspect.cusps(made))
    assert cusps == (np.asarray(made.drawing.graph.node_kind) == 0).sum() > 0
    plus, minus = inspect.singularities(made)
    turns = np.asarray(made.prepared.field.singular_indices)
    assert (len(plus.points), len(minus.points)) == ((turns > 0).sum(), (turns < 0).sum())


def test_tone_regions_are_those_of_the_drawing(scene: Any) -> None:
    made = made_scene(scene)
    shown = {mark.colour: len(mark.points) for mark in inspect.tone_regions(made)}
    levels = {int(v) for v in np.unique(made.drawing.tone.level)} - {255}
    assert {v for v, colour in inspect.TONES.items() if shown[colour]} == levels
    scene.illustrate.hatching = False
    plain = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    assert inspect.tone_regions(plain) == []


def test_the_inspector_shows_the_last_illustration(scene: Any) -> None:
    manager = bpy.context.window_manager
    assert manager.illustrate_inspect == "NONE"
    manager.illustrate_inspect = "CUSPS"
    assert INSPECTOR.marks() == []
    tools.cube_scene(scene)
    bpy.ops.illustrate.illustrate()
    manager.illustrate_inspect = "FIELD"
    assert manager.illustrate_inspect == "FIELD" and INSPECTOR.marks()
    tools.new_file()
    assert bpy.context.window_manager.illustrate_inspect == "NONE" and INSPECTOR.made is None


def test_all_that_draws_can_be_imported_in_the_background() -> None:
    from illustrate.viewport import overlay

    assert overlay.Marks("LINES", [], (0, 0, 0, 1)).size > 0
    assert live.EYES[0][0] == "VIEW"
