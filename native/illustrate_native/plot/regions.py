"""Closed areas of a drawing: what is seen of each object and material, bounded by the drawn lines.

The visible arcs of the labelled graph and the borders of materials, cut where they meet and by the
frame, divide the picture into faces. An inner point of each says what is seen there; faces of one
object and material are one region. Neighbours share the very same points. shapely cuts and joins;
it is an optional library.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .libraries import load
from .pages import Box, Placing
from .seen import NOTHING, Seen, triangles_at
from .strokes import Floats

GRID = 1e-3  # px that places of cuts are rounded to, so that neighbours agree
PURPOSE = "Filling regions"

Polygon = tuple[Floats, ...]
"""Rings (n, 2), not closed: the outer one and its holes."""


class GraphArrays(Protocol):
    """What is taken of `illustrate_native.Graph`."""

    @property
    def arc_layers_over(self) -> NDArray[np.int32]:
        """(a,) layers that hide it as a line."""

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
class Region:
    """What is seen of a material of an object, in px or mm."""

    object: int
    polygons: tuple[Polygon, ...]
    name: str = ""
    colour: str = "#cccccc"
    material: int = 0  # its number within the object

    @property
    def area(self) -> float:
        """Without holes."""
        return float(sum(_area(o) - sum(map(_area, holes)) for o, *holes in self.polygons))


def regions_of(graph: GraphArrays, seen: Seen, width_px: int, height_px: int) -> list[Region]:
    """What is seen within the frame, by object and material. Raises PlotError without shapely."""
    shapely = load("shapely", PURPOSE)
    frame = shapely.box(0.0, 0.0, float(width_px), float(height_px))
    drawn = [*_visible_lines(shapely, graph), *shapely.linestrings(seen.borders), frame.exterior]
    lines = shapely.union_all(drawn, grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(lines)))
    inner = shapely.point_on_surface(faces)
    faces, inner = (v[shapely.covers(frame, inner)] for v in (faces, inner))
    shown = triangles_at(shapely.get_coordinates(inner), seen)
    faces, shown = faces[shown != NOTHING], shown[shown != NOTHING]
    keys = np.c_[seen.objects[shown], seen.materials[shown]]
    found, which = np.unique(keys, axis=0, return_inverse=True)
    return [
        Region(thing, _polygons(shapely, _joined(shapely, faces, which, i)), material=material)
        for i, (thing, material) in enumerate(found.tolist())
    ]


def _joined(shapely: Any, faces: Any, which: Any, number: int) -> Any:
    return shapely.union_all(faces[which.ravel() == number])


def _visible_lines(shapely: Any, graph: GraphArrays) -> list[Any]:
    offsets, image = np.asarray(graph.arc_offsets), np.asarray(graph.arc_image)
    nodes = np.asarray(graph.arc_nodes)
    lines = []
    for arc in np.flatnonzero(np.asarray(graph.arc_layers_over) == 0):
        points = image[offsets[arc] : offsets[arc + 1]]
        if nodes[arc, 0] < 0:
            points = np.vstack([points, points[:1]])
        if len(points) > 1:
            lines.append(shapely.linestrings(points))
    return lines


def _polygons(shapely: Any, area: Any) -> tuple[Polygon, ...]:
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
    shapely = load("shapely", PURPOSE)
    printed, found = shapely.box(*box), []
    for region in regions:
        polygons = []
        for rings in region.polygons:
            outer, *holes = (
                shapely.linearrings(ring * placing.scale + placing.shift_mm) for ring in rings
            )
            polygons.append(shapely.polygons(outer, holes or None))
        inside = _polygons(shapely, shapely.intersection(shapely.union_all(polygons), printed))
        if inside:
            found.append(replace(region, polygons=inside))
    return tuple(found)


def cut_open(polygon: Polygon) -> Floats:
    """(n, 2) one ring of a polygon with holes, for programs that fill rings one by one.

    Each hole is joined by a cut that is gone along twice, the shortest to what is joined already:
    so no cut crosses a hole. Raises PlotError without shapely where there are holes.
    """
    ring, holes = polygon[0], list(polygon[1:])
    if not holes:
        return ring
    shapely = load("shapely", PURPOSE)
    lines = [shapely.linearrings(hole) for hole in holes]
    while holes:
        outer = shapely.linearrings(ring)
        nearest = int(np.argmin(shapely.distance(outer, lines)))
        cut = shapely.get_coordinates(shapely.shortest_line(outer, lines.pop(nearest)))
        ring = _spliced(ring, holes.pop(nearest), *cut)
    return ring


def _spliced(ring: Floats, hole: Floats, start: Floats, end: Floats) -> Floats:
    """A ring that goes from start, which lies on it, to end on the hole, round that and back."""
    if turn(ring) * turn(hole) > 0:
        hole = hole[::-1]
    at, into = _segment(ring, start), _segment(hole, end)
    around = np.roll(hole, -into - 1, axis=0)
    return np.vstack([ring[: at + 1], start, end, around, end, start, ring[at + 1 :]])


def _segment(ring: Floats, point: Floats) -> int:
    """The segment of a ring that a point lies on."""
    ways = np.roll(ring, -1, axis=0) - ring
    lengths = np.maximum((ways * ways).sum(axis=1), 1e-300)
    shares = (((point - ring) * ways).sum(axis=1) / lengths).clip(0, 1)
    return int(np.argmin(((ring + shares[:, None] * ways - point) ** 2).sum(axis=1)))


def turn(ring: Floats) -> float:
    """Twice the area, with its sign."""
    following = np.roll(ring, -1, axis=0)
    return float((ring[:, 0] * following[:, 1] - ring[:, 1] * following[:, 0]).sum())


def _area(ring: Floats) -> float:
    return abs(turn(ring)) / 2
