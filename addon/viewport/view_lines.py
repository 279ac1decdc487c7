"""Silhouettes and feature curves of a prepared surface for any eye, quickly; numpy only.

Not the exact contour of a drawing: the zero set of n . (c - p), linear on each triangle (paper
section 4.1), for a viewer that redraws while the view moves.
"""

from typing import Any

import numpy as np


def eye_of(projection: Any, view: Any) -> Any:
    """(4,) the eye in the world: a point with w = 1, or with w = 0 the direction towards it.

    projection, view: (4, 4), OpenGL's convention.
    """
    world = np.linalg.inv(np.asarray(view, float))
    if projection[3][3] == 0:
        return world[:, 3] / world[3, 3]
    return np.append(world[:3, 2] / np.linalg.norm(world[:3, 2]), 0.0)


class ViewLines:
    """The lines of one `illustrate_native.Surface`."""

    def __init__(self, surface: Any) -> None:
        self._positions = np.asarray(surface.positions, np.float32)
        self._normals = np.asarray(surface.normals, np.float32)
        # n . (e - w p), with what does not depend on the eye computed once
        self._heights = np.einsum("ij,ij->i", self._normals, self._positions)
        triangles = np.asarray(surface.triangles)
        self.triangle_count = len(triangles)
        is_polygon = np.asarray(surface.base_faces)[triangles[:, 0]] < 0
        self._smooth = np.ascontiguousarray(triangles[~is_polygon].T)
        self._edges, self._plane_normals, self._plane_heights = _edges(
            self._positions, triangles[is_polygon]
        )
        self.features = self._positions[np.asarray(surface.feature_edges).ravel()]
        """(2 e, 3) float32 world, ends of segments."""

    def silhouettes(self, eye: Any) -> Any:
        """(2 s, 3) float32 world: ends of the segments where the surface turns away from `eye`."""
        eye = np.asarray(eye, np.float32)
        return np.concatenate([self._smooth_silhouettes(eye), self._polygon_silhouettes(eye)])

    def _smooth_silhouettes(self, eye: Any) -> Any:
        g = self._normals @ eye[:3] - eye[3] * self._heights
        is_front = g >= 0
        corners = is_front[self._smooth].view(np.uint8)
        fronts = corners[0] + corners[1] + corners[2]
        cut = np.flatnonzero((fronts == 1) | (fronts == 2))
        corners, triangles, fronts = corners[:, cut], self._smooth[:, cut], fronts[cut]
        lone = np.argmax(corners == (fronts == 1), axis=0)  # the corner on its own side
        columns = np.arange(len(cut))
        apex = triangles[lone, columns]
        ends = [_zero(g, self._positions, apex, triangles[(lone + k) % 3, columns]) for k in (1, 2)]
        return np.stack(ends, axis=1).reshape(-1, 3)

    def _polygon_silhouettes(self, eye: Any) -> Any:
        is_front = self._plane_normals @ eye[:3] - eye[3] * self._plane_heights >= 0
        turns = is_front[self._edges[:, 2]] != is_front[self._edges[:, 3]]
        return self._positions[self._edges[turns, :2].ravel()]


def _zero(g: Any, positions: Any, a: Any, b: Any) -> Any:
    """(m, 3) where g is 0 between vertices a and b (m,)."""
    share = (g[a] / (g[a] - g[b]))[:, None]
    return (1 - share) * positions[a] + share * positions[b]


def _edges(positions: Any, triangles: Any) -> tuple[Any, Any, Any]:
    """Edges (e, 4) of two triangles: ends and triangles; normals (t, 3) and heights (t,)."""
    corners = positions[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    heights = np.einsum("ij,ij->i", normals, corners[:, 0])
    ends = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, owner = ends[order], owner[order]
    pairs = np.flatnonzero((ends[1:] == ends[:-1]).all(axis=1)) if len(ends) else np.zeros(0, int)
    edges = np.c_[ends[pairs], owner[pairs], owner[pairs + 1]]
    return edges.reshape(-1, 4), normals, heights
