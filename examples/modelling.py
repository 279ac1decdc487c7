"""Meshes of made things: what is turned on a lathe, bent from tube, cut from plate or boxed.

Positions (n, 3) and faces, as `formulas` has them. The axis of what is turned is z.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from formulas import grid_quads

Mesh = tuple[Any, Any]


def turned(profile: Sequence[tuple[float, float]], columns: int = 48) -> Mesh:
    """A profile of (radius, height), turned round the z axis; what has no radius is one point."""
    radii, heights = np.array(profile, float).T
    rho, angle = np.meshgrid(radii, 2 * np.pi * np.arange(columns) / columns, indexing="ij")
    z = np.broadcast_to(heights[:, None], rho.shape)
    positions = np.stack([rho * np.cos(angle), rho * np.sin(angle), z], axis=-1)
    index = np.arange(rho.size).reshape(rho.shape)
    index[radii == 0] = index[radii == 0, :1]
    used, index = np.unique(index, return_inverse=True)
    index = np.pad(index.reshape(rho.shape), ((0, 0), (0, 1)), mode="wrap")
    faces = [without_repeats(face) for face in grid_quads(index)[:, ::-1].tolist()]
    return positions.reshape(-1, 3)[used], faces


def without_repeats(face: list[int]) -> list[int]:
    """A face without the corners that are the same as those before them."""
    return [corner for i, corner in enumerate(face) if corner != face[i - 1]]


def tube(path: Any, radius: Any, columns: int = 16, closed: bool = False) -> Mesh:
    """A tube along points (n, 3), as thick as `radius` says, one for all or one for each point.

    The rings are carried along the path without turning about it; a closed path gets the turn that
    is left over shared out.
    """
    path = np.asarray(path, float)
    ahead = np.roll(path, -1, 0) - np.roll(path, 1, 0)
    if not closed:
        ahead[[0, -1]] = path[[1, -1]] - path[[0, -2]]
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    sides = _carried(ahead)
    ups = np.cross(ahead, sides)
    turn = _left_over(ahead, sides, ups) if closed else 0.0
    angle = 2 * np.pi * np.arange(columns) / columns
    angle = angle + turn * np.arange(len(path))[:, None] / len(path)
    thick = np.broadcast_to(np.asarray(radius, float), len(path))[:, None, None]
    ring = np.cos(angle)[..., None] * sides[:, None] + np.sin(angle)[..., None] * ups[:, None]
    index = np.arange(angle.size).reshape(angle.shape)
    index = np.pad(index, ((0, int(closed)), (0, 1)), mode="wrap")
    return (path[:, None] + thick * ring).reshape(-1, 3), grid_quads(index)[:, ::-1]


def _carried(ahead: Any) -> Any:
    """A direction across each of `ahead`, each the one before it carried along."""
    side = np.cross(ahead[0], np.eye(3)[np.argmin(np.abs(ahead[0]))])
    sides = []
    for direction in ahead:
        side = side - direction * (side @ direction)
        side = side / np.linalg.norm(side)
        sides.append(side)
    return np.array(sides)


def _left_over(ahead: Any, sides: Any, ups: Any) -> float:
    """By what angle the last ring, carried once more, would miss the first."""
    last = sides[-1] - ahead[0] * (sides[-1] @ ahead[0])
    return float(-np.arctan2(last @ ups[0], last @ sides[0]))


def plate(outline: Any, thickness: float) -> Mesh:
    """An outline (n, 2) in the x-y plane, cut from plate: flat faces with many corners."""
    outline = np.asarray(outline, float)
    count = len(outline)
    low = np.column_stack([outline, np.zeros(count)])
    here = np.arange(count)
    sides = np.stack([here, np.roll(here, -1), np.roll(here, -1) + count, here + count], axis=-1)
    faces = [here[::-1].tolist(), (here + count).tolist(), *sides.tolist()]
    return np.concatenate([low, low + np.array((0, 0, thickness))]), faces


def gear(teeth: int, radius: float, depth: float) -> Any:
    """The outline (n, 2) of a gear whose teeth reach `depth` beyond and below the radius."""
    steps = np.array([-0.30, -0.17, 0.17, 0.30])
    reach = np.array([-depth, depth, depth, -depth])
    angle = (2 * np.pi / teeth * (np.arange(teeth)[:, None] + steps)).ravel()
    rho = radius + np.tile(reach, teeth)
    return np.column_stack([rho * np.cos(angle), rho * np.sin(angle)])


def box(size: Sequence[float], centre: Sequence[float] = (0, 0, 0)) -> Mesh:
    """A box with flat faces."""
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float) / 2
    positions, faces = plate(corners * (size[0], size[1]), size[2])
    return positions + np.array(centre, float) - (0, 0, size[2] / 2), faces


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """Several meshes as one."""
    positions, faces, start = [], [], 0
    for points, polygons in meshes:
        positions.append(np.asarray(points, float))
        faces += [[int(corner) + start for corner in polygon] for polygon in polygons]
        start += len(points)
    return np.concatenate(positions), faces


def turned_to(mesh: Mesh, axis: str, centre: Sequence[float] = (0, 0, 0)) -> Mesh:
    """What was made along z, along 'x' or 'y' instead, its origin moved to the centre."""
    order = {"x": [2, 0, 1], "y": [1, 2, 0], "z": [0, 1, 2]}[axis]
    return np.asarray(mesh[0], float)[:, order] + np.array(centre, float), mesh[1]


def blocks(cells: Sequence[tuple[int, int, int]]) -> Mesh:
    """What bounds a heap of unit cubes, each given by its lowest corner."""
    heap, faces = set(cells), []
    numbers: dict[tuple[int, ...], int] = {}
    for cell in sorted(heap):
        for axis, beyond in ((axis, beyond) for axis in range(3) for beyond in (0, 1)):
            neighbour = list(cell)
            neighbour[axis] += 2 * beyond - 1
            if tuple(neighbour) in heap:
                continue
            ring = ((0, 0), (1, 0), (1, 1), (0, 1)) if beyond else ((0, 0), (0, 1), (1, 1), (1, 0))
            face = []
            for steps in ring:
                corner = list(cell)
                corner[axis] += beyond
                for other, step in zip((axis + 1, axis + 2), steps, strict=True):
                    corner[other % 3] += step
                face.append(numbers.setdefault(tuple(corner), len(numbers)))
            faces.append(face)
    return np.array(list(numbers), float), faces
