"""What an artist's hands and eyes do: clicks, keys, looks."""

import contextlib
import pathlib
import subprocess
from collections.abc import Iterator
from typing import Any

import bpy

PANEL = "ILLUSTRATE_PT_main"
OF_REGISTERED = ("bl_rna", "__dict__", "__weakref__")  # what no copy of a class may have
_drawn: list[int] = [0]


def window() -> Any:
    return bpy.context.window_manager.windows[0]


def manager() -> Any:
    return bpy.context.window_manager


def viewport() -> Any:
    """The largest area with a 3D view."""
    areas = [area for area in window().screen.areas if area.type == "VIEW_3D"]
    return max(areas, key=lambda area: area.width * area.height)


def region(kind: str) -> Any:
    return next(region for region in viewport().regions if region.type == kind)


def override() -> Any:
    """The context of the 3D view: timers have none."""
    return bpy.context.temp_override(window=window(), area=viewport(), region=region("WINDOW"))


def show_side_panel(shown: bool) -> None:
    with override():
        viewport().spaces.active.show_region_ui = shown


def click(x: int, y: int) -> None:
    """Buttons hear of a click only when the mouse was over them before."""
    move(x, y)
    move(x + 1, y)
    for value in ("PRESS", "RELEASE"):
        window().event_simulate(type="LEFTMOUSE", value=value, x=int(x) + 1, y=int(y))


def move(x: int, y: int) -> None:
    window().event_simulate(type="MOUSEMOVE", value="NOTHING", x=int(x), y=int(y))


def press(key: str, **modifiers: bool) -> None:
    for value in ("PRESS", "RELEASE"):
        window().event_simulate(
            type=key, value=value, x=window().width // 2, y=window().height // 2, **modifiers
        )


def watch_panel() -> None:
    """From now on it is known when Blender draws the panel."""
    panel = getattr(bpy.types, PANEL)
    draw = panel.draw
    if draw.__name__ == "watched":
        return

    def watched(self: Any, context: Any) -> None:
        _drawn[0] += 1
        draw(self, context)

    panel.draw = watched


def panel_was_drawn() -> bool:
    seen, _drawn[0] = _drawn[0], 0
    return seen > 0


def tab_places() -> list[tuple[int, int]]:
    """Where the tabs of the side panel may be, from top to bottom."""
    side = region("UI")
    return [(side.x + side.width - 10, y) for y in range(side.y + side.height - 15, side.y, -25)]


def button_place() -> tuple[int, int]:
    """The middle of the big button, right below the head of the panel."""
    side = region("UI")
    return side.x + side.width // 2 - 12, side.y + side.height - 52


def paper_button_place() -> tuple[int, int]:
    """The middle of the sheet beside the big button."""
    side = region("UI")
    return side.x + side.width - 48, button_place()[1]


@contextlib.contextmanager
def opened(panel: Any) -> Iterator[None]:
    """A panel as it is when it is open, below all others.

    A copy and no heir: with an heir that goes Blender forgets the class of the panel, too.
    """
    own = {name: value for name, value in vars(panel).items() if name not in OF_REGISTERED}
    copy = type(panel.__name__ + "_open", panel.__bases__, own | {
        "bl_idname": panel.bl_idname + "_open", "bl_options": set(), "bl_parent_id": "",
        "bl_order": 1000,
    })  # fmt: skip
    bpy.utils.register_class(copy)
    try:
        yield
    finally:
        bpy.utils.unregister_class(copy)


def scroll_to_the_end(area: Any, kind: str) -> None:
    """As with the wheel over a column of panels."""
    column = next(region for region in area.regions if region.type == kind)
    with bpy.context.temp_override(window=window(), area=area, region=column):
        for _ in range(100):
            bpy.ops.view2d.scroll_down()


def show_properties(tab: str) -> Any:
    """The properties editor with a tab open."""
    area = next(area for area in window().screen.areas if area.type == "PROPERTIES")
    area.spaces.active.context = tab
    return area


def redraw() -> None:
    with override():
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)


def picture(path: pathlib.Path, *options: str) -> Any:
    """Takes a picture of the screen, with options of ImageMagick's `import`; its file."""
    redraw()
    subprocess.run(["import", "-window", "root", *options, str(path)], check=True, timeout=60)
    return path


def pixels(path: pathlib.Path) -> Any:
    """(h, w, 3) of the 3D view in a picture of the screen, 0 .. 1, top row first."""
    import numpy as np

    image = bpy.data.images.load(str(path))
    values = np.zeros(len(image.pixels), np.float32)
    image.pixels.foreach_get(values)
    width, height = image.size
    bpy.data.images.remove(image)
    shown = region("WINDOW")
    rows = values.reshape(height, width, -1)[:, :, :3]
    return rows[shown.y : shown.y + shown.height, shown.x : shown.x + shown.width][::-1]
