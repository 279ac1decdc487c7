"""Corners of polygons joined to vertices by name, and points of neighbours put into edges."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from .march import ALONG_X, ALONG_Y, AT_NODE, Polygons
from .patches import CROSSING, EDGE_CROSSING, EDGE_NODE, NODE, STEPS, Edges, Patches, pair_keys

SAME = 1e-7  # places on an edge that are one


@dataclass
class Corners:
    """Corners of polygons, one polygon after another."""

    sizes: Any  # (n,)
    keys: Any  # (c,) names of points: numbers of vertices, or see patches.py
    values: Any  # (c, 3 + k) places and all values of corners
    edges: Any  # (c,) the edge along which the polygon goes on from each, -1: none
    places: Any  # (c, 2) where on it, to where

    def joined(self, others: "Corners") -> "Corners":
        """These, and then the others."""
        names = self.__dataclass_fields__
        return Corners(*(np.concatenate([getattr(self, n), getattr(others, n)]) for n in names))

    def ordered(self, order: Any) -> "Corners":
        """The same polygons in another order."""
        at = ragged(np.cumsum(self.sizes)[order] - self.sizes[order], self.sizes[order])
        held = (self.keys, self.values, self.edges, self.places)
        return Corners(self.sizes[order], *(each[at] for each in held))


def ragged(starts: Any, counts: Any) -> Any:
    """The numbers from each start on, as many as its count."""
    before = np.cumsum(counts) - counts
    return np.arange(int(counts.sum())) + np.repeat(starts - before, counts)


# --- Names --------------------------------------------------------------------------------------


def side_points(
    patches: Patches, sizes: Any, side_hashes: Any, polygons: Polygons
) -> tuple[Any, Any, Any]:
    """Names of the corners of polygons, and where they lie on their patches, in cells."""
    p, kinds = polygons.patches, polygons.kinds
    x = polygons.x + np.where(kinds == ALONG_X, polygons.shares, 0.0)
    y = polygons.y + np.where(kinds == ALONG_Y, polygons.shares, 0.0)
    m, n = sizes[p].T
    before = np.cumsum((sizes + 1).prod(axis=1)) - (sizes + 1).prod(axis=1)
    node = before[p] + polygons.x * (n + 1) + polygons.y
    keys = np.where(kinds == AT_NODE, NODE + node, CROSSING + 2 * node + (kinds == ALONG_Y))
    seen = np.unique(side_hashes, return_inverse=True)[1].reshape(side_hashes.shape)
    for side, (at, on) in enumerate(
        ((x / m, y == 0), (y / n, x == m), (1 - x / m, y == n), (1 - y / n, x == 0))
    ):
        chosen = np.flatnonzero(on)
        cells = (m, n)[side % 2][chosen]
        keys[chosen] = _on_side(patches, seen, p[chosen], side, at[chosen], cells, kinds[chosen])
    for corner, (i, j) in enumerate(
        ((x == 0, y == 0), (x == m, y == 0), (x == m, y == n), (x == 0, y == n))
    ):
        keys[i & j] = patches.keys[p[i & j], corner]
    return keys, x, y


def _on_side(
    patches: Patches, seen: Any, p: Any, side: int, at: Any, cells: Any, kinds: Any
) -> Any:
    """Names of points on a side: of a node by its edge, of a crossing by the cell in it, too.

    Edges of which the two faces see another part of the image have two crossings there.
    """
    begin, end = patches.places[p, side].T
    first = np.where(kinds == AT_NODE, np.rint(at * cells), np.floor(at * cells))
    last = np.where(kinds == AT_NODE, first, first + 1)
    steps = [np.rint((begin + (end - begin) * each / cells) * STEPS) for each in (first, last)]
    place = np.minimum(*steps).astype(np.int64)
    of_node = EDGE_NODE + patches.edges[p, side] * STEPS + place
    return np.where(kinds == AT_NODE, of_node, EDGE_CROSSING + seen[p, side] * STEPS + place)


# --- Vertices -----------------------------------------------------------------------------------


@dataclass
class Points:
    """The vertices of a new mesh."""

    corners: Corners  # with the points of neighbours
    corner_vertices: Any  # (c,)
    vertices: Any  # (n,) of the old mesh, -1: new ones
    positions: Any  # (n, 3) of new ones
    numbers: Any  # (vertices of the old mesh,) their new ones, -1: gone
    on_edges: tuple[Any, Any]  # (k,) edge + place, as `_rank`, in order, and vertices there


def welded(corners: Corners, vertex_count: int, loose_edges: Any) -> Points:
    """Polygons with one vertex for each name; ends of loose edges stay too."""
    ranks, keys = _points_on_edges(corners)
    corners = _with_neighbours(corners, ranks, keys)
    loose = np.zeros(0, np.int64) if loose_edges is None else np.reshape(loose_edges, -1)
    names, first, found = np.unique(
        np.concatenate([corners.keys, loose]), return_index=True, return_inverse=True
    )
    positions = np.concatenate([corners.values[:, :3], np.zeros((len(loose), 3))])[first]
    vertices = np.where(names < vertex_count, names, -1)
    numbers = np.full(vertex_count, -1)
    numbers[vertices[vertices >= 0]] = np.flatnonzero(vertices >= 0)
    of_corners = found.reshape(-1)[: len(corners.keys)]
    return Points(
        corners, of_corners, vertices, positions, numbers, (ranks, np.searchsorted(names, keys))
    )


def _rank(edges: Any, places: Any) -> Any:
    """Orders points by edge, then place."""
    return 2.0 * edges + places


def _points_on_edges(corners: Corners) -> tuple[Any, Any]:
    """Ranks in order and names of all points that are new on an edge."""
    following = following_of(corners.sizes)
    along = np.flatnonzero(corners.edges >= 0)
    keys = np.concatenate([corners.keys[along], corners.keys[following[along]]])
    ranks = np.concatenate([_rank(corners.edges[along], corners.places[along, i]) for i in (0, 1)])
    inner = np.abs(ranks % 2 - 0.5) < 0.5 - SAME
    order = np.argsort(ranks[inner], kind="stable")
    keys, ranks = keys[inner][order], ranks[inner][order]
    _, first = np.unique(keys, return_index=True)
    first.sort()
    return ranks[first], keys[first]


def _with_neighbours(corners: Corners, ranks: Any, keys: Any) -> Corners:
    """Polygons with all points that lie on their edges, values linear between their corners."""
    runs = _rank(corners.edges[:, None], corners.places)
    begin = np.searchsorted(ranks, runs.min(axis=1) + SAME, "right")
    end = np.searchsorted(ranks, runs.max(axis=1) - SAME, "left")
    counts = np.where(corners.edges >= 0, (end - begin).clip(0), 0)
    source = np.repeat(np.arange(len(counts)), counts + 1)
    step = ragged(np.zeros(len(counts), np.int64), counts + 1)
    is_new, is_back = step > 0, (runs[:, 0] > runs[:, 1])[source]
    at = np.where(is_back, end[source] - step, begin[source] + step - 1)[is_new]
    made = Corners(
        _sums(counts + 1, corners.sizes),
        corners.keys[source],
        corners.values[source],
        corners.edges[source],
        corners.places[source],
    )
    made.keys[is_new] = keys[at]
    here, there = source[is_new], following_of(corners.sizes)[source[is_new]]
    share = (ranks[at] - runs[here, 0]) / (runs[here, 1] - runs[here, 0])
    share = share[:, None]
    made.values[is_new] = corners.values[here] * (1 - share) + corners.values[there] * share
    return made


def following_of(sizes: Any) -> Any:
    """(c,) the next corner of the polygon of each."""
    ends = np.cumsum(sizes)
    following = np.arange(1, int(sizes.sum()) + 1)
    following[ends - 1] = ends - sizes
    return following


def _sums(counts: Any, sizes: Any) -> Any:
    """(n,) of what corners (c,) count, by polygon."""
    return np.bincount(np.repeat(np.arange(len(sizes)), sizes), counts, len(sizes)).astype(np.int64)


def spread_edges(pairs: Any, edges: Edges, points: Points) -> tuple[Any, Any]:
    """What is left of edges (k, 2) of the old mesh: edges (m, 2) of the new one, and which of k."""
    pairs = np.asarray(pairs, np.int64).reshape(-1, 2)
    numbers = edges.numbers_of(pair_keys(pairs, len(points.numbers)), len(points.numbers))
    known = numbers >= 0
    ends = pairs.copy()
    ends[known] = edges.vertices[numbers[known]]
    ranks, on_edges = points.on_edges
    begin = np.searchsorted(ranks, 2.0 * numbers)
    counts = np.where(known, np.searchsorted(ranks, 2.0 * numbers + 1) - begin, 0)
    rows = np.repeat(np.arange(len(pairs)), counts + 1)
    step = ragged(np.zeros(len(pairs), np.int64), counts + 1)
    held = np.append(on_edges, -1)
    first = np.where(step == 0, points.numbers[ends[rows, 0]], held[(begin[rows] + step - 1)])
    is_last = step == counts[rows]
    last = np.where(
        is_last, points.numbers[ends[rows, 1]], held[np.minimum(begin[rows] + step, len(on_edges))]
    )
    parts = np.stack([first, last], axis=1)
    kept: Any = (parts >= 0).all(axis=1)
    kept[kept] = _are_edges(parts[kept], points) | ~known[rows[kept]]
    return parts[kept].astype(np.int32), rows[kept]


def _are_edges(pairs: Any, points: Points) -> Any:
    """(k,) bool: pairs of vertices that a polygon has side by side."""
    if not len(pairs):
        return np.zeros(0, bool)
    corners, count = points.corner_vertices, len(points.vertices)
    sides = np.stack([corners, corners[following_of(points.corners.sizes)]], axis=1)
    return np.isin(pair_keys(pairs, count), pair_keys(sides, count))
