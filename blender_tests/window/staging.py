"""Scenes that the scenarios work in, and what they find there."""

import pathlib
from collections.abc import Generator
from typing import Any

import bpy
import hands
from illustrate.viewport.paper import PAPER

import tools

Steps = Generator[Any, None, None]


def new_scene(detail: int = 2) -> Any:
    """Suzanne, subdivided, with a camera and a sun, and nothing else."""
    with hands.override():
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True, load_ui=False)
    PAPER.was_offered = True  # a menu over the panel would take the clicks
    scene = hands.window().scene
    tools.add_camera(scene, (2.5, -5, 2), (1000, 1000))
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.rotation_euler = (0.6, 0.5, 0)
    scene.collection.objects.link(sun)
    with hands.override():
        bpy.ops.mesh.primitive_monkey_add()
    monkey = hands.window().view_layer.objects.active
    tools.subdivide(monkey, levels=detail)
    tools.shade_smooth(monkey, [True] * len(monkey.data.polygons))
    hands.viewport().spaces.active.region_3d.view_distance = 5.0
    with hands.override():
        bpy.ops.ed.undo_push(message="New Scene")
    return scene


def has_brushes() -> bool:
    """Whether one can draw and sculpt: from 4.3 on brushes are files, not in Debian 13."""
    if bpy.app.version < (4, 3, 0):
        return True
    assets = pathlib.Path(bpy.utils.system_resource("DATAFILES")) / "assets" / "brushes"
    return assets.is_dir()


def pencils() -> list[Any]:
    return [thing for thing in bpy.data.objects if thing.type == tools.pencil_type()]


def strokes() -> int:
    return sum(len(found) for thing in pencils() for found in tools.read_pencil(thing).values())


def open_panel() -> Steps:
    """Opens the side panel and finds the add-on's tab as one who clicks on one after the other."""
    hands.show_side_panel(True)
    hands.watch_panel()
    yield 0.5
    for place in hands.tab_places():
        hands.click(*place)
        yield 0.3
        hands.redraw()
        hands.panel_was_drawn()  # forgets what was drawn before the click was heard
        hands.redraw()
        if hands.panel_was_drawn():
            return
    raise AssertionError("no tab shows the panel")
