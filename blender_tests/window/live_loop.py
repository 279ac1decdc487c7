"""The pictures of the README's loop: the live drawing while a view turns, and when it rests.

    blender --factory-startup --enable-event-simulate \
        --python blender_tests/window/live_loop.py -- out/live-loop

and then joined by tools/docs/join_loop.py.
"""

import math
import pathlib
import sys
from collections.abc import Generator
from typing import Any

from mathutils import Euler

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import drive  # noqa: E402

FIRST_VIEW = Euler((math.radians(75), 0, math.radians(-35))).to_quaternion()
STEPS = 13  # of half a swing
STEP = math.radians(5)
SHOWN = "720x560"  # of the viewport, round its middle
SCALE = "80%"


def take(path: pathlib.Path) -> None:
    """The middle of the viewport, smaller, in greys."""
    import hands

    region = hands.region("WINDOW")
    width, height = (int(side) for side in SHOWN.split("x"))
    left = region.x + (region.width - width) // 2
    below = region.y + (region.height - height) // 2
    top = hands.window().height - below - height
    crop = ["-crop", f"{SHOWN}+{left}+{top}", "+repage"]
    hands.picture(path, *crop, "-resize", SCALE, "-colorspace", "Gray", "-depth", "8")


def as_paper() -> None:
    """White surfaces on white, and nothing else in the viewport."""
    import hands

    space = hands.viewport().spaces.active
    space.shading.light, space.shading.color_type = "FLAT", "SINGLE"
    space.shading.background_type = "VIEWPORT"
    space.shading.single_color = space.shading.background_color = (1.0, 1.0, 1.0)
    space.overlay.show_overlays = space.show_gizmo = False
    with hands.override():
        space.show_region_toolbar = space.show_region_header = False


def live_loop(out: pathlib.Path) -> Generator[Any, None, None]:
    """Half a swing, a rest, and back."""
    import hands
    import live_scenarios
    import staging

    staging.new_scene()
    hands.show_side_panel(False)
    as_paper()
    view = live_scenarios.region_view()
    view.view_rotation, view.view_distance = FIRST_VIEW, 3.5
    hands.manager().illustrate_live = True
    yield 0.3
    hands.redraw()
    yield live_scenarios.is_hatched
    for half, way in enumerate((STEP, -STEP)):
        for step in range(STEPS):
            live_scenarios.turn(way)
            take(out / f"{half}_{step:02d}_moving.png")
        hands.redraw()
        yield live_scenarios.is_hatched
        take(out / f"{half}_{STEPS:02d}_resting.png")


if __name__ == "__main__":
    drive.provide()
    drive.run([live_loop])
