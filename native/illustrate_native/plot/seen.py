"""The triangles of a surface as they lie in the picture: which is seen at a point of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .strokes import Flags, Floats, Indices

NOTHING = -1  # where no triangle is seen
CELL = 8.0  # px, of the squares in which triangles are looked up


@dataclass(frozen=True)
class Seen:
    """Triangles as they lie in the picture."""

    corners: Floats  # (t, 3, 2) px
    nearness: Floats  # (t, 3) greater is nearer, linear in the picture
    objects: Indices  # (t,)
    materials: Indices  # (t,) numbers within an object
    borders: Floats = field(default_factory=lambda: np.zeros((0, 2, 2)))
    """(e, 2, 2) px, where two materials of an object meet, what is hidden of it too."""


def seen_from(
    surface: Any,
    projection: Any,
    view: Any,
    width_px: int,
    height_px: int,
    materials: Indices | None = None,
    see_through: Sequence[int] = (),
) -> Seen:
    """Triangles of a `illustrate_native.Surface` before a camera; (4, 4) as OpenGL has them.

    materials: (t,) number of each triangle's material within its object; all one where left out.
    see_through: objects that are not seen, but what is behind them.
    """
    positions, triangles = np.asarray(surface.positions), np.asarray(surface.triangles)
    objects = np.asarray(surface.objects)[triangles[:, 0]].astype(np.intp)
    painted = np.zeros(len(triangles), np.intp) if materials is None else np.asarray(materials)
    clip = np.c_[positions, np.ones(len(positions))] @ (np.asarray(projection) @ view).T
    is_before = clip[:, 3] > 0
    w = np.where(is_before, clip[:, 3], 1.0)
    image = (clip[:, :2] / w[:, None] * (1, -1) + 1) / 2 * (width_px, height_px)
    kept = is_before[triangles].all(axis=1) & ~np.isin(objects, list(see_through))
    triangles, objects, painted = triangles[kept], objects[kept], painted[kept]
    borders = _borders(positions, triangles, objects, painted)
    nearness = -(clip[:, 2] / w)[triangles]
    return Seen(image[triangles], nearness, objects, painted, image[borders])


def _borders(positions: Floats, triangles: Indices, objects: Indices, materials: Indices) -> Any:
    """(e, 2) vertices of edges that two materials of an object share."""
    several = _has_several(objects, materials)[objects]
    faces, painted = triangles[several], materials[several]
    _, place = np.unique(positions[faces.ravel()], axis=0, return_inverse=True)
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    places = place.reshape(faces.shape)
    keys = np.stack([places, np.roll(places, -1, axis=1)], axis=2).reshape(-1, 2)
    keys = np.c_[np.repeat(objects[several], 3), np.sort(keys, axis=1), np.repeat(painted, 3)]
    order = np.lexsort(keys.T[::-1])
    keys = keys[order]
    is_border = (keys[1:, :3] == keys[:-1, :3]).all(axis=1) & (keys[1:, 3] != keys[:-1, 3])
    return ends[order[1:][is_border]]


def _has_several(objects: Indices, materials: Indices) -> Flags:
    """Of each object, whether its triangles have more than one material."""
    count = int(objects.max(initial=-1)) + 1
    pairs = np.unique(np.c_[objects, materials], axis=0)
    return np.asarray(np.bincount(pairs[:, 0], minlength=count) > 1)


def triangles_at(points: Floats, seen: Seen) -> Indices:
    """(n,) the nearest triangle at each point of the picture, or NOTHING."""
    found = np.full(len(points), NOTHING, np.intp)
    point, triangle = _candidates(points, seen.corners)
    a, b, c = (seen.corners[triangle, i] for i in range(3))
    p = points[point]
    shares = np.stack([_cross(b - p, c - p), _cross(c - p, a - p), _cross(a - p, b - p)], axis=1)
    whole = shares.sum(axis=1)
    inside = (whole != 0) & ((shares >= 0).all(axis=1) | (shares <= 0).all(axis=1))
    point, triangle, shares, whole = (v[inside] for v in (point, triangle, shares, whole))
    near = (shares * seen.nearness[triangle]).sum(axis=1) / whole
    order = np.lexsort((near, point))  # the last of each point is its nearest
    found[point[order]] = triangle[order]
    return found


def _candidates(points: Floats, corners: Floats) -> tuple[Indices, Indices]:
    """Pairs of points and triangles that touch the same squares."""
    if not len(points):
        return np.zeros(0, np.intp), np.zeros(0, np.intp)
    cells = np.floor(points / CELL).astype(np.intp)
    low, high = cells.min(axis=0), cells.max(axis=0)
    first = np.clip(np.floor(corners.min(axis=1) / CELL), low, high + 1).astype(np.intp)
    last = np.clip(np.floor(corners.max(axis=1) / CELL), low - 1, high).astype(np.intp)
    size = np.maximum(last - first + 1, 0)
    count = size.prod(axis=1)
    triangle = np.repeat(np.arange(len(corners)), count)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    columns = np.maximum(size[triangle, 0], 1)
    wide = int(high[0] - low[0]) + 1
    square = (first[triangle, 1] + within // columns - low[1]) * wide
    square += first[triangle, 0] + within % columns - low[0]
    key = (cells[:, 1] - low[1]) * wide + cells[:, 0] - low[0]
    order = np.argsort(key, kind="stable")
    begin, end = (np.searchsorted(key[order], square, side) for side in ("left", "right"))
    times = end - begin
    place = np.arange(times.sum()) - np.repeat(np.cumsum(times) - times, times)
    return order[np.repeat(begin, times) + place], np.repeat(triangle, times)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
