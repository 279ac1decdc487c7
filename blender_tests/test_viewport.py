"""Overlays and switches without a window: what they would draw, and what they leave behind."""

from typing import Any

import bpy
import illustrate
import numpy as np
import pytest
from illustrate.running import illustration
from illustrate.viewport import inspect
from illustrate.viewport.inspect import INSPECTOR, eye_of
from illustrate.viewport.live import LIVE
from illustrate.viewport.live_view import EYES, VIEW

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


def test_the_eye_of_a_view() -> None:
    view = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5], [0, 0, 0, 1]], float)
    assert eye_of(np.diag([1, 1, 1, 0]), view) == pytest.approx([0, 0, 5, 1])
    assert eye_of(np.eye(4), view) == pytest.approx([0, 0, 1, 0])


def test_the_live_drawing_leaves_nothing(scene: Any) -> None:
    tools.cube_scene(scene)
    before = handlers()
    manager = bpy.context.window_manager
    for _ in range(3):
        assert bpy.ops.illustrate.toggle_live() == {"FINISHED"}
        assert manager.illustrate_live and handlers() != before
        bpy.ops.illustrate.toggle_live()
        assert not manager.illustrate_live and handlers() == before
        assert not bpy.app.timers.is_registered(VIEW._tick_again)
    manager.illustrate_live = True
    tools.new_file()
    assert not VIEW.is_on and LIVE.prepared is None and handlers() == before


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
        assert not VIEW.is_on and INSPECTOR._handle is None
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
    assert EYES[0][0] == "VIEW"
