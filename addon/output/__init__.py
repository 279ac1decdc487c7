"""Drawings into the scene: one interface, one file per writer. Only these write scene data.

They touch nothing that is not marked as the add-on's own (ownership.py). What the versions of
Grease Pencil have in common is in pencil.py, the rest in one file for each.
"""

from collections.abc import Sequence
from typing import Any

import bpy

from ..messages import IllustrateError, quoted, said
from . import curves, fills, grease_pencil_v2, grease_pencil_v3, pencil
from .strokes import Sheet, stroke_groups

# By the version: 4.2 is an extension with version 2, and bpy.data.grease_pencils is there in all
# Blenders, for other data from one to the next.
PENCIL_API = grease_pencil_v3 if bpy.app.version >= (4, 3, 0) else grease_pencil_v2
TARGETS = ("GREASE_PENCIL", "CURVES")


def sheet_of(
    drawing: Any,
    camera: Any,
    frame: int,
    names: list[str] | None = None,
    areas: Sequence[Any] = (),
) -> Sheet:
    """An `illustrate_native.Drawing` as the writers take it.

    camera: the CameraArrays it was made for. names: of the meshes; numbers where left out. areas:
    Areas (plot/areas.py) to be filled below it; curves have none.
    """
    if names is None:
        names = [str(i) for i in range(int(max(drawing.objects, default=-1)) + 1)]
    filled = fills.group_of(list(areas), drawing, camera)
    lowest = [] if filled is None else [filled]
    return Sheet(frame, [*lowest, *stroke_groups(drawing, camera)], list(names))


def write_drawing(
    scene: Any,
    drawing: Any,
    camera: Any,
    target: str,
    names: list[str] | None = None,
    areas: Sequence[Any] = (),
    frame: int | None = None,
) -> list[Any]:
    """Puts a drawing in place of the last one at a frame; the objects that hold it.

    target: one of TARGETS. frame: the scene's where left out. The others are as in `sheet_of`.
    """
    shown = areas if target == "GREASE_PENCIL" else ()
    frame = scene.frame_current if frame is None else frame
    sheet = sheet_of(drawing, camera, frame, names, shown)
    if target == "CURVES":
        pencil.clear(PENCIL_API, scene)
        return curves.write(scene, sheet)
    curves.clear(scene)
    return pencil.write(PENCIL_API, scene, sheet)


def bake_drawings(scene: Any, sheets: list[Sheet]) -> list[str]:
    """Writes sheets, in the order of their frames, as keyframes; warnings.

    Frames with strokes of the artist's are left as they are.
    """
    left = pencil.bake(PENCIL_API, scene, sheets)
    if not left:
        return []
    return [said("Left as drawn by hand: {names}", names=quoted(left))]


def check_can_bake(target: str) -> None:
    """Raises IllustrateError for outputs that have no keyframes."""
    if target == "CURVES":
        raise IllustrateError(
            said(
                "Curves hold one drawing, not one for each frame: set Output to Grease Pencil to "
                "bake"
            )
        )


def clear(scene: Any) -> None:
    """Removes all that the add-on wrote, and nothing else."""
    pencil.clear(PENCIL_API, scene)
    curves.clear(scene)


def has_illustration(scene: Any) -> bool:
    """True where `clear` would remove something."""
    return pencil.find(scene, PENCIL_API) is not None or curves.has_any(scene)


def restyle(scene: Any) -> None:
    """Gives what is there already the colours and the place in front that the settings say."""
    pencil.restyle(PENCIL_API, scene)
    curves.restyle(scene)
