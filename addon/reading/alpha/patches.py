"""Faces as four-sided patches with a lattice of cells each, alike along edges that faces share.

A quad is a patch. Any other face is one for each of its corners: from the corner to the middles of
its two edges and the middle of the face, so that edges of quads and other faces are halved alike.

Patches have corners 0 .. 3 in the order of the face, and sides 0 .. 3 from each to the next. Sides
lie on edges: those of the mesh first, from the vertex of lower number to the other, then spokes,
one for each corner of the mesh, from the middle of the edge that begins there to that of its face.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

QUAD = 4
STEPS = 1 << 20  # in which places along edges are counted
EDGE_NODE, EDGE_CROSSING, MIDDLE, NODE, CROSSING = (kind << 58 for kind in range(1, 6))
"""Names of new points begin so; those of vertices are their numbers."""
FINEST, COARSEST = 14, 1  # halvings of an edge


@dataclass
class Edges:
    """The edges of a mesh, corner by corner."""

    vertices: Any  # (e, 2) the lower number first
    of_corners: Any  # (corners,) the edge from each corner to the next
    is_forward: Any  # (corners,) bool: it goes from its first vertex to its second
    following: Any  # (corners,) the next corner of the face
    faces: Any  # (corners,) the face of each

    def numbers_of(self, keys: Any, vertex_count: int) -> Any:
        """(k,) numbers of edges of named pairs: see `pair_keys`; -1 where there is none."""
        own = pair_keys(self.vertices, vertex_count)
        at = np.searchsorted(own, keys).clip(0, max(len(own) - 1, 0))
        return np.where(own[at] == keys, at, -1) if len(own) else np.full(len(keys), -1)


def pair_keys(pairs: Any, count: int) -> Any:
    """(k,) a number for each pair (k, 2) of numbers below `count`, whichever comes first."""
    ordered = np.sort(np.asarray(pairs, np.int64).reshape(-1, 2), axis=1)
    return ordered[:, 0] * count + ordered[:, 1]


def edges_of(face_sizes: Any, corner_vertices: Any, vertex_count: int) -> Edges:
    """The edges of faces."""
    sizes, corners = face_sizes.astype(np.int64), corner_vertices.astype(np.int64)
    ends = np.cumsum(sizes)
    following = np.arange(1, len(corners) + 1)
    following[ends[sizes > 0] - 1] = (ends - sizes)[sizes > 0]
    pairs = np.stack([corners, corners[following]], axis=1)
    keys, numbers = np.unique(pair_keys(pairs, vertex_count), return_inverse=True)
    vertices = np.stack([keys // vertex_count, keys % vertex_count], axis=1)
    faces = np.repeat(np.arange(len(sizes)), sizes)
    return Edges(vertices, numbers.reshape(-1), pairs[:, 0] <= pairs[:, 1], following, faces)


@dataclass
class Patches:
    """All patches of the faces that are asked for: first those of quads."""

    quads: Any  # (q, 4) corners of the mesh
    others: Any  # (o,) corners of faces that are no quads
    before: Any  # (o,) the corner before each
    following: Any  # (o,) the corner after each
    group: Any  # (o,) the face of each, counted from 0
    faces: Any  # (p,)
    edges: Any  # (p, 4) of the sides
    places: Any  # (p, 4, 2) where on their edges sides begin and end, 0 .. 1
    keys: Any  # (p, 4) names of the corners

    def at_corners(self, values: Any) -> Any:
        """(p, 4, k) from values (corners, k) of the mesh."""
        own = values[self.others]
        after = (own + values[self.following]) / 2
        back = (own + values[self.before]) / 2
        count = int(self.group.max()) + 1 if len(self.group) else 0
        sums = np.zeros((count, values.shape[1]))
        np.add.at(sums, self.group, own)
        sizes = np.bincount(self.group, minlength=count)
        middle = (sums / np.maximum(sizes, 1)[:, None])[self.group]
        return np.concatenate([values[self.quads], np.stack([own, after, middle, back], axis=1)])


def patches_of(face_sizes: Any, corner_vertices: Any, edges: Edges, chosen: Any) -> Patches:
    """Patches of the chosen faces (f,) bool."""
    starts = np.cumsum(face_sizes.astype(np.int64)) - face_sizes
    of_quads = np.flatnonzero(chosen & (face_sizes == QUAD))
    quads = starts[of_quads][:, None] + np.arange(QUAD)
    others = np.flatnonzero((chosen & (face_sizes != QUAD))[edges.faces])
    previous = np.empty(len(edges.following), np.int64)
    previous[edges.following] = np.arange(len(previous))
    before, faces = previous[others], edges.faces[others]
    group = np.unique(faces, return_inverse=True)[1].reshape(-1)
    side_edges, places = _sides(edges, quads, others, before)
    vertex = corner_vertices.astype(np.int64)
    half = EDGE_NODE + STEPS // 2
    own_keys = [vertex[others], half + edges.of_corners[others] * STEPS]
    own_keys += [MIDDLE + faces, half + edges.of_corners[before] * STEPS]
    keys = np.concatenate([vertex[quads], np.stack(own_keys, axis=1)])
    return Patches(
        quads,
        others,
        before,
        edges.following[others],
        group,
        np.concatenate([of_quads, faces]),
        side_edges,
        places,
        keys,
    )


def _sides(edges: Edges, quads: Any, others: Any, before: Any) -> tuple[Any, Any]:
    """Edges (p, 4) of the sides and places (p, 4, 2) on them."""
    spokes = len(edges.vertices)
    forward = edges.is_forward.astype(float)
    of_quads = np.stack([1 - forward[quads], forward[quads]], axis=2)
    after, back = forward[others], forward[before]
    half, none = np.full(len(others), 0.5), np.zeros(len(others))
    places = [(1 - after, half), (none, none + 1), (none + 1, none), (half, back)]
    of_others = np.stack([np.stack(each, axis=1) for each in places], axis=1)
    numbers = [edges.of_corners[others], spokes + others, spokes + before, edges.of_corners[before]]
    return (
        np.concatenate([edges.of_corners[quads], np.stack(numbers, axis=1)]),
        np.concatenate([of_quads, of_others]),
    )


def halvings_of(patches: Patches, lengths: Any, edges: Edges) -> Any:
    """(p, 2) how often the sides 0 and 1 of patches are halved, before any limit but FINEST.

    lengths: (corners,) cells along the edge from each corner. Opposite sides of patches are
    halved alike, and so are all that lie on one edge.
    """
    wanted = np.zeros(len(edges.vertices), np.int64)
    used = np.concatenate([patches.quads.reshape(-1), patches.others])
    cells = np.nan_to_num(lengths[used]).clip(1, 2**FINEST)
    np.maximum.at(wanted, edges.of_corners[used], np.rint(np.log2(cells)).astype(np.int64))
    sides = edges.of_corners[patches.quads]
    own = edges.of_corners[patches.others]
    while True:
        before = wanted.copy()
        for pair in (sides[:, ::2], sides[:, 1::2]):
            np.maximum.at(wanted, pair, wanted[pair].max(axis=1, keepdims=True))
        if len(own):
            most = np.zeros(int(patches.group.max()) + 1, np.int64)
            np.maximum.at(most, patches.group, wanted[own])
            np.maximum.at(wanted, own, most[patches.group])
        if (wanted == before).all():
            break
    return np.concatenate([wanted[sides[:, :2]], np.stack([wanted[own]] * 2, axis=1)])


def lattice_sizes(patches: Patches, halvings: Any, coarser: int) -> Any:
    """(p, 2) cells along the sides 0 and 1, halved so many times less, but once at least."""
    kept = np.maximum(halvings - coarser, COARSEST)
    kept[len(patches.quads) :] -= 1
    return np.int64(1) << kept
