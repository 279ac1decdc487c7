"""The pictures of docs/first-drawing.md, taken of the screen as a newcomer sees it.

    blender --factory-startup --enable-event-simulate \
        --python blender_tests/window/first_drawing.py -- out/first-drawing

and then copied to docs/pictures/first-drawing.
"""

import pathlib
import sys
from collections.abc import Generator
from typing import Any

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import drive  # noqa: E402

COLOURS = "32"  # of a picture: enough for a screen, and small
VIEWPORT = "1056x690+0+28"


def take(path: pathlib.Path) -> None:
    """A picture of the screen with few colours."""
    import hands

    hands.picture(path, "-crop", VIEWPORT, "+repage", "+dither", "-colors", COLOURS)


def first_drawing(out: pathlib.Path) -> Generator[Any, None, None]:
    """The panel, the drawing, and the drawing alone."""
    import hands
    import staging
    from illustrate.running import tasks

    staging.new_scene()
    yield 0.5
    with hands.override():
        bpy.ops.view3d.view_camera()
        bpy.ops.object.select_all(action="DESELECT")
    yield from staging.open_panel()
    take(out / "panel.png")
    hands.click(*hands.button_place())
    yield tasks.is_running
    yield lambda: not tasks.is_running()
    yield 0.5
    take(out / "drawn.png")
    hands.click(*hands.paper_button_place())
    yield 1.0
    take(out / "strokes.png")


if __name__ == "__main__":
    drive.provide()
    drive.run([first_drawing])
