"""Drawings into the scene: one interface, one file per writer. Only these write scene data.

A writer is a module with two functions:
    write(scene, groups) -> objects   replaces what it wrote before by `groups` (StrokeGroup, lowest
                                      first) and returns the objects that hold the strokes
    clear(scene)                      takes back what it wrote
Neither touches anything that is not marked as the add-on's own (ownership.py).
"""

from types import ModuleType
from typing import Any

import bpy

from . import curves, grease_pencil_v2, grease_pencil_v3
from .strokes import stroke_groups

WRITERS: dict[str, ModuleType] = {
    "GREASE_PENCIL": grease_pencil_v3 if bpy.app.version >= (4, 3, 0) else grease_pencil_v2,
    "CURVES": curves,
}


def write_drawing(scene: Any, drawing: Any, camera: Any, target: str) -> list[Any]:
    """Puts an `illustrate_native.Drawing` in place of the last one; the objects that hold it.

    camera: the CameraArrays it was made for. target: a key of WRITERS.
    """
    groups = stroke_groups(drawing, camera)
    for name, writer in WRITERS.items():
        if name != target:
            writer.clear(scene)
    objects: list[Any] = WRITERS[target].write(scene, groups)
    return objects
