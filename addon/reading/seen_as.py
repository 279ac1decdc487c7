"""What a render makes of an object besides showing it, and what materials make of a mesh."""

from dataclasses import replace
from typing import Any

import numpy as np

from .mesh_arrays import MeshArrays

Style = dict[str, Any]
"""Arguments of `illustrate_native.ObjectStyle`; empty: the scene's."""


def seen_as(thing: Any, owner: Any, view_layer: Any) -> Style:
    """Of an instance's object and of the original that shows it, what the visibility says.

    What the camera does not see, itself or by a collection that is indirect only, casts shadows. A
    holdout hides what is behind it. A shadow catcher is its shadows.
    """
    things = (thing.original, owner)
    if owner.indirect_only_get(view_layer=view_layer) or not all(t.visible_camera for t in things):
        casts = all(t.visible_shadow for t in things)
        return {"shadow_only": True} if casts else {"ignore": True}
    if owner.holdout_get(view_layer=view_layer) or any(t.is_holdout for t in things):
        return {"occlude_only": True}
    return {"shadow_catcher": True} if any(t.is_shadow_catcher for t in things) else {}


def with_materials(
    style: Style, geometry: MeshArrays, materials: list[Any]
) -> tuple[Style, MeshArrays]:
    """The style and mesh of an object whose materials have styles of their own.

    Where all of the mesh has one, it is the object's; else the native module tells the faces apart.
    Ignored faces are holes; an object that has no others is ignored.
    """
    own = [
        material.original.illustrate_material
        if material is not None and material.original.illustrate_material.use_own
        else None
        for material in materials
    ]
    if not any(own) or not len(geometry.face_materials):
        return style, geometry
    numbers = np.clip(geometry.face_materials, 0, len(own) - 1)
    ignored = np.isin(numbers, [i for i, each in enumerate(own) if each and each.ignore])
    if ignored.all():
        return {**style, "ignore": True}, geometry
    if ignored.any():
        geometry = replace(geometry, hole_faces=np.flatnonzero(ignored).astype(np.int32))
    told = {i: _told(own[i], i) for i in np.unique(numbers[~ignored]).tolist()}
    first = next(iter(told.values()))
    if all(each == first for each in told.values()):
        return _joined(style, first), geometry
    kept = [told.get(i, _told(None, i)) for i in range(len(own))]
    return {**style, "materials": kept}, geometry


def _told(own: Any, number: int) -> Style:
    """Arguments of `illustrate_native.MaterialStyle` for the material of a number."""
    if own is None:
        return {"lines": True, "hatching": True, "width_scale": 1.0, "spacing_scale": 1.0, "pen": 0}
    return {
        "lines": own.lines,
        "hatching": own.hatching,
        "width_scale": own.width_scale,
        "spacing_scale": own.spacing_scale,
        "pen": number + 1 if own.own_pen else 0,
    }


def _joined(style: Style, told: Style) -> Style:
    """The style of an object within which all has one material's."""
    joined = dict(style)
    for name in ("lines", "hatching"):
        joined[name] = style.get(name, True) and told[name]
    for name in ("width_scale", "spacing_scale"):
        joined[name] = style.get(name, 1.0) * told[name]
    return joined
