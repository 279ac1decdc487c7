"""Styles of objects, collections and materials: how some of a scene is drawn unlike the rest.

An object's own style counts for it, else that of the innermost collection that has one.
"""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

import math
from dataclasses import dataclass
from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, PointerProperty

FORMS = [
    ("AUTO", "Automatic", "A cage where a Subdivision modifier ends the stack, else a mesh", 0),
    ("CAGE", "Cage", "It controls a smooth surface, as below a Subdivision modifier", 1),
    ("MESH", "Mesh", "It is the surface itself, with hard edges where it is shaded so", 2),
]
LEAST_TURN_DEG = 0.1  # triangles of a flat face turn less in files, whose coordinates are rounded
OWN_SCHEMES = [
    ("SCENE", "As the Scene", "As the settings of the scene say", 0),
    ("auto", "Automatic", "Catmull-Clark for meshes of quads, Loop for others", 1),
    ("catmull-clark", "Catmull-Clark", "The surface of Blender's Subdivision modifier", 2),
    ("loop", "Loop", "The surface of triangle meshes", 3),
    ("none", "None", "Draw the faces as they are", 4),
]


def _ignore(what: str) -> Any:
    return BoolProperty(
        name="Ignore",
        default=False,
        description=f"Leave {what} out entirely: neither drawn nor in front of anything",
    )


def _use_own(what: str) -> Any:
    return BoolProperty(
        name="Own Style",
        default=False,
        description=f"Draw {what} unlike the rest of the scene",
    )


OPTIONS: dict[str, Any] = {
    "ignore": _ignore("it"),
    "occlude_only": BoolProperty(
        name="Occluder",
        default=False,
        description="Hide what is behind it, but do not draw it",
    ),
    "see_through": BoolProperty(
        name="See Through",
        default=False,
        description="Hide nothing behind it and hatch it not, as glass; objects whose materials "
        "are all transparent are drawn so too",
    ),
    "lines": BoolProperty(name="Lines", default=True, description="Draw its lines"),
    "hatching": BoolProperty(name="Hatching", default=True, description="Hatch it"),
    "loose_edges": BoolProperty(
        name="Loose Edges",
        default=False,
        description="Draw its edges that belong to no face, also where the scene's are not drawn",
    ),
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


def crease_angle(description: str) -> Any:
    """The property of an angle beyond which flat-shaded faces meet in a hard edge."""
    return FloatProperty(
        name="Crease Angle",
        default=math.radians(30),
        min=0.0,
        max=math.radians(180),
        subtype="ANGLE",
        description=f"{description}, degrees. 0: every edge that turns is hard, 180: none is",
    )


SURFACE: dict[str, Any] = {
    "form": EnumProperty(
        name="Form",
        items=FORMS,
        default="AUTO",
        description="Whether the mesh is the surface or a cage, the control mesh of a smooth one",
    ),
    "scheme": EnumProperty(
        name="Subdivision",
        items=OWN_SCHEMES,
        default="SCENE",
        description="How the mesh is refined where no Subdivision modifier says it",
    ),
    "use_crease_angle": BoolProperty(
        name="Own Crease Angle",
        default=False,
        description="Where it is shaded flat, edges are hard beyond an angle of its own",
    ),
    "crease_angle": crease_angle("Its flat-shaded faces that turn more make a hard edge"),
}
"""What surfaces the meshes stand for."""


@dataclass(frozen=True)
class Surface:
    """What surface a mesh stands for."""

    form: str = "AUTO"  # of FORMS
    scheme: str | None = None  # of `illustrate_native.PolygonMesh`
    crease_angle_deg: float = 30.0  # between faces that are shaded flat


class ILLUSTRATE_PG_style(bpy.types.PropertyGroup):
    """How one object or the objects of one collection are drawn."""

    __annotations__ = {
        "use_own": _use_own("this"),
        **OPTIONS,
        **SURFACE,
    }


class ILLUSTRATE_PG_light(bpy.types.PropertyGroup):
    """What is drawn of one light."""

    __annotations__ = {
        "contours": BoolProperty(
            name="Contours",
            default=True,
            description="Draw its terminators and shadow outlines, where the scene's settings ask "
            "for such lines",
        ),
    }


class ILLUSTRATE_PG_material_style(bpy.types.PropertyGroup):
    """How faces of one material are drawn, within what the style of their object allows."""

    __annotations__ = {
        "use_own": _use_own("faces of this material"),
        "ignore": _ignore("its faces"),
        **{name: OPTIONS[name] for name in ("lines", "hatching", "width_scale", "spacing_scale")},
        "own_pen": BoolProperty(
            name="Own Pen",
            default=False,
            description="Its strokes end at its borders, where those of other materials begin, so "
            "that a pen of a plot can draw them",
        ),
    }


def style_of(thing: Any, scene: Any) -> dict[str, Any]:
    """Arguments of `illustrate_native.ObjectStyle` for an object; empty: the scene's own style."""
    style = _own_style(thing, scene)
    return {name: getattr(style, name) for name in OPTIONS} if style is not None else {}


def surface_of(thing: Any, scene: Any) -> Surface:
    """What surface the mesh of an object stands for, by its own style or the scene's settings."""
    style, general = _own_style(thing, scene), scene.illustrate
    if style is None:
        return Surface(crease_angle_deg=_degrees(general.crease_angle))
    angle = style.crease_angle if style.use_crease_angle else general.crease_angle
    scheme = None if style.scheme == "SCENE" else style.scheme
    return Surface(style.form, scheme, _degrees(angle))


def _degrees(angle: float) -> float:
    """The number that was typed, or what tells an edge from one amid a flat face."""
    return max(round(math.degrees(angle), 4), LEAST_TURN_DEG)


def _own_style(thing: Any, scene: Any) -> Any:
    """That of the object, else of its innermost collection that has one, else None."""
    owners = (thing, *_collections(thing, scene))
    return next((owner.illustrate for owner in owners if owner.illustrate.use_own), None)


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
    """Puts a style on every object and collection, as `illustrate`, on materials and lights."""
    bpy.utils.register_class(ILLUSTRATE_PG_style)
    bpy.utils.register_class(ILLUSTRATE_PG_material_style)
    bpy.utils.register_class(ILLUSTRATE_PG_light)
    bpy.types.Material.illustrate_material = PointerProperty(type=ILLUSTRATE_PG_material_style)
    bpy.types.Light.illustrate = PointerProperty(type=ILLUSTRATE_PG_light)
    for owner in (bpy.types.Object, bpy.types.Collection):
        owner.illustrate = PointerProperty(type=ILLUSTRATE_PG_style)


def unregister() -> None:
    """Takes the styles away again."""
    del bpy.types.Light.illustrate
    del bpy.types.Material.illustrate_material
    bpy.utils.unregister_class(ILLUSTRATE_PG_light)
    bpy.utils.unregister_class(ILLUSTRATE_PG_material_style)
    for owner in (bpy.types.Object, bpy.types.Collection):
        del owner.illustrate
    bpy.utils.unregister_class(ILLUSTRATE_PG_style)
