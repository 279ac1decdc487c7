"""Writes curve objects, one per line kind, for renderers that have no Grease Pencil.

Kind, object, invisibility and number through a sequence of the splines are properties of the curve,
in the splines' order.
"""

import json
from typing import Any

import bpy
import numpy as np

from ..ownership import mark, may_replace
from . import pens
from .strokes import Sheet, StrokeGroup

COLLECTION = "Illustration"
TITLE = "illustrate_title"
KINDS, OBJECTS, INVISIBILITY = "illustrate_kinds", "illustrate_of", "illustrate_invisibility"
STROKE_IDS = "stroke_ids"
NAMES = "illustrate_objects"


def write(scene: Any, sheet: Sheet) -> list[Any]:
    """Fills the add-on's curve objects anew; those without strokes are removed."""
    there = _our_objects(scene)
    objects = []
    for group in sheet.groups:
        thing = there.pop(group.title, None) or _new_object(scene, group)
        _fill(thing.data, group)
        thing.data[NAMES] = json.dumps(sheet.names)
        objects.append(thing)
    _remove(there.values())
    return objects


def clear(scene: Any) -> None:
    """Removes the add-on's curve objects, and their collection when nothing else is in it."""
    _remove(_our_objects(scene).values())
    collection = _our_collection(scene)
    if collection is not None and not collection.all_objects:
        bpy.data.collections.remove(collection)


def has_any(scene: Any) -> bool:
    """True where there are curve objects of the add-on's own."""
    return bool(_our_objects(scene))


def restyle(scene: Any) -> None:
    """Gives the objects and their pens what the settings say now."""
    for thing in _our_objects(scene).values():
        thing.show_in_front = scene.illustrate.in_front
        pens.colour_all(thing.data, scene.illustrate)


def _our_objects(scene: Any) -> dict[str, Any]:
    return {
        thing[TITLE]: thing
        for thing in scene.objects
        if thing.type == "CURVE" and may_replace(thing)
    }


def _our_collection(scene: Any) -> Any:
    mine = (child for child in scene.collection.children_recursive if may_replace(child))
    return next(mine, None)


def _new_object(scene: Any, group: StrokeGroup) -> Any:
    collection = _our_collection(scene)
    if collection is None:
        collection = bpy.data.collections.new(COLLECTION)
        mark(collection)
        scene.collection.children.link(collection)
    name = f"{COLLECTION} {group.title}"
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = 1.0  # a point's radius is the stroke's
    curve.bevel_resolution = 4  # twelve sides: seen from any side as wide within 3.4 %
    curve.use_fill_caps = True
    _ink(scene, curve, group.pen)
    thing = bpy.data.objects.new(name, curve)
    thing.show_in_front = scene.illustrate.in_front
    thing[TITLE] = group.title
    mark(thing, curve)
    collection.objects.link(thing)
    return thing


def _ink(scene: Any, curve: Any, pen: str) -> None:
    """Gives the curve the pen's material, shared with curves that have it already."""
    for other in _our_objects(scene).values():
        index = pens.of_data(other.data).get(pen)
        if index is not None:
            curve.materials.append(other.data.materials[index])
            return
    pens.index_of(curve, pen, scene.illustrate, for_pencil=False)


def _fill(curve: Any, group: StrokeGroup) -> None:
    curve.splines.clear()
    ends = np.cumsum(group.sizes)
    for size, end, closed in zip(
        group.sizes.tolist(), ends.tolist(), group.closed.tolist(), strict=True
    ):
        span = slice(end - size, end)
        spline = curve.splines.new("POLY")
        # A new spline has one point already; the fourth coordinate is a weight, which has to be
        # there.
        spline.points.add(size - 1)
        spline.points.foreach_set("co", np.c_[group.points[span], np.ones(size)].ravel())
        spline.points.foreach_set("radius", group.radii[span])
        spline.use_cyclic_u = closed
    curve[KINDS] = group.kinds.tolist()
    curve[OBJECTS] = group.objects.tolist()
    curve[INVISIBILITY] = group.invisibility.tolist()
    curve[STROKE_IDS] = group.ids.tolist()


def _remove(objects: Any) -> None:
    for thing in list(objects):
        curve, materials = thing.data, list(thing.data.materials)
        bpy.data.objects.remove(thing)
        if not curve.users:
            bpy.data.curves.remove(curve)
        pens.remove_unused(materials)
