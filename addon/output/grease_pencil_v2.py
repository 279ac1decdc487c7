"""Writes Grease Pencil version 2, of Blender up to 4.2.

Its data keeps the names of the add-on's layers. A stroke of the add-on has one of its pens and is
LINE_WIDTH wide.
"""

from typing import Any

import bpy
import numpy as np

from . import pencil
from .strokes import StrokeGroup

TYPE = "GPENCIL"
LAYERS = "illustrate_layers"
LINE_WIDTH = 1000  # an integer: so wide, a point's pressure is its width in the world


def write(scene: Any, groups: list[StrokeGroup]) -> list[Any]:
    """Fills the object "Illustration" anew; the artist's own layers, frames and strokes stay."""
    illustration = pencil.find(scene, TYPE)
    if illustration is None:
        illustration = pencil.create(scene, bpy.data.grease_pencils.new(pencil.NAME))
    data = illustration.data
    _remove_our_strokes(data)
    for group in groups:
        layer = _our_layers(data).get(group.title) or _new_layer(data, group.title)
        _append(_frame(layer, scene.frame_current), group, pencil.pen(data, group.is_hatching))
    return [illustration]


def clear(scene: Any) -> None:
    """Removes the add-on's strokes, and the object when nothing of the artist's is in it."""
    illustration = pencil.find(scene, TYPE)
    if illustration is None:
        return
    data = illustration.data
    _remove_our_strokes(data)
    for layer in _our_layers(data).values():
        if not len(layer.frames):
            data.layers.remove(layer)
    if not len(data.layers):
        pencil.remove(illustration, bpy.data.grease_pencils)


def _our_layers(data: Any) -> dict[str, Any]:
    names = set(data.get(LAYERS, "").split("\n"))
    return {layer.info: layer for layer in data.layers if layer.info in names}


def _new_layer(data: Any, title: str) -> Any:
    layer = data.layers.new(title, set_active=False)
    layer.use_lights = False
    data[LAYERS] = "\n".join([*_our_layers(data), layer.info])
    return layer


def _frame(layer: Any, number: int) -> Any:
    """The layer's own keyframe at `number`."""
    for frame in layer.frames:
        if frame.frame_number == number:
            return frame
    return layer.frames.new(number)


def _remove_our_strokes(data: Any) -> None:
    """Keyframes that are left empty go too; layers stay, with what the artist has set on them."""
    pens = pencil.our_pens(data)
    for layer in _our_layers(data).values():
        for frame in list(layer.frames):
            ours = [
                stroke
                for stroke in frame.strokes
                if stroke.line_width == LINE_WIDTH and stroke.material_index in pens
            ]
            if ours and len(ours) == len(frame.strokes):
                layer.frames.remove(frame)
                continue
            for stroke in ours:
                frame.strokes.remove(stroke)


def _append(frame: Any, group: StrokeGroup, pen: int) -> None:
    """Adds the strokes of a group after those that are there."""
    ends = np.cumsum(group.sizes)
    for size, end, closed in zip(
        group.sizes.tolist(), ends.tolist(), group.closed.tolist(), strict=True
    ):
        stroke = frame.strokes.new()
        stroke.display_mode = "3DSPACE"
        stroke.line_width, stroke.material_index, stroke.use_cyclic = LINE_WIDTH, pen, closed
        stroke.points.add(size)
        span = slice(end - size, end)
        stroke.points.foreach_set("co", group.points[span].ravel())
        stroke.points.foreach_set("pressure", 2 * group.radii[span])
        stroke.points.foreach_set("strength", np.ones(size, np.float32))
