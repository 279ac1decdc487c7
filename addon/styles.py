"""Styles of objects and collections: how some of a scene is drawn unlike the rest.

An object's own style counts for it, else that of the innermost collection that has one.
"""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import BoolProperty, FloatProperty, PointerProperty

OPTIONS: dict[str, Any] = {
    "ignore": BoolProperty(
        name="Ignore",
        default=False,
        description="Leave it out entirely: neither drawn nor in front of anything",
    ),
    "occlude_only": BoolProperty(
        name="Occluder",
        default=False,
        description="Hide what is behind it, but do not draw it",
    ),
    "lines": BoolProperty(name="Lines", default=True, description="Draw its lines"),
    "hatching": BoolProperty(name="Hatching", default=True, description="Hatch it"),
    "spacing_scale": FloatProperty(
        name="Spacing",
        default=1.0,
        min=0.01,
        max=100.0,
        soft_min=0.1,
        soft_max=10.0,
        description="Its hatches are so many times as far apart as those of the scene",
    ),
    "width_scale": FloatProperty(
        name="Width",
        default=1.0,
        min=0.0,
        max=100.0,
        soft_max=10.0,
        description="Its strokes are so many times as wide as those of the scene",
    ),
}
"""The options of `illustrate_native.ObjectStyle`, by their names."""


class ILLUSTRATE_PG_style(bpy.types.PropertyGroup):
    """How one object or the objects of one collection are drawn."""

    __annotations__ = {
        "use_own": BoolProperty(
            name="Own Style",
            default=False,
            description="Draw this unlike the rest of the scene",
        ),
        **OPTIONS,
    }


def style_of(thing: Any, scene: Any) -> dict[str, Any]:
    """Arguments of `illustrate_native.ObjectStyle` for an object; empty: the scene's own style."""
    owner = next((o for o in (thing, *_collections(thing, scene)) if o.illustrate.use_own), None)
    if owner is None:
        return {}
    return {name: getattr(owner.illustrate, name) for name in OPTIONS}


def _collections(thing: Any, scene: Any) -> list[Any]:
    """The scene's collections that hold the object, innermost first."""
    found: list[tuple[int, Any]] = []

    def visit(collection: Any, depth: int) -> bool:
        inside = thing.name in collection.objects
        for child in collection.children:
            inside |= visit(child, depth + 1)
        if inside:
            found.append((-depth, collection))
        return bool(inside)

    visit(scene.collection, 0)
    return [collection for _, collection in sorted(found, key=lambda entry: entry[0])]


def register() -> None:
    """Puts a style on every object and collection, as `illustrate`."""
    bpy.utils.register_class(ILLUSTRATE_PG_style)
    for owner in (bpy.types.Object, bpy.types.Collection):
        owner.illustrate = PointerProperty(type=ILLUSTRATE_PG_style)


def unregister() -> None:
    """Takes the styles away again."""
    for owner in (bpy.types.Object, bpy.types.Collection):
        del owner.illustrate
    bpy.utils.unregister_class(ILLUSTRATE_PG_style)
