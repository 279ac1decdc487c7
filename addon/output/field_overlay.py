"""Writes the cross field as an object of the scene: crosses on the surfaces, marked singularities.

It is one mesh object, "Illustration Field", that is seen in the viewport and never rendered.
"""

from typing import Any

import bpy
import numpy as np

from ..ownership import is_ours, mark, may_replace

NAME, INK = "Illustration Field", "illustrate_ink"
CELLS = 70  # along the diagonal of everything: one cross in each
ARM = 0.42  # half the length of a cross, in cells
LIFT = 0.06  # of crosses off the surface, in cells
MARK_RADIUS = 0.45  # of a singularity, in cells
INKS = {"Illustration Field Plus": (0.8, 0.05, 0.05, 1.0),
        "Illustration Field Minus": (0.05, 0.2, 0.9, 1.0)}  # fmt: skip
OCTAHEDRON = np.vstack([np.eye(3), -np.eye(3)])
FACES = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]


def find(scene: Any) -> Any:
    """The object that shows the field, or None."""
    mine = (thing for thing in scene.objects if thing.type == "MESH" and may_replace(thing))
    return next(mine, None)


def write(scene: Any, surface: Any, field: Any) -> Any:
    """Shows an `illustrate_native.CrossField` of a surface in place of the last one; the object."""
    mesh = _mesh(surface, field)
    shown = find(scene)
    if shown is None:
        shown = bpy.data.objects.new(NAME, mesh)
        shown.hide_render = True
        scene.collection.objects.link(shown)
    else:
        last, shown.data = shown.data, mesh
        bpy.data.meshes.remove(last)
        mesh.name = NAME
    mark(shown, mesh)
    return shown


def clear(scene: Any) -> None:
    """Removes the object with its mesh and materials."""
    shown = find(scene)
    if shown is None:
        return
    mesh, inks = shown.data, list(shown.data.materials)
    bpy.data.objects.remove(shown)
    if not mesh.users:
        bpy.data.meshes.remove(mesh)
    for ink in inks:
        if ink is not None and is_ours(ink) and not ink.users:
            bpy.data.materials.remove(ink)


def _mesh(surface: Any, field: Any) -> Any:
    positions = np.asarray(surface.positions)
    cell = float(np.linalg.norm(np.ptp(positions, axis=0))) / CELLS
    crosses = _crosses(surface, field, cell)
    count = len(crosses)
    edges = np.arange(count).reshape(-1, 2)
    marks = np.asarray(field.singular_positions)[:, None] + MARK_RADIUS * cell * OCTAHEDRON
    faces = [
        tuple(count + 6 * number + corner for corner in face)
        for number in range(len(marks))
        for face in FACES
    ]
    mesh = bpy.data.meshes.new(NAME)
    mesh.from_pydata(
        np.concatenate([crosses, marks.reshape(-1, 3)]).tolist(), edges.tolist(), faces
    )
    for name, colour in INKS.items():
        mesh.materials.append(_ink(name, colour))
    inks = np.repeat((np.asarray(field.singular_indices) < 0).astype(np.int32), len(FACES))
    mesh.polygons.foreach_set("material_index", inks)
    mesh.update()
    return mesh


def _crosses(surface: Any, field: Any, cell: float) -> Any:
    """(4 m, 3) ends of the two arms of m crosses, one at a vertex of each cell that has some."""
    positions, normals = np.asarray(surface.positions), np.asarray(surface.normals)
    cells = np.floor(positions / max(cell, 1e-300)).astype(np.int64)
    chosen = np.sort(np.unique(cells, axis=0, return_index=True)[1])
    normal, along = normals[chosen], np.asarray(field.directions)[chosen]
    at = positions[chosen] + LIFT * cell * normal
    arms = [ARM * cell * along, ARM * cell * np.cross(normal, along)]
    return np.stack([at + sign * arm for arm in arms for sign in (-1, 1)], axis=1).reshape(-1, 3)


def _ink(name: str, colour: Any) -> Any:
    mine = (ink for ink in bpy.data.materials if is_ours(ink) and ink.get(INK) == name)
    ink = next(mine, None)
    if ink is None:
        ink = bpy.data.materials.new(name)
        ink[INK] = name
        ink.diffuse_color = colour
        mark(ink)
    return ink
