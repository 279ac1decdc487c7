"""Writes Grease Pencil version 3, of Blender 4.3 and later.

A layer of the add-on carries the attribute OWNER, a stroke the attributes KIND (1 + Kind; 0 is the
artist's own) and OBJECT (index of the mesh): they follow reordering and are saved.
"""

from typing import Any

import bpy
import numpy as np

from . import pencil
from .strokes import StrokeGroup

OWNER, KIND, OBJECT = "illustrate_owner", "illustrate_kind", "illustrate_object"
TYPE = "GREASEPENCIL"


def write(scene: Any, groups: list[StrokeGroup]) -> list[Any]:
    """Fills the object "Illustration" anew; the artist's own layers, frames and strokes stay."""
    illustration = pencil.find(scene, TYPE)
    if illustration is None:
        illustration = pencil.create(scene, _store().new(pencil.NAME))
    data = illustration.data
    _remove_our_strokes(data)
    for group in groups:
        layer = _our_layers(data).get(group.title) or _new_layer(data, group.title)
        _append(
            _frame(layer, scene.frame_current).drawing, group, pencil.pen(data, group.is_hatching)
        )
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
        pencil.remove(illustration, _store())


def _store() -> Any:
    """bpy.data's collection of version 3, which Blender 5 renamed."""
    return getattr(
        bpy.data, "grease_pencils_v3" if bpy.app.version < (5, 0, 0) else "grease_pencils"
    )


def _our_layers(data: Any) -> dict[str, Any]:
    owner = data.attributes.get(OWNER)
    if owner is None:
        return {}
    return {
        layer.name: layer for layer, mark in zip(data.layers, owner.data, strict=True) if mark.value
    }


def _new_layer(data: Any, title: str) -> Any:
    layer = data.layers.new(title)
    layer.use_lights = False
    owner = data.attributes.get(OWNER) or data.attributes.new(OWNER, "INT", "LAYER")
    owner.data[list(data.layers).index(layer)].value = 1
    return layer


def _frame(layer: Any, number: int) -> Any:
    """The layer's own keyframe at `number`."""
    for frame in layer.frames:
        if frame.frame_number == number:
            return frame
    return layer.frames.new(number)


def _remove_our_strokes(data: Any) -> None:
    """Keyframes that are left empty go too; layers stay, with what the artist has set on them."""
    for layer in _our_layers(data).values():
        for frame in list(layer.frames):
            kinds = frame.drawing.attributes.get(KIND)
            if kinds is None:
                continue
            values = np.zeros(len(kinds.data), np.int32)
            kinds.data.foreach_get("value", values)
            if (values > 0).all():
                layer.frames.remove(frame.frame_number)
            elif (values > 0).any():
                frame.drawing.remove_strokes(indices=np.flatnonzero(values > 0).tolist())


def _append(drawing: Any, group: StrokeGroup, pen: int) -> None:
    """Adds the strokes of a group after those that are there."""
    strokes, points = len(drawing.strokes), drawing.attributes.domain_size("POINT")
    drawing.add_strokes(group.sizes.tolist())
    _set_tail(drawing, "position", "FLOAT_VECTOR", "POINT", points, group.points)
    _set_tail(drawing, "radius", "FLOAT", "POINT", points, group.radii)
    _set_tail(drawing, "cyclic", "BOOLEAN", "CURVE", strokes, group.closed)
    pens = np.full(len(group.sizes), pen, np.int32)
    _set_tail(drawing, "material_index", "INT", "CURVE", strokes, pens)
    _set_tail(drawing, KIND, "INT", "CURVE", strokes, group.kinds + 1)
    _set_tail(drawing, OBJECT, "INT", "CURVE", strokes, group.objects)
    drawing.tag_positions_changed()


def _set_tail(drawing: Any, name: str, kind: str, domain: str, first: int, values: Any) -> None:
    """Sets an attribute of the elements from `first` on, and makes it where it is missing."""
    attribute = drawing.attributes.get(name) or drawing.attributes.new(name, kind, domain)
    field = "vector" if kind == "FLOAT_VECTOR" else "value"
    columns = values.shape[1] if values.ndim == 2 else 1
    everything = np.zeros(len(attribute.data) * columns, values.dtype)
    attribute.data.foreach_get(field, everything)
    everything[first * columns :] = values.ravel()
    attribute.data.foreach_set(field, everything)
