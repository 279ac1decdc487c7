"""The order and direction of strokes, and what they cost a plotter.

Shortest: from each stroke to the nearest end of those left, then 2-opt (turning a run of strokes
round) and Or-opt (moving a short run elsewhere) until neither shortens the way with the pen up.
Closed strokes start where the pen comes from and goes to. Wet: strokes that come near each other
are drawn in different passes, so that ink dries meanwhile.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .errors import PlotError
from .strokes import (
    Floats,
    Indices,
    Strokes,
    chosen,
    concatenated,
    lengths,
    opened,
    rolled,
)
from .tours import improved

MODES = ("shortest", "drawing", "wet")
ENTRIES = 32  # points of a closed stroke at which the search may enter it
SWEEP = 128  # strokes after which those done are forgotten
HOME = (0.0, 0.0)  # where the pen begins and ends: the corner of the page


@dataclass(frozen=True)
class Machine:
    """How fast a plotter is; those of an AxiDraw as it comes, about."""

    down_mm_s: float = 50.0
    up_mm_s: float = 150.0
    lift_s: float = 0.3  # raising the pen and lowering it

    def check(self) -> None:
        """Raises PlotError for a machine that never ends."""
        if not (self.down_mm_s > 0 and self.up_mm_s > 0 and self.lift_s >= 0):
            raise PlotError("the plotter's speeds must be positive, its lift at least 0 s")


@dataclass(frozen=True)
class Cost:
    """What a plot takes."""

    strokes: int = 0
    down_mm: float = 0.0
    up_mm: float = 0.0
    seconds: float = 0.0

    def __add__(self, other: Cost) -> Cost:
        """Both."""
        return Cost(
            self.strokes + other.strokes,
            self.down_mm + other.down_mm,
            self.up_mm + other.up_mm,
            self.seconds + other.seconds,
        )


def cost(strokes: Strokes, machine: Machine) -> Cost:
    """Of strokes in their order, with the way to the first one and back from the last."""
    down, up = float(lengths(strokes).sum()), float(pen_up_ways(strokes).sum())
    seconds = down / machine.down_mm_s + up / machine.up_mm_s + len(strokes) * machine.lift_s
    return Cost(len(strokes), down, up, seconds)


def pen_up_ways(strokes: Strokes) -> Floats:
    """(s + 1,) lengths of the ways from HOME to the first stroke, between strokes, and back."""
    ways = np.diff(pen_up_segments(strokes), axis=1)[:, 0]
    return np.asarray(np.linalg.norm(ways, axis=1))


def pen_up_segments(strokes: Strokes) -> Floats:
    """(s + 1, 2, 2) the ways with the pen up."""
    first, last = ends_of(strokes)
    leave, reach = np.vstack([[HOME], last]), np.vstack([first, [HOME]])
    return np.stack([leave, reach], axis=1)


def ends_of(strokes: Strokes) -> tuple[Floats, Floats]:
    """(s, 2) where strokes begin and end; closed ones end where they begin."""
    begin, end = strokes.offsets[:-1], strokes.offsets[1:] - 1
    return strokes.points[begin], strokes.points[np.where(strokes.closed, begin, end)]


def ordered(
    strokes: Strokes, mode: str = "shortest", wet_mm: float = 2.0, passes: int = 4
) -> Strokes:
    """Strokes of one pen in the order of a mode of MODES, each with a point at least.

    wet_mm, passes: of 'wet', how near strokes are kept apart, in how many passes. Raises PlotError.
    """
    if mode not in MODES:
        raise PlotError(f"order is {mode!r}, not one of {', '.join(MODES)}")
    if mode == "drawing" or not len(strokes):
        return strokes
    if mode == "shortest":
        return _shortest(strokes, np.array(HOME))
    pass_of = passes_of(strokes, wet_mm, passes)
    done, pen = [], np.array(HOME)
    for number in np.unique(pass_of):
        done.append(_shortest(chosen(strokes, pass_of == number), pen))
        pen = ends_of(done[-1])[1][-1]
    return concatenated(done)


def _shortest(strokes: Strokes, pen: Floats) -> Strokes:
    tour = _nearest_first(strokes, pen)
    sequence, is_turned = improved(*ends_of(tour), pen)
    tour = chosen(tour, sequence, is_turned & ~tour.closed[sequence])
    return _best_entries(tour, pen)


def _nearest_first(strokes: Strokes, pen: Floats) -> Strokes:
    """From each stroke to the nearest end of those left; closed ones begin where they are met."""
    points, exits, offsets = _entries(strokes)
    stroke_of = np.repeat(np.arange(len(strokes)), np.diff(offsets))
    places = strokes.points[points] @ (1, 1j)
    here, left = complex(*pen), np.arange(len(points))
    is_left = np.ones(len(points), bool)
    met = np.empty(len(strokes), np.intp)
    for step in range(len(strokes)):
        far = np.where(is_left[left], np.abs(places[left] - here), np.inf)
        met[step] = left[np.argmin(far)]
        here = complex(*strokes.points[exits[met[step]]])
        stroke = stroke_of[met[step]]
        is_left[offsets[stroke] : offsets[stroke + 1]] = False
        if step % SWEEP == 0:
            left = left[is_left[left]]
    sequence = stroke_of[met]
    entry = np.empty(len(strokes), np.intp)
    entry[sequence] = points[met] - strokes.offsets[sequence]
    begun = rolled(strokes, np.where(strokes.closed, entry, 0))
    return chosen(begun, sequence, (~strokes.closed & (entry > 0))[sequence])


def _entries(strokes: Strokes) -> tuple[Indices, Indices, Indices]:
    """Points at which strokes may be begun, where the pen is after it, and their offsets (s + 1,).

    Both ends of open ones, at most ENTRIES points of closed ones.
    """
    sizes = strokes.sizes
    counts = np.where(strokes.closed, np.minimum(sizes, ENTRIES), 2)
    offsets = np.concatenate([[0], np.cumsum(counts)]).astype(np.intp)
    within = np.arange(offsets[-1]) - np.repeat(offsets[:-1], counts)
    closed, begin = np.repeat(strokes.closed, counts), np.repeat(strokes.offsets[:-1], counts)
    size, count = np.repeat(sizes, counts), np.repeat(counts, counts)
    points = begin + np.where(closed, within * size // count, within * (size - 1))
    exits = np.where(closed, points, begin + (1 - within) * (size - 1))
    return points, exits, offsets


def _best_entries(tour: Strokes, pen: Floats) -> Strokes:
    """Closed strokes begun at the point that is least out of the way."""
    first, last = ends_of(tour)
    turns = np.zeros(len(tour), np.intp)
    for i in np.flatnonzero(tour.closed):
        ring = tour.points[tour.span(int(i))]
        come = last[i - 1] if i else pen
        go = first[i + 1] if i + 1 < len(tour) else np.array(HOME)
        way = np.linalg.norm(ring - come, axis=1) + np.linalg.norm(ring - go, axis=1)
        turns[i] = np.argmin(way)
        first[i] = last[i] = ring[turns[i]]
    return rolled(tour, turns)


def passes_of(strokes: Strokes, wet_mm: float, passes: int) -> Indices:
    """(s,) the pass of each stroke: of `passes`, one with the fewest strokes within wet_mm of it.

    Nearness is told by squares of wet_mm: those of a stroke and the eight round each.
    Raises PlotError.
    """
    if not (wet_mm > 0 and passes >= 1):
        raise PlotError("wet strokes need a distance and at least one pass")
    cells, owners, columns = _cells_of(strokes, wet_mm)
    around = np.add.outer((-columns, 0, columns), (-1, 0, 1)).ravel()
    crowd = np.zeros((passes, int(cells.max()) + columns + 2), np.int32)
    bounds = np.searchsorted(owners, np.arange(len(strokes) + 1))
    pass_of = np.empty(len(strokes), np.intp)
    for i in range(len(strokes)):
        mine = cells[bounds[i] : bounds[i + 1]]
        pass_of[i] = np.argmin(crowd[:, mine].sum(axis=1))
        crowd[pass_of[i], np.unique(np.add.outer(mine, around))] += 1
    return pass_of


def _cells_of(strokes: Strokes, size: float) -> tuple[Indices, Indices, int]:
    """Squares that strokes go through, sorted by stroke, their strokes, and squares in a row."""
    whole = opened(strokes)
    same = np.flatnonzero(np.diff(whole.owners) == 0)
    way = whole.points[same + 1] - whole.points[same]
    counts = np.ceil(2 * np.linalg.norm(way, axis=1) / size).astype(np.intp) + 1
    rows = np.repeat(np.arange(len(same)), counts)
    within = np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = within / np.maximum(counts[rows] - 1, 1)
    at = whole.points[same][rows] + share[:, None] * way[rows]
    grid = np.floor((at - at.min(axis=0)) / size).astype(np.intp) + 1
    columns = int(grid[:, 0].max()) + 2
    pairs = np.unique(np.c_[whole.owners[same][rows], grid[:, 1] * columns + grid[:, 0]], axis=0)
    return pairs[:, 1], pairs[:, 0], columns
