"""Meshes given by formulas, and cameras that look at them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import illustrate_native as ill
import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
Indices = NDArray[np.int32]

SIZE_PX = 256


@dataclass(frozen=True)
class Shape:
    """The arrays of an `ill.PolygonMesh`."""

    positions: Doubles
    face_sizes: Indices
    corner_vertices: Indices

    def mesh(self, **more: Any) -> ill.PolygonMesh:
        return ill.PolygonMesh(self.positions, self.face_sizes, self.corner_vertices, **more)

    def moved(self, offset: tuple[float, float, float]) -> Shape:
        return replace(self, positions=self.positions + offset)


def of_quads(positions: Doubles, quads: Indices) -> Shape:
    return Shape(positions, np.full(len(quads), 4, np.int32), quads.reshape(-1).astype(np.int32))


def grid_quads(rows: int, columns: int, wrap_rows: bool, wrap_columns: bool) -> Indices:
    """Quads of a grid of vertices numbered row by row, joined at its ends where it wraps."""
    row, column = np.meshgrid(
        np.arange(rows if wrap_rows else rows - 1),
        np.arange(columns if wrap_columns else columns - 1),
        indexing="ij",
    )
    down, right = (row + 1) % rows, (column + 1) % columns
    corners = [row * columns + column, row * columns + right, down * columns + right,
               down * columns + column]  # fmt: skip
    return np.stack(corners, axis=-1).reshape(-1, 4)


def cube() -> Shape:
    positions = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return of_quads(positions, np.array(quads))


def sphere(rows: int = 8) -> Shape:
    """The unit sphere, as the grid of a cube pushed outwards."""
    box = cube()
    line = np.linspace(0, 1, rows + 1)
    u, v = (x[..., None] for x in np.meshgrid(line, line, indexing="ij"))
    points = []
    for quad in box.corner_vertices.reshape(-1, 4):
        a, b, c, d = box.positions[quad]
        points.append(((1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * d + v * c)).reshape(-1, 3))
    all_points = np.concatenate(points)
    one_face = grid_quads(rows + 1, rows + 1, False, False)[:, [0, 1, 2, 3]]
    quads = np.concatenate([one_face + k * (rows + 1) ** 2 for k in range(6)])
    _, first, merged = np.unique(np.round(all_points, 9), axis=0, return_index=True,
                                 return_inverse=True)  # fmt: skip
    directions = all_points[first]
    return of_quads(
        directions / np.linalg.norm(directions, axis=1, keepdims=True), merged.reshape(-1)[quads]
    )


def torus(rows: int = 24, columns: int = 12, ring: float = 1.0, tube: float = 0.4) -> Shape:
    u, v = np.meshgrid(2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")  # fmt: skip
    radius = ring + tube * np.cos(v)
    positions = np.stack([radius * np.cos(u), radius * np.sin(u), tube * np.sin(v)], axis=-1)
    return of_quads(positions.reshape(-1, 3), grid_quads(rows, columns, True, True))


def klein_bottle(rows: int = 32, columns: int = 16) -> Shape:
    """The figure-8 immersion: closed, passes through itself, cannot be oriented."""
    u, v = np.meshgrid(2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")  # fmt: skip
    radius = 2 + np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v)
    height = np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v)
    positions = np.stack([radius * np.cos(u), radius * np.sin(u), height], axis=-1)
    quads = grid_quads(rows, columns, False, True)
    # The last row meets the first one turned round: v becomes -v.
    last, first = (rows - 1) * columns + np.arange(columns), (-np.arange(columns)) % columns
    closing = np.stack([last, np.roll(last, -1), np.roll(first, -1), first], axis=-1)
    return of_quads(positions.reshape(-1, 3), np.concatenate([quads, closing]))


def drape(rows: int = 24) -> Shape:
    """A cloth with folds and a boundary."""
    x, y = np.meshgrid(np.linspace(-1, 1, rows), np.linspace(-1, 1, rows), indexing="ij")
    z = 0.35 * np.sin(5 * x + 2 * y) * (1.2 - y) - 0.3 * x * x
    positions = np.stack([x + 0.25 * np.sin(4 * z), y, z], axis=-1)
    return of_quads(positions.reshape(-1, 3), grid_quads(rows, rows, False, False))


def plate(sides: int, wobble: float = 0.0) -> Shape:
    """A prism over a polygon with a pocket of the same shape, in triangles as exporters of CAD
    models make them; the wobble makes some of its corners sharper than others."""
    angle = 2 * np.pi * np.arange(sides) / sides
    radius = 1 + wobble * np.sin(5.0 * np.arange(sides) ** 2)
    outline = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1)
    rings = [(1.0, 0.0), (1.0, 0.4), (0.5, 0.4), (0.5, 0.15)]
    positions = [np.column_stack([size * outline, np.full(sides, z)]) for size, z in rings]
    positions.append(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.15]]))
    k = np.arange(sides)
    after, under, floor = (k + 1) % sides, 0 * k + 4 * sides, 0 * k + 4 * sides + 1
    faces = []
    for ring in range(3):
        low, high = ring * sides, (ring + 1) * sides
        faces.append(np.stack([low + k, low + after, high + after], axis=-1))
        faces.append(np.stack([low + k, high + after, high + k], axis=-1))
    faces.append(np.stack([under, after, k], axis=-1))
    faces.append(np.stack([floor, 3 * sides + k, 3 * sides + after], axis=-1))
    triangles = np.concatenate(faces)
    return Shape(np.concatenate(positions), np.full(len(triangles), 3, np.int32),
                 triangles.reshape(-1).astype(np.int32))  # fmt: skip


def look_at(
    direction: tuple[float, float, float] = (1.0, -2.0, 0.8),
    radius: float = 1.8,
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0),
    perspective: bool = True,
    size_px: int = SIZE_PX,
) -> ill.Camera:
    """A camera that sees a ball of this radius whole, from this direction."""
    back = np.array(direction) / np.linalg.norm(direction)
    right = np.cross([0.0, 0.0, 1.0] if abs(back[2]) < 0.99 else [0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    view = np.eye(4)
    view[:3, :3] = right, np.cross(back, right), back
    distance = 4 * radius
    view[:3, 3] = -view[:3, :3] @ (np.array(centre) + distance * back)
    near, far = distance - 1.5 * radius, distance + 1.5 * radius
    projection = np.zeros((4, 4))
    if perspective:
        projection[0, 0] = projection[1, 1] = 0.95 * np.sqrt(distance**2 - radius**2) / radius
        projection[2, 2:] = (far + near) / (near - far), 2 * far * near / (near - far)
        projection[3, 2] = -1
    else:
        projection[0, 0] = projection[1, 1] = 0.95 / radius
        projection[2, 2:] = 2 / (near - far), (far + near) / (near - far)
        projection[3, 3] = 1
    return ill.Camera(projection, view, size_px, size_px)
