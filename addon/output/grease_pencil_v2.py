"""Grease Pencil version 2, of Blender up to 4.2, for pencil.py.

Its data keeps the names of the add-on's layers, and kind, object and invisibility of its strokes in
the order in which they were drawn: strokes have no attributes. A stroke of the add-on has one of
its pens or fills and is LINE_WIDTH wide.
"""

from typing import Any

import bpy
import numpy as np

from . import fills, pens
from .strokes import StrokeGroup

TYPE = "GPENCIL"
NAME = "Illustration"
LAYERS, STROKES = "illustrate_layers", "illustrate_strokes"
LINE_WIDTH = 1000  # an integer: so wide, a point's pressure is its width in the world


def new_data() -> Any:
    """Data without layers."""
    return bpy.data.grease_pencils.new(NAME)


def remove_data(data: Any) -> None:
    """Removes data that nothing uses."""
    bpy.data.grease_pencils.remove(data)


def our_layers(data: Any) -> dict[str, Any]:
    """The add-on's layers by their titles, lowest first."""
    names = set(data.get(LAYERS, "").split("\n"))
    return {layer.info: layer for layer in data.layers if layer.info in names}


def new_layer(data: Any, title: str) -> Any:
    """Adds a layer of the add-on's own."""
    layer = data.layers.new(title, set_active=False)
    data.layers.move(layer, "UP")
    # On by default: lamps would shade the ink.
    layer.use_lights = False
    data[LAYERS] = "\n".join([*our_layers(data), layer.info])
    return layer


def remove_layer(data: Any, layer: Any) -> None:
    """Removes a layer."""
    data.layers.remove(layer)


def lower(data: Any, layer: Any) -> None:
    """Moves a layer one down."""
    data.layers.move(layer, "DOWN")


def count(data: Any, _layer: Any, frame: Any) -> tuple[int, int]:
    """Strokes of the add-on and all strokes of a keyframe."""
    return len(_ours(data, frame)), len(frame.strokes)


def _ours(data: Any, frame: Any) -> list[Any]:
    indices = {*pens.of_data(data).values(), *fills.of_data(data).values()}
    return [
        stroke
        for stroke in frame.strokes
        if stroke.line_width == LINE_WIDTH and stroke.material_index in indices
    ]


def remove_frame(data: Any, layer: Any, frame: Any) -> None:
    """Removes a keyframe with all that is in it."""
    _forget(data, layer, frame)
    layer.frames.remove(frame)


def remove_strokes(data: Any, layer: Any, frame: Any) -> None:
    """Removes the add-on's strokes of a keyframe."""
    _forget(data, layer, frame)
    for stroke in _ours(data, frame):
        frame.strokes.remove(stroke)


def append(data: Any, layer: Any, frame: Any, group: StrokeGroup, pens: Any) -> None:
    """Adds the strokes of a group after those that are there."""
    ends, points, widths = np.cumsum(group.sizes), group.points, 2 * group.radii
    for size, end, closed, pen in zip(
        group.sizes.tolist(), ends.tolist(), group.closed.tolist(), pens.tolist(), strict=True
    ):
        stroke = frame.strokes.new()
        # Without it points are places on the screen.
        stroke.display_mode = "3DSPACE"
        stroke.line_width, stroke.material_index, stroke.use_cyclic = LINE_WIDTH, pen, closed
        stroke.points.add(size, strength=1.0)
        span = slice(end - size, end)
        stroke.points.foreach_set("co", points[span].ravel())
        stroke.points.foreach_set("pressure", widths[span])
        if group.inks:
            stroke.points.update()  # the triangles of its fill
    _remember(data, layer, frame, group)


def _remember(data: Any, layer: Any, frame: Any, group: StrokeGroup) -> None:
    """Keeps kind, object and invisibility of each stroke, one after the other."""
    if STROKES not in data:
        data[STROKES] = {}
    told = np.stack([group.kinds, group.objects, group.invisibility], axis=1)
    data[STROKES][_name(layer, frame)] = told.ravel().tolist()


def _forget(data: Any, layer: Any, frame: Any) -> None:
    if STROKES in data and _name(layer, frame) in data[STROKES]:
        del data[STROKES][_name(layer, frame)]


def _name(layer: Any, frame: Any) -> str:
    return f"{layer.info} {frame.frame_number}"
