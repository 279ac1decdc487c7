"""The page about the camera's frame, and the ways with the pen up, over the viewport."""

from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from ..messages import IllustrateError
from ..plot.plots import PLANNED, page_of
from ..reading.scene import camera_problem, frame_corners, read_camera
from .shown import Shown

PAPER, MARGIN, TRAVEL = (1.0, 1.0, 1.0, 1.0), (0.3, 0.6, 1.0, 1.0), (0.9, 0.1, 0.1, 0.7)


def rectangle(box: Any) -> Any:
    """(8, 2) ends of the four sides of a box: left, top, right, bottom."""
    left, top, right, bottom = box
    corners = np.array([(left, top), (right, top), (right, bottom), (left, bottom)], float)
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1).reshape(-1, 2)


def on_frame(points_mm: Any, placing: Any, size_px: Any, corners: Any) -> Any:
    """(n, 3) where points on the page lie in the plane of a camera's frame.

    size_px: of the picture; corners: (3, 3) the frame's top left, top right and bottom left.
    """
    pixels = (points_mm - np.array(placing.shift_mm)) / placing.scale
    share = pixels / np.array(size_px, float)
    origin, right, down = corners[0], corners[1] - corners[0], corners[2] - corners[0]
    return origin + share[:, :1] * right + share[:, 1:] * down


class PageOverlay(Shown):
    """What is shown, and the handle that Blender has of it."""

    def __init__(self) -> None:
        self.shows_page = self.shows_travel = False

    def show(self, page: bool, travel: bool) -> None:
        """Switches the page and the ways with the pen up on or off."""
        self.shows_page, self.shows_travel = page, travel
        self._switch(page or travel)

    def lines(self, scene: Any, depsgraph: Any) -> list[tuple[Any, Any]]:
        """Ends of lines (n, 3) in the world, with their colours; none without a usable camera."""
        if camera_problem(scene):
            return []
        camera = read_camera(scene, depsgraph)
        size, corners = (camera.width_px, camera.height_px), frame_corners(scene)
        found = []
        for placing, points, colour in self._flat(scene, camera):
            found.append((on_frame(points, placing, size, corners), colour))
        return found

    def _flat(self, scene: Any, camera: Any) -> list[tuple[Any, Any, Any]]:
        """Placing, ends of lines in millimetres, colour."""
        plot = PLANNED.plot if scene.name == PLANNED.scene_name else None
        found = []
        if self.shows_page:
            laid = _laid(scene, camera) or (plot and (plot.page, plot.placing))
            if laid:
                page, placing = laid
                whole = (0.0, 0.0, page.width_mm, page.height_mm)
                boxes = ((whole, PAPER), (page.inner, MARGIN))
                found += [(placing, rectangle(box), colour) for box, colour in boxes]
        if self.shows_travel and plot:
            found += [(plot.placing, ways.reshape(-1, 2), TRAVEL) for ways in plot.travel()]
        return found

    def _draw(self) -> None:
        context = bpy.context
        if context.region_data.view_perspective != "CAMERA":
            return
        from . import overlay

        lines = self.lines(context.scene, context.evaluated_depsgraph_get())
        marks = [
            overlay.Marks("LINES", np.ascontiguousarray(points, np.float32), colour)
            for points, colour in lines
        ]
        overlay.draw(marks, context.region, context.region_data, in_front=True)


def _laid(scene: Any, camera: Any) -> Any:
    """The page of the settings; None where it cannot be told before the drawing is there."""
    try:
        return page_of(scene, camera)
    except IllustrateError:
        return None


OVERLAY = PageOverlay()
"""The overlay of this Blender."""


@persistent
def _before_load(*_: Any) -> None:
    OVERLAY.show(False, False)
    PLANNED.remember("", None)


def register() -> None:
    """Registers the switches."""
    bpy.types.WindowManager.illustrate_show_page = bpy.props.BoolProperty(
        name="Page",
        description="Show the page and its margins about the camera's frame",
        get=lambda _manager: OVERLAY.shows_page,
        set=lambda _manager, is_on: OVERLAY.show(is_on, OVERLAY.shows_travel),
    )
    bpy.types.WindowManager.illustrate_show_travel = bpy.props.BoolProperty(
        name="Pen Up",
        description="Show the ways with the pen up of the plot that was exported last",
        get=lambda _manager: OVERLAY.shows_travel,
        set=lambda _manager, is_on: OVERLAY.show(OVERLAY.shows_page, is_on),
    )
    bpy.app.handlers.load_pre.append(_before_load)


def unregister() -> None:
    """Shows nothing any more and takes the switches away."""
    OVERLAY.show(False, False)
    bpy.app.handlers.load_pre.remove(_before_load)
    del bpy.types.WindowManager.illustrate_show_page
    del bpy.types.WindowManager.illustrate_show_travel
