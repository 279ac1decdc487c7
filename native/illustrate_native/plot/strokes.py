"""Strokes on paper as plain arrays, and what every step of a plot does with them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Flags = NDArray[np.bool_]

HAIR_MM = 1e-4
"""Points nearer to each other than this are one."""


class Subject(NamedTuple):
    """What strokes show; pens are chosen by it."""

    kind: str  # title of the group of lines, such as 'Silhouette' or 'Hidden'
    object: str = ""
    collections: tuple[str, ...] = ()
    material: str = ""


@dataclass(frozen=True)
class Strokes:
    """p points in s strokes; x to the right, y down, from the page's top left corner.

    Before `pages.place` lengths are pixels of the picture, after it millimetres. A closed stroke
    does not repeat its first point.
    """

    points: Floats  # (p, 2)
    widths: Floats  # (p,)
    offsets: Indices  # (s + 1,): stroke i is points[offsets[i]:offsets[i + 1]]
    closed: Flags  # (s,)
    labels: Indices  # (s,) index into subjects
    subjects: tuple[Subject, ...]

    def __len__(self) -> int:
        """How many strokes there are."""
        return len(self.closed)

    @property
    def sizes(self) -> Indices:
        """(s,) points of each stroke."""
        return np.diff(self.offsets)

    @property
    def owners(self) -> Indices:
        """(p,) the stroke of each point."""
        return np.repeat(np.arange(len(self)), self.sizes)

    def span(self, stroke: int) -> slice:
        """The points of a stroke."""
        return slice(int(self.offsets[stroke]), int(self.offsets[stroke + 1]))


def make_strokes(
    polylines: list[Any],
    widths: float | list[Any] = 1.0,
    closed: bool | list[bool] = False,
    labels: Any = None,
    subjects: tuple[Subject, ...] = (Subject("Line"),),
) -> Strokes:
    """Strokes from a list of (n, 2) polylines; a single width or flag counts for all.

    widths: else a list for each polyline, a width for each of its points.
    """
    count = len(polylines)
    points = [np.asarray(line, float).reshape(-1, 2) for line in polylines]
    sizes = np.array([len(line) for line in points], np.intp)
    if isinstance(widths, list):
        wide = np.concatenate([np.zeros(0), *(np.asarray(w, float) for w in widths)])
    else:
        wide = np.full(sizes.sum(), float(widths))
    return Strokes(
        np.concatenate([np.zeros((0, 2)), *points]),
        wide,
        np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        np.array(closed if isinstance(closed, list) else [closed] * count, bool),
        np.zeros(count, np.intp) if labels is None else np.asarray(labels, np.intp),
        subjects,
    )


def chosen(strokes: Strokes, which: Any, is_reversed: Any = None) -> Strokes:
    """The strokes `which` (indices or flags) in that order, some of them backwards (flags)."""
    which = np.arange(len(strokes))[which]
    sizes = strokes.sizes[which]
    within = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    if is_reversed is not None:
        backwards = np.repeat(np.asarray(is_reversed, bool), sizes)
        within = np.where(backwards, np.repeat(sizes, sizes) - 1 - within, within)
    points = np.repeat(strokes.offsets[which], sizes) + within
    return Strokes(
        strokes.points[points],
        strokes.widths[points],
        np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        strokes.closed[which],
        strokes.labels[which],
        strokes.subjects,
    )


def with_points(strokes: Strokes, keep: Flags) -> Strokes:
    """The same with the points that are kept; strokes that lose all are gone."""
    sizes = np.bincount(strokes.owners[keep], minlength=len(strokes))
    left = sizes > 0
    return Strokes(
        strokes.points[keep],
        strokes.widths[keep],
        np.concatenate([[0], np.cumsum(sizes[left])]).astype(np.intp),
        strokes.closed[left],
        strokes.labels[left],
        strokes.subjects,
    )


def without_repeats(strokes: Strokes) -> Strokes:
    """The same without points at the place of the one before, and without strokes of one point.

    A closed stroke of two points is an open one there and back: it stays, open.
    """
    points, offsets = strokes.points, strokes.offsets
    step = np.linalg.norm(np.diff(points, axis=0, prepend=np.nan), axis=1)
    keep = ~(step <= HAIR_MM)
    keep[offsets[:-1][strokes.sizes > 0]] = True
    filled = strokes.closed & (strokes.sizes > 1)
    first, last = offsets[:-1][filled], offsets[1:][filled] - 1
    returns = np.linalg.norm(points[last] - points[first], axis=1) <= HAIR_MM
    keep[last[returns]] = False
    kept = with_points(strokes, keep)
    kept = chosen(kept, kept.sizes > 1)
    is_ring = kept.closed & (kept.sizes > 2)
    return replace(kept, closed=is_ring)


def opened(strokes: Strokes) -> Strokes:
    """The same with the first point of closed strokes repeated at their ends; flags stay."""
    sizes = strokes.sizes
    grown = sizes + strokes.closed
    within = np.arange(grown.sum()) - np.repeat(np.cumsum(grown) - grown, grown)
    within %= np.maximum(np.repeat(sizes, grown), 1)
    points = np.repeat(strokes.offsets[:-1], grown) + within
    return Strokes(
        strokes.points[points],
        strokes.widths[points],
        np.concatenate([[0], np.cumsum(grown)]).astype(np.intp),
        strokes.closed,
        strokes.labels,
        strokes.subjects,
    )


def lengths(strokes: Strokes) -> Floats:
    """(s,) how long each stroke is, the way back to the start of closed ones too."""
    whole = opened(strokes)
    steps = np.linalg.norm(np.diff(whole.points, axis=0), axis=1)
    same = whole.owners[1:] == whole.owners[:-1]
    return np.bincount(whole.owners[1:][same], steps[same], len(strokes)).astype(float)


def rolled(strokes: Strokes, turns: Indices) -> Strokes:
    """The same with the points of each stroke begun `turns` (s,) points later."""
    sizes = np.repeat(strokes.sizes, strokes.sizes)
    within = np.arange(len(strokes.points)) - np.repeat(strokes.offsets[:-1], strokes.sizes)
    at = np.repeat(strokes.offsets[:-1], strokes.sizes)
    points = at + (within + np.repeat(turns, strokes.sizes)) % np.maximum(sizes, 1)
    return replace(strokes, points=strokes.points[points], widths=strokes.widths[points])


def concatenated(parts: list[Strokes]) -> Strokes:
    """Strokes of the same subjects, one after another; there is at least one part."""
    sizes = np.concatenate([part.sizes for part in parts])
    return Strokes(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.widths for part in parts]),
        np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        np.concatenate([part.closed for part in parts]),
        np.concatenate([part.labels for part in parts]),
        parts[0].subjects,
    )
