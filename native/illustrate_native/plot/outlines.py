"""The area that a round pen of changing width covers, as rings to be filled."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..svg import side_vectors
from .strokes import Floats, Strokes

CAP_STEPS = 6  # of half a circle


def outlines(strokes: Strokes) -> Iterator[list[Floats]]:
    """Rings (n, 2) of each stroke: one, or of a closed stroke its outer and its inner one."""
    for i in range(len(strokes)):
        span = strokes.span(i)
        yield _rings(strokes.points[span], strokes.widths[span] / 2, bool(strokes.closed[i]))


def _rings(points: Floats, radii: Floats, is_closed: bool) -> list[Floats]:
    side = side_vectors(points, is_closed) * radii[:, None]
    left, right = points + side, (points - side)[::-1]
    if is_closed:
        return [left, right]
    caps = _cap(points[-1], side[-1]), _cap(points[0], -side[0])
    return [np.vstack([left, caps[0], right, caps[1]])]


def _cap(middle: Floats, side: Floats) -> Floats:
    """Half a circle from one side to the other, without its ends."""
    angle = np.arange(1, CAP_STEPS) * np.pi / CAP_STEPS
    across = np.array([-side[1], side[0]])
    return np.asarray(middle + np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * across)
