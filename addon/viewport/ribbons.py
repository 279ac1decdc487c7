"""Strokes as triangles of the width that they have, with edges that fade over a pixel.

The graphics card of a viewport does not smooth what is drawn over it: here the outermost pixel of a
stroke is a ramp of its own. Plain arrays, no Blender.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

MOST_MITRE = 2.0  # times the width, at sharp bends
ACROSS = 4  # vertices across a stroke: outside, inside, inside, outside
SIDES = np.array([-1.0, -1.0, 1.0, 1.0])
RAMP = np.array([0.5, -0.5, -0.5, 0.5])  # px beyond half the width
IS_INSIDE = np.array([0.0, 1.0, 1.0, 0.0])


@dataclass(frozen=True)
class Ribbons:
    """Triangles in the region."""

    points: Any  # (n, 3) float32 px, depth
    colours: Any  # (n, 4) float32
    triangles: Any  # (t, 3) int32


def ribbons_of(
    points: Any, widths: Any, offsets: Any, closed: Any, colours: Any, depths: Any = 0.0
) -> Ribbons:
    """Ribbons of strokes.

    points: (p, 2) px. widths: (p,) px. offsets: (s + 1,) stroke i is points[offsets[i]] and on.
    closed: (s,) the last point is joined to the first. colours: (s, 4). depths: (p,) of any kind.
    """
    points, offsets = np.asarray(points, float), np.asarray(offsets, np.intp)
    sizes = np.diff(offsets)
    after, before = _neighbours(offsets, closed, len(points))
    mitres = _mitres(points, after, before)
    widths = np.asarray(widths, float)
    reach = np.maximum(widths, 1.0)[:, None] / 2 + RAMP  # thinner ones are as wide and paler
    offset = (SIDES * reach)[:, :, None] * mitres[:, None, :]
    vertices = np.zeros((len(points), ACROSS, 3), np.float32)
    vertices[:, :, :2] = points[:, None, :] + offset
    vertices[:, :, 2] = np.broadcast_to(depths, len(points))[:, None]
    inks = np.repeat(np.repeat(np.asarray(colours, np.float32), sizes, axis=0), ACROSS, axis=0)
    inks = inks.reshape(-1, ACROSS, 4).copy()
    inks[:, :, 3] *= IS_INSIDE * np.minimum(widths, 1.0)[:, None]
    starts = np.flatnonzero(after != np.arange(len(points)))
    triangles = _bands(starts, after[starts])
    return Ribbons(vertices.reshape(-1, 3), inks.reshape(-1, 4), triangles)


def _neighbours(offsets: Any, closed: Any, count: int) -> tuple[Any, Any]:
    """(p,) the points after and before each along its stroke; itself at an open end."""
    after, before = np.arange(count) + 1, np.arange(count) - 1
    sizes = np.diff(offsets)
    first, last = offsets[:-1][sizes > 0], offsets[1:][sizes > 0] - 1
    is_closed = np.asarray(closed, bool)[sizes > 0]
    after[last] = np.where(is_closed, first, last)
    before[first] = np.where(is_closed, last, first)
    return after, before


def _mitres(points: Any, after: Any, before: Any) -> Any:
    """(p, 2) across the stroke, as long as keeps both sides as far apart as the stroke is wide."""
    ahead, behind = _unit(points[after] - points), _unit(points - points[before])
    ahead = np.where((ahead == 0).all(axis=1)[:, None], behind, ahead)
    behind = np.where((behind == 0).all(axis=1)[:, None], ahead, behind)
    along = _unit(ahead + behind)
    along = np.where((along == 0).all(axis=1)[:, None], ahead, along)
    cosine = np.abs((along * ahead).sum(axis=1, keepdims=True))
    return np.c_[-along[:, 1], along[:, 0]] / np.maximum(cosine, 1 / MOST_MITRE)


def _unit(vectors: Any) -> Any:
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.divide(vectors, lengths, out=np.zeros_like(vectors), where=lengths > 0)


def _bands(starts: Any, ends: Any) -> Any:
    """(6 b, 3) triangles of the three bands between points and those after them."""
    a = (ACROSS * starts)[:, None] + np.arange(ACROSS - 1)
    b = (ACROSS * ends)[:, None] + np.arange(ACROSS - 1)
    first = np.stack([a, a + 1, b], axis=-1).reshape(-1, 3)
    second = np.stack([a + 1, b + 1, b], axis=-1).reshape(-1, 3)
    return np.concatenate([first, second]).astype(np.int32)
