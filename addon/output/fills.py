"""Areas as Grease Pencil fills: closed strokes that are filled and have no line.

Grease Pencil fills each stroke by itself, so holes are cut open to the outer ring. The fills lie in
a plane across the view, as far as the farthest stroke, on a layer below those of the lines.
"""

from typing import Any

import bpy
import numpy as np

from .. import native
from ..ownership import is_ours, mark
from .strokes import StrokeGroup

TITLE = "Fill"
KIND = 1000  # kept with a fill where strokes have the number of their kind of line
FILL, TOLD = "illustrate_fill", "illustrate_fill_colour"
"""What a material stands for, and the colour that it was given last."""


def group_of(areas: list[Any], drawing: Any, camera: Any) -> StrokeGroup | None:
    """The lowest layer, of Areas in pixels (plot/areas.py); None where there are none."""
    cut_open = native.load_part("plot").cut_open
    pairs = [(area, polygon) for area in areas for polygon in area.region.polygons]
    if not pairs:
        return None
    rings = [cut_open(polygon) for _, polygon in pairs]
    points = _in_the_world(np.concatenate(rings), drawing, camera)
    count = len(rings)
    return StrokeGroup(
        TITLE,
        TITLE,
        points.astype(np.float32),
        np.zeros(len(points), np.float32),
        np.array([len(ring) for ring in rings], np.int32),
        np.ones(count, bool),
        np.full(count, KIND, np.int32),
        np.array([area.region.object for area, _ in pairs], np.int32),
        np.zeros(count, np.int32),
        np.full(count, -1, np.int32),
        np.zeros(count, np.float32),
        tuple((area.ink, area.colour) for area, _ in pairs),
    )


def _in_the_world(image: Any, drawing: Any, camera: Any) -> Any:
    """Places (p, 3) of points of the picture, as far from the camera as the farthest stroke."""
    matrix = camera.projection @ camera.view
    strokes = np.asarray(drawing.points, float).reshape(-1, 3)
    clip = np.c_[strokes, np.ones(len(strokes))] @ matrix.T
    depth = float((clip[:, 2] / clip[:, 3]).max()) if len(clip) else 0.0
    x, y = (2 * image / (camera.width_px, camera.height_px) - 1).T
    found = np.c_[x, -y, np.full(len(x), depth), np.ones(len(x))] @ np.linalg.inv(matrix).T
    return found[:, :3] / found[:, 3:]


def of_data(data: Any) -> dict[str, int]:
    """The add-on's fills among the materials of an object's data: their indices."""
    return {
        material[FILL]: index
        for index, material in enumerate(data.materials)
        if material is not None and is_ours(material) and FILL in material
    }


def indices_of(data: Any, inks: tuple[tuple[str, tuple[float, ...]], ...]) -> Any:
    """(s,) indices of the materials of fills in the data; they are made where they are missing.

    What the artist makes of a colour stays until that of the object's material changes.
    """
    there = of_data(data)
    for ink, colour in dict(inks).items():
        if ink not in there:
            data.materials.append(_new(ink))
            there[ink] = len(data.materials) - 1
        _colour(data.materials[there[ink]], colour)
    return np.array([there[ink] for ink, _ in inks], np.int32)


def _new(ink: str) -> Any:
    material = bpy.data.materials.new(f"Illustration Fill {ink}")
    mark(material)
    material[FILL] = ink
    bpy.data.materials.create_gpencil_data(material)
    material.grease_pencil.show_stroke = False
    material.grease_pencil.show_fill = True
    return material


def _colour(material: Any, colour: tuple[float, ...]) -> None:
    told = np.asarray((*colour, 1.0)[:4], np.float32)
    if TOLD not in material or not np.array_equal(np.asarray(material[TOLD], np.float32), told):
        material.grease_pencil.fill_color = told.tolist()
        material[TOLD] = told.tolist()
