"""Writes curve objects, one per line kind, for renderers that have no Grease Pencil."""

from typing import Any

import bpy
import numpy as np

from ..ownership import is_ours, mark
from . import field_overlay
from .strokes import StrokeGroup

COLLECTION = "Illustration"
TITLE = "illustrate_title"


def write(scene: Any, groups: list[StrokeGroup]) -> list[Any]:
    """Fills the add-on's curve objects anew; those without strokes are removed."""
    there = _our_objects(scene)
    objects = []
    for group in groups:
        thing = there.pop(group.title, None) or _new_object(scene, group.title)
        _fill(thing.data, group)
        objects.append(thing)
    _remove(there.values())
    return objects


def clear(scene: Any) -> None:
    """Removes the add-on's curve objects, and their collection when nothing else is in it."""
    _remove(_our_objects(scene).values())
    collection = _our_collection(scene)
    if collection is not None and not collection.all_objects:
        bpy.data.collections.remove(collection)
    ink = _our_ink()
    if ink is not None and not ink.users:
        bpy.data.materials.remove(ink)


def _our_objects(scene: Any) -> dict[str, Any]:
    return {
        thing[TITLE]: thing for thing in scene.objects if thing.type == "CURVE" and is_ours(thing)
    }


def _our_collection(scene: Any) -> Any:
    mine = (child for child in scene.collection.children_recursive if is_ours(child))
    return next(mine, None)


def _new_object(scene: Any, title: str) -> Any:
    collection = _our_collection(scene)
    if collection is None:
        collection = bpy.data.collections.new(COLLECTION)
        mark(collection)
        scene.collection.children.link(collection)
    name = f"{COLLECTION} {title}"
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = 1.0  # a point's radius is the stroke's
    curve.bevel_resolution = 1
    curve.use_fill_caps = True
    curve.materials.append(_ink())
    thing = bpy.data.objects.new(name, curve)
    thing[TITLE] = title
    mark(thing, curve)
    collection.objects.link(thing)
    return thing


def _our_ink() -> Any:
    mine = (
        material
        for material in bpy.data.materials
        if is_ours(material)
        and not material.is_grease_pencil
        and field_overlay.INK not in material
    )
    return next(mine, None)


def _ink() -> Any:
    """The add-on's black material."""
    material = _our_ink()
    if material is None:
        material = bpy.data.materials.new("Illustration Ink")
        mark(material)
        material.diffuse_color = (0.0, 0.0, 0.0, 1.0)
        material.specular_intensity = 0.0
    return material


def _fill(curve: Any, group: StrokeGroup) -> None:
    curve.splines.clear()
    ends = np.cumsum(group.sizes)
    for size, end, closed in zip(
        group.sizes.tolist(), ends.tolist(), group.closed.tolist(), strict=True
    ):
        span = slice(end - size, end)
        spline = curve.splines.new("POLY")
        spline.points.add(size - 1)
        spline.points.foreach_set("co", np.c_[group.points[span], np.ones(size)].ravel())
        spline.points.foreach_set("radius", group.radii[span])
        spline.use_cyclic_u = closed


def _remove(objects: Any) -> None:
    for thing in list(objects):
        curve = thing.data
        bpy.data.objects.remove(thing)
        if not curve.users:
            bpy.data.curves.remove(curve)
