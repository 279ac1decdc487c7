"""Closed areas of a drawing: what is seen of each object, bounded by the drawn lines.

The visible arcs of the labelled graph, cut where they meet and by the frame, divide the picture
into faces. An inner point of each says which object is seen there; faces of one object are one
region. Neighbours share the very same points. shapely cuts and joins; it is an optional library.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .libraries import load
from .pages import Box, Placing
from .strokes import Floats, Indices

NOTHING = -1  # where no object is seen
GRID = 1e-3  # px that places of cuts are rounded to, so that neighbours agree
CELL = 8.0  # px, of the squares in which triangles are looked up


class GraphArrays(Protocol):
    """What is taken of `illustrate_native.Graph`."""

    @property
    def arc_invisibility(self) -> NDArray[np.int32]:
        """(a,) layers in front."""

    @property
    def arc_nodes(self) -> NDArray[np.int32]:
        """(a, 2) -1 for loops."""

    @property
    def arc_offsets(self) -> NDArray[np.int32]:
        """(a + 1,)."""

    @property
    def arc_image(self) -> NDArray[np.float64]:
        """(q, 2) px."""


@dataclass(frozen=True)
class Seen:
    """Triangles as they lie in the picture."""

    corners: Floats  # (t, 3, 2) px
    nearness: Floats  # (t, 3) greater is nearer, linear in the picture
    objects: Indices  # (t,)


@dataclass(frozen=True)
class Region:
    """What is seen of an object: polygons, each an outer ring and its holes."""

    object: int
    polygons: tuple[tuple[Floats, ...], ...]  # rings (n, 2), px or mm, not closed
    name: str = ""
    colour: str = "#cccccc"

    @property
    def area(self) -> float:
        """Without holes."""
        return float(sum(_area(o) - sum(map(_area, holes)) for o, *holes in self.polygons))


def seen_from(surface: Any, projection: Any, view: Any, width_px: int, height_px: int) -> Seen:
    """Triangles of a `illustrate_native.Surface` before a camera; (4, 4) as OpenGL has them."""
    positions = np.asarray(surface.positions)
    clip = np.c_[positions, np.ones(len(positions))] @ (np.asarray(projection) @ view).T
    triangles = np.asarray(surface.triangles)
    triangles = triangles[(clip[triangles, 3] > 0).all(axis=1)]
    w = np.where(clip[:, 3] > 0, clip[:, 3], 1.0)
    image = (clip[:, :2] / w[:, None] * (1, -1) + 1) / 2 * (width_px, height_px)
    objects = np.asarray(surface.objects)[triangles[:, 0]].astype(np.intp)
    return Seen(image[triangles], -(clip[:, 2] / w)[triangles], objects)


def objects_at(points: Floats, seen: Seen) -> Indices:
    """(n,) the object of the nearest triangle at each point of the picture, or NOTHING."""
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
    found[point[order]] = seen.objects[triangle[order]]
    return found


def _candidates(points: Floats, corners: Floats) -> tuple[Indices, Indices]:
    """Pairs of points and triangles that touch the same squares."""
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


def regions_of(graph: GraphArrays, seen: Seen, width_px: int, height_px: int) -> list[Region]:
    """What is seen of each object within the frame, by object. Raises PlotError without shapely."""
    shapely = load("shapely", "Filling regions")
    frame = shapely.box(0.0, 0.0, float(width_px), float(height_px))
    lines = shapely.union_all([*_visible_lines(shapely, graph), frame.exterior], grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(lines)))
    faces = faces[shapely.covers(frame, shapely.point_on_surface(faces))]
    inner = shapely.get_coordinates(shapely.point_on_surface(faces))
    shown = objects_at(inner, seen)
    return [
        Region(int(number), _polygons(shapely, shapely.union_all(faces[shown == number])))
        for number in np.unique(shown[shown != NOTHING])
    ]


def _visible_lines(shapely: Any, graph: GraphArrays) -> list[Any]:
    offsets, image = np.asarray(graph.arc_offsets), np.asarray(graph.arc_image)
    nodes = np.asarray(graph.arc_nodes)
    lines = []
    for arc in np.flatnonzero(np.asarray(graph.arc_invisibility) == 0):
        points = image[offsets[arc] : offsets[arc + 1]]
        if nodes[arc, 0] < 0:
            points = np.vstack([points, points[:1]])
        if len(points) > 1:
            lines.append(shapely.linestrings(points))
    return lines


def _polygons(shapely: Any, area: Any) -> tuple[tuple[Floats, ...], ...]:
    """Rings of the polygons of an area."""
    parts = shapely.get_parts(area)
    polygons = [part for part in parts if part.geom_type == "Polygon" and not part.is_empty]
    return tuple(
        tuple(shapely.get_coordinates(ring)[:-1] for ring in shapely.get_rings(polygon))
        for polygon in polygons
    )


def placed_regions(regions: Sequence[Region], placing: Placing, box: Box) -> tuple[Region, ...]:
    """Regions in pixels as regions in millimetres, without what is outside of the box."""
    if not regions:
        return ()
    shapely = load("shapely", "Filling regions")
    printed, found = shapely.box(*box), []
    for region in regions:
        polygons = [
            shapely.polygons(outer, list(holes) or None)
            for outer, *holes in (
                [ring * placing.scale + placing.shift_mm for ring in rings]
                for rings in region.polygons
            )
        ]
        inside = _polygons(shapely, shapely.intersection(shapely.union_all(polygons), printed))
        if inside:
            found.append(replace(region, polygons=inside))
    return tuple(found)


def _area(ring: Floats) -> float:
    return float(abs(_cross(ring, np.roll(ring, -1, axis=0)).sum()) / 2)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
