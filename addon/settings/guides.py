"""What objects say as guides: how strongly a stroke leads, how hatches turn round an empty."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import FloatProperty, IntProperty, PointerProperty

STROKES = ("CURVE", "CURVES", "GPENCIL", "GREASEPENCIL")
"""Types of objects whose strokes hatches follow."""


class ILLUSTRATE_PG_guide(bpy.types.PropertyGroup):
    """Of an object in the collection of guides."""

    weight: FloatProperty(
        name="Weight",
        default=1.0,
        min=0.0,
        soft_max=10.0,
        description="Hatches follow its strokes so many times as closely as the scene says",
    )
    turns: IntProperty(
        name="Turns",
        default=1,
        min=-8,
        max=8,
        description="By how many right angles hatches turn on a way round it, backwards where it "
        "is negative. Where a part of the surface has such empties, hatches turn nowhere else; "
        "on a closed part they must sum to 8, less 8 for each hole through it",
    )


def shown_of(thing: Any) -> str:
    """The property that counts for an object; empty: none does."""
    if thing.type in STROKES:
        return "weight"
    return "turns" if thing.type == "EMPTY" else ""


def is_guide(thing: Any, scene: Any) -> bool:
    """True for objects of the scene's collection of guides that are read."""
    guides = scene.illustrate.guides
    return guides is not None and thing.name in guides.all_objects and bool(shown_of(thing))


def register() -> None:
    """Puts the properties on every object, as `illustrate_guide`."""
    bpy.utils.register_class(ILLUSTRATE_PG_guide)
    bpy.types.Object.illustrate_guide = PointerProperty(type=ILLUSTRATE_PG_guide)


def unregister() -> None:
    """Takes them away again."""
    del bpy.types.Object.illustrate_guide
    bpy.utils.unregister_class(ILLUSTRATE_PG_guide)
