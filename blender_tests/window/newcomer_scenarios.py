"""docs/first-drawing.md, followed word by word from Blender's own first scene."""

import pathlib
import tempfile
from collections.abc import Generator
from typing import Any

import bpy
import hands
from illustrate.running import tasks
from illustrate.viewport.paper import PAPER
from staging import Steps, open_panel, pencils, strokes


def first_scene() -> Any:
    """What Blender starts with: a cube, a camera and a light."""
    with hands.override():
        bpy.ops.wm.read_homefile(use_factory_startup=True, load_ui=False)
    PAPER.was_offered = True  # a menu over the panel would take the clicks
    return hands.window().scene


def drawn_once() -> Steps:
    """The big button, and what follows."""
    hands.click(*hands.button_place())
    yield tasks.is_running
    yield lambda: not tasks.is_running()
    yield 0.5


def on_paper() -> Generator[Any, None, bool]:
    """Presses the sheet beside the big button; whether the viewport is on paper then."""
    hands.click(*hands.paper_button_place())
    yield 0.5
    return bool(PAPER.is_on(hands.viewport().spaces.active))


def smooth_head() -> None:
    """Suzanne in place of the cube, by Blender's own menus."""
    with hands.override():
        bpy.ops.object.select_all(action="DESELECT")
        bpy.data.objects["Cube"].select_set(True)
        bpy.ops.object.delete()
        bpy.ops.mesh.primitive_monkey_add()
        bpy.ops.object.shade_smooth()
        bpy.ops.object.subdivision_set(level=2)


def a_newcomer_follows_the_page(out: pathlib.Path) -> Steps:
    """The cube, then Suzanne in its place, both through the camera; on paper; into a file."""
    scene = first_scene()
    yield 0.5
    hands.move(400, 400)
    hands.press("NUMPAD_0")
    yield from open_panel()
    yield from drawn_once()
    hands.picture(out / "50_the_cube.png")
    assert [pencil.name for pencil in pencils()] == ["Illustration"] and strokes() >= 3
    smooth_head()
    yield from drawn_once()
    hands.picture(out / "51_the_head.png")
    assert len(pencils()) == 1 and strokes() > 50
    assert (yield from on_paper())
    scene.camera.location *= 0.6
    yield from drawn_once()
    hands.picture(out / "52_the_head_nearer_on_paper.png")
    assert len(pencils()) == 1 and strokes() > 50
    assert not (yield from on_paper())
    with tempfile.TemporaryDirectory() as folder, hands.override():
        path = pathlib.Path(folder) / "drawing.svg"
        assert bpy.ops.illustrate.export_drawing(filepath=str(path)) == {"FINISHED"}
        assert path.read_text(encoding="utf-8").count("<path") >= 3


ALL = [a_newcomer_follows_the_page]
