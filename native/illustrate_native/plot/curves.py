"""Cubic Béziers through strokes: fewer numbers, round where the drawing is round.

Least squares for the two inner points, better parameters by Newton's steps, and a cut in the middle
where the curve is still too far, after Schneider, "An algorithm for automatically fitting digitized
curves", Graphics Gems (1990), who keeps tangents and cuts at the worst point, which takes more
pieces. All pieces of a round are fitted at once.

The points of a stroke lie on the line that it stands for, its segments are chords of it. So the
curve is within the tolerance of the points, and between them rounder than the chords by at most as
much again.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .strokes import Flags, Floats, Indices, Strokes, opened

CORNER_DEG = 50.0  # a stroke that turns more at a point has a corner there
SAMPLES = 3  # of each segment that the curve is held to
NEWTON_STEPS = 3  # for the distances that count
REFITS = 5  # more shorten files by little
WEIGHT_ALONG = 0.001  # of squares of distances along the curve
LEAST_DETERMINANT = 1e-15  # below it the samples say too little of the inner points


@dataclass(frozen=True)
class Curves:
    """c pieces of s strokes, one after another; each begins where the one before ends."""

    controls: Floats  # (c, 4, 2) Bézier points; of lines a third apart
    straight: Flags  # (c,) a line from the first to the last
    offsets: Indices  # (s + 1,): stroke i is pieces[offsets[i]:offsets[i + 1]]
    closed: Flags  # (s,)


def fitted(strokes: Strokes, tolerance_mm: float) -> Curves:
    """Curves within the tolerance of strokes, which have at least two points and none repeated."""
    fit = _Fit(opened(strokes), tolerance_mm)
    starts, ends = fit.between_corners()
    done: list[tuple[Indices, Floats, Flags]] = []
    while len(starts):
        controls, straight, cuts = fit.pieces(starts, ends)
        good = cuts < 0
        done.append((starts[good], controls[good], straight[good]))
        left, right, middle = starts[~good], ends[~good], cuts[~good]
        starts, ends = np.concatenate([left, middle]), np.concatenate([middle, right])
    return _in_order(done, fit.owners, strokes.closed)


def _in_order(done: list[tuple[Indices, Floats, Flags]], owners: Indices, closed: Flags) -> Curves:
    starts = np.concatenate([np.zeros(0, np.intp), *(part[0] for part in done)])
    order = np.argsort(starts)
    counts = np.bincount(owners[starts], minlength=len(closed))
    return Curves(
        np.concatenate([np.zeros((0, 4, 2)), *(part[1] for part in done)])[order],
        np.concatenate([np.zeros(0, bool), *(part[2] for part in done)])[order],
        np.concatenate([[0], np.cumsum(counts)]).astype(np.intp),
        closed,
    )


class _Fit:
    """The points to be fitted and what pieces need of them."""

    def __init__(self, whole: Strokes, tolerance_mm: float) -> None:
        self._tolerance = tolerance_mm
        corner = _corners(whole)
        before = _sources(whole)
        self._points = _samples(whole, corner, before, tolerance_mm)
        self._is_point = np.diff(before, prepend=-1) != 0
        self._corner = self._is_point & corner[before]
        self.owners = whole.owners[before]
        self._bounds = np.flatnonzero(np.diff(self.owners, prepend=-1, append=-1))
        steps = np.linalg.norm(np.diff(self._points, axis=0, prepend=self._points[:1]), axis=1)
        self._along = np.cumsum(steps)

    def between_corners(self) -> tuple[Indices, Indices]:
        """First and last points of the pieces to begin with."""
        cut = self._corner.copy()
        cut[self._bounds[:-1]] = cut[self._bounds[1:] - 1] = True
        at = np.flatnonzero(cut)
        same = self.owners[at[:-1]] == self.owners[at[1:]]
        return at[:-1][same], at[1:][same]

    def pieces(self, starts: Indices, ends: Indices) -> tuple[Floats, Flags, Indices]:
        """Curves (c, 4, 2), whether they are lines, and where to cut those too far off, or -1."""
        rows = _Rows(starts, ends)
        points, along = self._points[rows.points], self._along[rows.points]
        done, left = along - self._along[starts][rows.piece], self._along[ends][rows.piece] - along
        lines = _lines(self._points[starts], self._points[ends])
        u = done / (done + left)
        off_line = np.linalg.norm(_bezier(lines[rows.piece], u) - points, axis=1)
        straight = rows.greatest(off_line) <= self._tolerance
        straight |= ends - starts <= SAMPLES
        controls, off = _closest(lines, rows, points, u)
        good = straight | (rows.greatest(off) <= self._tolerance)
        controls[straight] = lines[straight]
        middle = np.where(self._is_point[rows.points] & rows.is_inner, done * left, -1.0)
        return controls, straight, np.where(good, -1, rows.points[rows.where_greatest(middle)])


class _Rows:
    """The points of pieces, one piece after another."""

    def __init__(self, starts: Indices, ends: Indices) -> None:
        sizes = ends - starts + 1
        self._first = np.cumsum(sizes) - sizes
        self.piece = np.repeat(np.arange(len(starts)), sizes)
        within = np.arange(sizes.sum()) - self._first[self.piece]
        self.points = starts[self.piece] + within
        self.is_inner = (within > 0) & (within < sizes[self.piece] - 1)

    def sums(self, values: Floats) -> Floats:
        """(c,) over each piece."""
        total: Floats = np.add.reduceat(values, self._first)
        return total

    def greatest(self, values: Floats) -> Floats:
        """(c,) of each piece."""
        most: Floats = np.maximum.reduceat(values, self._first)
        return most

    def where_greatest(self, values: Floats) -> Indices:
        """(c,) the first row of each piece that has its greatest value."""
        is_most = np.flatnonzero(values == self.greatest(values)[self.piece])
        _, first = np.unique(self.piece[is_most], return_index=True)
        rows: Indices = is_most[first]
        return rows


def _closest(lines: Floats, rows: _Rows, points: Floats, u: Floats) -> tuple[Floats, Floats]:
    """Béziers between the ends of lines that come closest to points, and how far off each is.

    First by least squares at parameters that go with the length along; then by the squares of the
    distances across the curve, those along it having next to no weight.
    """
    across = np.tile([1.0, 0.0, 1.0], (len(u), 1))
    controls = _least_squares(lines, rows, points, u, across)
    for _ in range(REFITS):
        u = _better(controls[rows.piece], points, u)
        across = _across(_unit(_velocity(controls[rows.piece], u)))
        controls = _least_squares(lines, rows, points, u, across)
    for _ in range(NEWTON_STEPS):
        u = _better(controls[rows.piece], points, u)
    return controls, np.linalg.norm(_bezier(controls[rows.piece], u) - points, axis=1)


def _across(along: Floats) -> Floats:
    """(r, 3) entries xx, xy, yy of what weighs offsets across directions, a little those along."""
    x, y = along.T
    rest = 1 - WEIGHT_ALONG
    return np.stack([1 - rest * x * x, -rest * x * y, 1 - rest * y * y], axis=1)


def _least_squares(
    lines: Floats, rows: _Rows, points: Floats, u: Floats, weights: Floats
) -> Floats:
    """Béziers of given ends whose two inner points fit best; lines where they are not told."""
    b = _weights(u)
    rest = points - b[:, :1] * lines[rows.piece, 0] - b[:, 3:] * lines[rows.piece, 3]
    squares = np.stack([b[:, 1] * b[:, 1], b[:, 1] * b[:, 2], b[:, 2] * b[:, 2]], axis=1)
    m = rows.sums(squares[:, :, None] * weights[:, None, :])[:, [[0, 1], [1, 2]]]
    m = m[..., [[0, 1], [1, 2]]].transpose(0, 1, 3, 2, 4).reshape(-1, 4, 4)
    w = weights[:, [[0, 1], [1, 2]]]
    pulled = np.einsum("rij,rj->ri", w, rest)
    right = rows.sums(b[:, 1:3, None] * pulled[:, None, :]).reshape(-1, 4, 1)
    is_sound = np.linalg.det(m) > LEAST_DETERMINANT
    m[~is_sound] = np.eye(4)
    controls = lines.copy()
    controls[is_sound, 1:3] = np.linalg.solve(m, right).reshape(-1, 2, 2)[is_sound]
    return controls


def _corners(whole: Strokes) -> Flags:
    """(p,) points where the two sides have tangents of their own, ends of open strokes too."""
    before, after = _steps(whole.points, whole.offsets, whole.closed)
    cosine = np.einsum("ij,ij->i", _unit(before), _unit(after))
    corner: Flags = cosine < np.cos(np.deg2rad(CORNER_DEG))
    corner[whole.offsets[:-1]] |= ~whole.closed
    corner[whole.offsets[1:] - 1] |= ~whole.closed
    return corner


def _sources(whole: Strokes) -> Indices:
    """The point at which the segment of each sample begins; a stroke's last point is a sample."""
    counts = np.full(len(whole.points), SAMPLES)
    counts[whole.offsets[1:] - 1] = 1
    return np.repeat(np.arange(len(whole.points)), counts)


def _samples(whole: Strokes, corner: Flags, source: Indices, leeway_mm: float) -> Floats:
    """Points on a smooth curve through the points of strokes, within the leeway of chords."""
    first = np.flatnonzero(np.diff(source, prepend=-1))
    share = (np.arange(len(source)) - first[source]) / SAMPLES
    target = np.minimum(source + 1, len(whole.points) - 1)
    chords = whole.points[target] - whole.points[source]
    curve = _bezier(_arcs(whole, corner)[source], share)
    straight = whole.points[source] + share[:, None] * chords
    off = curve - straight
    far = np.linalg.norm(off, axis=1, keepdims=True)
    return np.asarray(straight + off * np.minimum(1.0, leeway_mm / np.maximum(far, 1e-300)))


def _arcs(whole: Strokes, corner: Flags) -> Floats:
    """(p, 4, 2) a Bézier from each point to the next, about an arc; at corners as at its end."""
    before, after = _steps(whole.points, whole.offsets, whole.closed)
    smooth = _unit(_through(before, after))
    following = np.minimum(np.arange(len(corner)) + 1, len(corner) - 1)
    chord = _unit(after)
    mirrored = (2 * np.einsum("ij,ij->i", smooth, chord))[:, None] * chord - smooth
    leave = np.where(corner[:, None], chord, smooth)
    reach = np.where(corner[following][:, None], chord, smooth[following])
    back = 2 * np.einsum("ij,ij->i", reach, chord)[:, None] * chord - reach
    leave = np.where((corner & ~corner[following])[:, None], back, leave)
    reach = np.where((~corner & corner[following])[:, None], mirrored, reach)
    arm = np.linalg.norm(after, axis=1)[:, None] / 3
    start, end = whole.points, whole.points + after
    return np.stack([start, start + arm * leave, end - arm * reach, end], axis=1)


def _steps(points: Floats, offsets: Indices, is_closed: Flags) -> tuple[Floats, Floats]:
    """Steps (p, 2) to each point and from it; closed strokes go on at their ends."""
    steps = np.diff(points, axis=0)
    before = np.concatenate([steps[:1], steps])
    after = np.concatenate([steps, steps[-1:]])
    first, last = offsets[:-1], offsets[1:] - 1
    closed = is_closed[:, None]
    before[first] = np.where(closed, before[last], after[first])
    after[last] = np.where(closed, after[first], before[last])
    return before, after


def _through(before: Floats, after: Floats) -> Floats:
    """Along the circle through a point and those at the ends of the two steps."""
    return before / _squares(before) + after / _squares(after)


def _squares(vectors: Floats) -> Floats:
    squares: Floats = np.maximum(np.einsum("ij,ij->i", vectors, vectors), 1e-300)[:, None]
    return squares


def _unit(vectors: Floats) -> Floats:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0))


def _lines(start: Floats, end: Floats) -> Floats:
    return np.stack([start + (end - start) * k / 3 for k in range(4)], axis=1)


def _weights(u: Floats) -> Floats:
    """(r, 4) Bernstein's polynomials."""
    v = 1 - u
    return np.stack([v**3, 3 * v * v * u, 3 * v * u * u, u**3], axis=1)


def bezier(controls: Floats, u: Floats) -> Floats:
    """(n, 2) points of one Bézier (4, 2) at parameters (n,)."""
    return np.asarray(_weights(u) @ controls)


def _bezier(controls: Floats, u: Floats) -> Floats:
    return np.asarray(np.einsum("ij,ijk->ik", _weights(u), controls))


def _velocity(controls: Floats, u: Floats) -> Floats:
    steps = np.diff(controls, axis=1)
    v, w = (1 - u)[:, None], u[:, None]
    velocity: Floats = 3 * (v * v * steps[:, 0] + 2 * v * w * steps[:, 1] + w * w * steps[:, 2])
    return velocity


def _better(controls: Floats, points: Floats, u: Floats) -> Floats:
    """Parameters nearer to the feet of the points, by a step of Newton's."""
    bends = np.diff(controls, 2, axis=1)
    velocity = _velocity(controls, u)
    turn = 6 * ((1 - u)[:, None] * bends[:, 0] + u[:, None] * bends[:, 1])
    off = _bezier(controls, u) - points
    slope = np.einsum("ij,ij->i", velocity, velocity) + np.einsum("ij,ij->i", off, turn)
    step = np.einsum("ij,ij->i", off, velocity)
    moved = u - np.divide(step, slope, out=np.zeros_like(step), where=slope > 0)
    return np.asarray(np.clip(moved, 0.0, 1.0))
