"""Grease Pencil on paper in thin smooth lines, for Blender 5.0 and later.

There a viewport draws strokes that are thinner than a pixel of the screen as loose dots. On paper
they are shown as ribbons instead (`ribbons.py`), as long as ribbons can show all of them: strokes
of one colour, without fills, effects or masks, that nobody is editing. Else Blender draws them.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import bpy
import numpy as np

from ..output import PENCIL_API
from ..reading.shown import shown_objects
from .ribbons import Ribbons, ribbons_of
from .views import FOREMOST

IS_NEEDED = bpy.app.version >= (5, 0, 0)
BEYOND_LINES = ("fill_id", "vertex_color", "softness")
"""Attributes of what ribbons do not show."""
COLOURING = ("GREASE_PENCIL_COLOR", "GREASE_PENCIL_TINT", "GREASE_PENCIL_TEXTURE")
Strokes = tuple[Any, Any, Any, Any, Any]  # points, diameters, sizes, closed, colours


def can_show(view_layer: Any) -> bool:
    """Whether ribbons show what Blender would."""
    active = view_layer.objects.active
    if not IS_NEEDED or (active is not None and active.mode != "OBJECT"):
        return False
    return all(_is_plain(thing) for thing in _pencils(view_layer))


def ribbons_on_paper(context: Any) -> Ribbons | None:
    """All strokes that are shown, the lowest first, in a region's pixels; None where are none."""
    depsgraph = context.evaluated_depsgraph_get()
    found = [
        strokes
        for thing in _pencils(context.view_layer)
        for strokes in _strokes_of(thing.evaluated_get(depsgraph))
    ]
    if not found:
        return None
    return _in_region([np.concatenate(part) for part in zip(*found, strict=True)], context)


def _in_region(strokes: Sequence[Any], context: Any) -> Ribbons:
    """Strokes as a region shows them; those that pass behind the eye are left out."""
    points, diameters, sizes, closed, colours = strokes
    region, data = context.region, context.region_data
    clip = np.c_[points, np.ones(len(points))] @ np.array(data.perspective_matrix).T
    is_before = np.logical_and.reduceat(clip[:, 3] > 0, np.cumsum(sizes) - sizes)
    kept, sizes = np.repeat(is_before, sizes), sizes[is_before]
    clip, diameters = clip[kept], diameters[kept]
    pixels = (clip[:, :2] / clip[:, 3:] + 1) / 2 * (region.width, region.height)
    scale = np.array(data.window_matrix)[1, 1] * region.height / 2 / clip[:, 3]
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    shown = closed[is_before], colours[is_before]
    return ribbons_of(pixels, diameters * scale, offsets, *shown, FOREMOST)


def _pencils(view_layer: Any) -> list[Any]:
    """Objects of Grease Pencil that are shown."""
    return [thing for thing in shown_objects(view_layer) if thing.type == PENCIL_API.TYPE]


def _is_plain(thing: Any) -> bool:
    """Ribbons show all that it has."""
    slots = [slot.material for slot in thing.material_slots if slot.material is not None]
    styles = [material.grease_pencil for material in slots if material.grease_pencil is not None]
    changes_colours = any(modifier.type in COLOURING for modifier in thing.modifiers)
    return (
        not changes_colours
        and not len(thing.shader_effects)
        and all(map(_is_plain_line, styles))
        and all(map(_is_plain_layer, thing.data.layers))
    )


def _is_plain_line(style: Any) -> bool:
    is_line = style.stroke_style == "SOLID" and style.mode == "LINE"
    return is_line and not style.show_fill and not style.use_stroke_holdout


def _is_plain_layer(layer: Any) -> bool:
    """Where it is drawn, in the colours of its materials, without fills."""
    is_moved = any((*layer.translation, *layer.rotation)) or tuple(layer.scale) != (1, 1, 1)
    is_changed = layer.tint_factor > 0 or layer.radius_offset != 0 or layer.parent is not None
    if is_moved or is_changed or layer.use_masks or layer.blend_mode != "REGULAR":
        return False
    frame = layer.current_frame()
    attributes = () if frame is None else frame.drawing.attributes
    return not any(_has_values(each) for each in attributes if each.name in BEYOND_LINES)


def _has_values(attribute: Any) -> bool:
    """Any of it is not 0; of colours, any is opaque."""
    if attribute.data_type == "FLOAT_COLOR":
        return bool((_values(attribute, "color", 4)[:, 3] > 0).any())
    return bool(_values(attribute, "value").any())


def _strokes_of(thing: Any) -> Iterator[Strokes]:
    """Of each layer that is shown, at the current frame, in the world."""
    matrix = np.array(thing.matrix_world)
    scale = abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
    inks = np.array([_ink(slot.material) for slot in thing.material_slots] or [_ink(None)])
    for layer in thing.data.layers:
        frame = None if _is_hidden(layer) else layer.current_frame()
        if frame is None or not len(frame.drawing.strokes):
            continue
        drawing = frame.drawing
        offsets = np.zeros(len(drawing.curve_offsets), np.int32)
        drawing.curve_offsets.foreach_get("value", offsets)
        points = _values(drawing.attributes["position"], "vector", 3)
        opacity = _each(drawing, "opacity", "POINT", 1.0) * layer.opacity
        pens = _each(drawing, "material_index", "CURVE").astype(int)
        colours = inks[np.clip(pens, 0, len(inks) - 1)]
        colours[:, 3] *= np.maximum.reduceat(opacity, offsets[:-1])
        yield (
            points @ matrix[:3, :3].T + matrix[:3, 3],
            2 * scale * _each(drawing, "radius", "POINT", 0.01),
            np.diff(offsets),
            _each(drawing, "cyclic", "CURVE").astype(bool),
            colours,
        )


def _is_hidden(layer: Any) -> bool:
    """It, or a group that it is in."""
    while layer is not None:
        if layer.hide:
            return True
        layer = layer.parent_group
    return False


def _ink(material: Any) -> tuple[float, ...]:
    style = None if material is None else material.grease_pencil
    if style is None:
        return (0.0, 0.0, 0.0, 1.0)
    return (*style.color[:3], 0.0 if style.hide else style.color[3])


def _each(drawing: Any, name: str, domain: str, without: float = 0.0) -> Any:
    """(n,) values of an attribute of points or strokes; `without` for each where there is none."""
    attribute = drawing.attributes.get(name)
    if attribute is None:
        return np.full(drawing.attributes.domain_size(domain), without)
    return _values(attribute, "value")


def _values(attribute: Any, field: str, width: int = 1) -> Any:
    """(n,) or (n, width) values of an attribute."""
    kind = {"BOOLEAN": bool, "INT": np.int32}.get(attribute.data_type, np.float32)
    values = np.zeros(len(attribute.data) * width, kind)
    attribute.data.foreach_get(field, values)
    return values.reshape(-1, width) if width > 1 else values
