"""What is shown over the 3D viewports, and asking Blender to draw them anew."""

from typing import Any

import bpy


class Shown:
    """Mixin of what Blender draws over each 3D viewport while it is wanted, by calling `_draw`."""

    _handle: Any = None  # Blender's

    def _switch(self, on: bool) -> None:
        """Asks Blender to draw it from now on, or no more."""
        view = bpy.types.SpaceView3D
        if on and self._handle is None:
            self._handle = view.draw_handler_add(self._draw, (), "WINDOW", "POST_VIEW")
        elif not on and self._handle is not None:
            view.draw_handler_remove(self._handle, "WINDOW")
            self._handle = None
        redraw()

    def _draw(self) -> None:
        raise NotImplementedError


def viewports(context: Any) -> list[Any]:
    """The areas with 3D views of all windows."""
    windows = context.window_manager.windows
    return [area for w in windows for area in w.screen.areas if area.type == "VIEW_3D"]


def redraw() -> None:
    """Asks Blender to draw all 3D views anew."""
    for area in viewports(bpy.context):
        area.tag_redraw()
