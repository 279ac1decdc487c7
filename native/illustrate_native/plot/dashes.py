"""Lines cut into dashes, each a stroke of its own: plotters know no dashed lines."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .strokes import Floats, Indices, Strokes, opened, without_repeats


def dashed(strokes: Strokes, pattern_mm: tuple[float, ...]) -> Strokes:
    """Strokes cut by a pattern of dashes and gaps in turn, begun at the start of each stroke.

    Widths go on along the dashes. A pattern without length leaves all as it is.
    """
    if sum(pattern_mm) <= 0 or not len(strokes):
        return strokes
    whole = opened(strokes)
    along = _along(whole)
    stroke, start, end = _pieces(whole, along, pattern_mm)
    return without_repeats(_cut(whole, along, stroke, start, end))


def _along(whole: Strokes) -> Floats:
    """(p,) length from the start of the first stroke, through all of them."""
    steps = np.linalg.norm(np.diff(whole.points, axis=0, prepend=whole.points[:1]), axis=1)
    steps[whole.offsets[:-1]] = 0.0
    return np.cumsum(steps)


def _pieces(
    whole: Strokes, along: Floats, pattern_mm: tuple[float, ...]
) -> tuple[Indices, Floats, Floats]:
    """The stroke of each dash and where it starts and ends, in lengths of `_along`."""
    borders = np.concatenate([[0.0], np.cumsum(pattern_mm)])
    first, last = along[whole.offsets[:-1]], along[whole.offsets[1:] - 1]
    repeats = np.ceil((last - first) / borders[-1]).astype(np.intp)
    stroke = np.repeat(np.arange(len(whole)), repeats)
    number = np.arange(len(stroke)) - np.repeat(np.cumsum(repeats) - repeats, repeats)
    begin = first[stroke] + number * borders[-1]
    start = (begin[:, None] + borders[:-1:2]).ravel()
    end = (begin[:, None] + borders[1::2]).ravel()
    stroke = np.repeat(stroke, len(borders) // 2)
    end = np.minimum(end, last[stroke])
    drawn = start < end
    return stroke[drawn], start[drawn], end[drawn]


def _cut(whole: Strokes, along: Floats, stroke: Indices, start: Floats, end: Floats) -> Strokes:
    """The parts of strokes between lengths along them, open."""
    # Points strictly inside of a dash; a jump from one stroke to the next is of no length.
    low = np.maximum(np.searchsorted(along, start, "right"), whole.offsets[stroke] + 1)
    high = np.minimum(np.searchsorted(along, end, "left"), whole.offsets[stroke + 1] - 1)
    inner = np.maximum(high - low, 0)
    offsets = np.concatenate([[0], np.cumsum(inner + 2)]).astype(np.intp)
    within = np.arange(offsets[-1]) - np.repeat(offsets[:-1], inner + 2)
    at = np.minimum(np.repeat(low, inner + 2) + within - 1, len(along) - 1)
    points, widths = whole.points[at], whole.widths[at]
    for places, after, length in ((offsets[:-1], low, start), (offsets[1:] - 1, high, end)):
        points[places], widths[places] = _at(whole, along, np.maximum(after - 1, 0), length)
    return replace(
        whole,
        points=points,
        widths=widths,
        offsets=offsets,
        closed=np.zeros(len(stroke), bool),
        labels=whole.labels[stroke],
    )


def _at(whole: Strokes, along: Floats, segment: Indices, length: Floats) -> tuple[Floats, Floats]:
    """Points and widths on segments, at lengths along the strokes."""
    before, after = along[segment], along[segment + 1]
    share = np.divide(
        length - before, after - before, out=np.zeros_like(length), where=after > before
    )
    share = share.clip(0.0, 1.0)
    points = (1 - share[:, None]) * whole.points[segment] + share[:, None] * whole.points[
        segment + 1
    ]
    return points, (1 - share) * whole.widths[segment] + share * whole.widths[segment + 1]
