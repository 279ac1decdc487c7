"""Grease Pencil version 3, of Blender 4.3 and later, for pencil.py.

A layer of the add-on carries the attribute OWNER, a stroke the attributes KIND (1 + Kind; 0 is the
artist's own), OBJECT (index of the mesh), INVISIBILITY (layers of surface in front), STROKE_ID (its
number through the frames of a sequence) and STROKE_START (px along it that its first point counts
as): they follow reordering and are saved.
"""

from typing import Any

import bpy
import numpy as np

from .strokes import StrokeGroup

# An attribute, since layers take no ID properties, in no version.
OWNER = "illustrate_owner"
KIND, OBJECT, INVISIBILITY = "illustrate_kind", "illustrate_object", "illustrate_invisibility"
STROKE_ID, STROKE_START = "stroke_id", "stroke_start"
FILL_ID = "fill_id"  # Blender's own: strokes of one number are one fill, 0 is none
HAS_FILL_IDS = bpy.app.version >= (5, 1, 0)
TYPE = "GREASEPENCIL"
NAME = "Illustration"


def _store() -> Any:
    """bpy.data's collection of version 3, which Blender 5 renamed."""
    return getattr(
        bpy.data, "grease_pencils_v3" if bpy.app.version < (5, 0, 0) else "grease_pencils"
    )


def new_data() -> Any:
    """Data without layers."""
    return _store().new(NAME)


def remove_data(data: Any) -> None:
    """Removes data that nothing uses."""
    _store().remove(data)


def our_layers(data: Any) -> dict[str, Any]:
    """The add-on's layers by their titles, lowest first."""
    owner = data.attributes.get(OWNER)
    if owner is None:
        return {}
    return {
        layer.name: layer for layer, mark in zip(data.layers, owner.data, strict=True) if mark.value
    }


def new_layer(data: Any, title: str) -> Any:
    """Adds a layer of the add-on's own, in the group that its other layers are in."""
    ours = our_layers(data)
    group = next((layer.parent_group for layer in ours.values() if layer.parent_group), None)
    if group is None and not ours:
        group = data.layer_groups.new(NAME)
    layer = data.layers.new(title)
    if group is not None:
        data.layers.move_to_layer_group(layer, group)
    # On by default from 4.5 on: lamps would shade the ink.
    layer.use_lights = False
    owner = data.attributes.get(OWNER) or data.attributes.new(OWNER, "INT", "LAYER")
    owner.data[list(data.layers).index(layer)].value = 1
    return layer


def remove_layer(data: Any, layer: Any) -> None:
    """Removes a layer, and the group that it leaves empty."""
    group = layer.parent_group
    data.layers.remove(layer)
    if group is not None and group.name == NAME and not _members(data, group):
        data.layer_groups.remove(group)


def _members(data: Any, group: Any) -> list[Any]:
    return [child for child in (*data.layers, *data.layer_groups) if child.parent_group == group]


def lower(data: Any, layer: Any) -> None:
    """Moves a layer one down."""
    data.layers.move(layer, "DOWN")


def count(_data: Any, _layer: Any, frame: Any) -> tuple[int, int]:
    """Strokes of the add-on and all strokes of a keyframe."""
    return int(_is_ours(frame.drawing).sum()), len(frame.drawing.strokes)


def _is_ours(drawing: Any) -> Any:
    """(s,) bool, of each stroke."""
    kinds = drawing.attributes.get(KIND)
    if kinds is None:
        return np.zeros(len(drawing.strokes), bool)
    values = np.zeros(len(kinds.data), np.int32)
    kinds.data.foreach_get("value", values)
    return values > 0


def remove_frame(_data: Any, layer: Any, frame: Any) -> None:
    """Removes a keyframe with all that is in it."""
    layer.frames.remove(frame.frame_number)


def remove_strokes(_data: Any, _layer: Any, frame: Any) -> None:
    """Removes the add-on's strokes of a keyframe."""
    frame.drawing.remove_strokes(indices=np.flatnonzero(_is_ours(frame.drawing)).tolist())


def append(_data: Any, _layer: Any, frame: Any, group: StrokeGroup, pens: Any) -> None:
    """Adds the strokes of a group after those that are there."""
    drawing = frame.drawing
    strokes, points = len(drawing.strokes), drawing.attributes.domain_size("POINT")
    drawing.add_strokes(group.sizes.tolist())
    _set_tail(drawing, "position", "FLOAT_VECTOR", "POINT", points, group.points)
    _set_tail(drawing, "radius", "FLOAT", "POINT", points, group.radii)
    _set_tail(drawing, "cyclic", "BOOLEAN", "CURVE", strokes, group.closed)
    _set_tail(drawing, "material_index", "INT", "CURVE", strokes, pens)
    _set_tail(drawing, KIND, "INT", "CURVE", strokes, group.kinds + 1)
    _set_tail(drawing, OBJECT, "INT", "CURVE", strokes, group.objects)
    _set_tail(drawing, INVISIBILITY, "INT", "CURVE", strokes, group.invisibility)
    _set_tail(drawing, STROKE_ID, "INT", "CURVE", strokes, group.ids)
    _set_tail(drawing, STROKE_START, "FLOAT", "CURVE", strokes, group.starts)
    if group.inks and HAS_FILL_IDS:
        _set_tail(drawing, FILL_ID, "INT", "CURVE", strokes, _new_fills(drawing, len(pens)))
    # Blender does not notice positions that are set as an attribute.
    drawing.tag_positions_changed()


def _new_fills(drawing: Any, count: int) -> Any:
    """(count,) numbers of fills that the drawing does not have."""
    there = drawing.attributes.get(FILL_ID)
    last = max((value.value for value in there.data), default=0) if there is not None else 0
    return np.arange(last + 1, last + 1 + count, dtype=np.int32)


def _set_tail(drawing: Any, name: str, kind: str, domain: str, first: int, values: Any) -> None:
    """Sets an attribute of the elements from `first` on, and makes it where it is missing."""
    # Asked for each time: when strokes are removed, 4.3 drops all attributes but the position.
    attribute = drawing.attributes.get(name) or drawing.attributes.new(name, kind, domain)
    field = "vector" if kind == "FLOAT_VECTOR" else "value"
    columns = values.shape[1] if values.ndim == 2 else 1
    everything = np.zeros(len(attribute.data) * columns, values.dtype)
    attribute.data.foreach_get(field, everything)
    everything[first * columns :] = values.ravel()
    attribute.data.foreach_set(field, everything)
