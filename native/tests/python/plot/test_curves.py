"""Béziers through strokes."""

from __future__ import annotations

import numpy as np
import pytest
from illustrate_native.plot.curves import Curves, fitted
from illustrate_native.plot.plans import strokes_of
from illustrate_native.plot.strokes import Floats, Strokes, make_strokes, without_repeats
from plot_drawings import torus_drawing

TOLERANCE = 0.02


def arc(radius: float, turn: float, count: int) -> Floats:
    angle = np.linspace(0, turn, count)
    return np.asarray(radius * np.c_[np.cos(angle), np.sin(angle)])


def points_on(curves: Curves, stroke: int, count: int = 64) -> Floats:
    pieces = curves.controls[curves.offsets[stroke] : curves.offsets[stroke + 1]]
    t = np.linspace(0, 1, count)[:, None]
    weights = np.hstack([(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3])
    on: Floats = np.einsum("tk,ckx->ctx", weights, pieces).reshape(-1, 2)
    return on


def distance(points: Floats, polyline: Floats) -> Floats:
    """(n,) from points to the segments of a polyline."""
    a, way = polyline[:-1], np.diff(polyline, axis=0)
    squares = np.maximum((way**2).sum(axis=1), 1e-300)
    share = ((points[:, None] - a) * way).sum(axis=2) / squares
    foot = a + share.clip(0, 1)[..., None] * way
    return np.asarray(np.linalg.norm(points[:, None] - foot, axis=2).min(axis=1))


def test_a_straight_stroke_is_one_line() -> None:
    curves = fitted(make_strokes([np.c_[np.arange(20.0), 2 * np.arange(20.0)]]), TOLERANCE)
    assert curves.straight.tolist() == [True]
    assert curves.controls[0, [0, 3]].tolist() == [[0, 0], [19, 38]]


def test_corners_stay_sharp() -> None:
    square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]
    curves = fitted(make_strokes([square], closed=True), TOLERANCE)
    assert curves.straight.tolist() == [True] * 4
    assert curves.controls[:, 0].tolist() == square
    assert curves.controls[-1, 3].tolist() == square[0]


def test_a_quarter_of_a_circle_is_one_curve() -> None:
    curves = fitted(make_strokes([arc(20.0, np.pi / 2, 60)]), TOLERANCE)
    assert curves.straight.tolist() == [False]
    off = np.linalg.norm(points_on(curves, 0), axis=1) - 20.0
    assert np.abs(off).max() < TOLERANCE


def test_a_coarse_circle_becomes_round() -> None:
    """80 chords of a circle are .015 mm from it in their middles; the curve is nearer."""
    curves = fitted(make_strokes([arc(20.0, 2 * np.pi, 81)[:-1]], closed=True), TOLERANCE)
    assert len(curves.straight) <= 8
    assert not curves.straight.any()
    off = np.linalg.norm(points_on(curves, 0), axis=1) - 20.0
    assert np.abs(off).max() < TOLERANCE / 2
    assert np.allclose(curves.controls[1:, 0], curves.controls[:-1, 3])
    assert np.allclose(curves.controls[0, 0], curves.controls[-1, 3])


def test_a_straight_stroke_that_bends_stays_straight_before() -> None:
    stroke = np.vstack([[[-60.0, 0.0]], [[0.0, 0.0]], arc(5.0, np.pi, 40)[1:] - (5.0, 0.0)])
    stroke[2:] = stroke[2:] @ np.array([[0.0, 1.0], [-1.0, 0.0]])
    curves = fitted(make_strokes([stroke]), TOLERANCE)
    on = points_on(curves, 0, 500)
    assert distance(on, stroke).max() <= 2 * TOLERANCE


@pytest.fixture(scope="module")
def torus() -> Strokes:
    strokes = without_repeats(strokes_of(torus_drawing()))
    return make_strokes(
        [0.27 * strokes.points[strokes.span(i)] for i in range(len(strokes))],
        closed=strokes.closed.tolist(),
    )


@pytest.mark.parametrize("tolerance", [0.01, 0.02, 0.1])
def test_real_strokes_are_within_the_tolerance_of_their_points(
    torus: Strokes, tolerance: float
) -> None:
    curves = fitted(torus, tolerance)
    for i in range(0, len(torus), 4):
        on, points = points_on(curves, i, 256), torus.points[torus.span(i)]
        assert np.linalg.norm(on[0] - points[0]) < 1e-12
        assert distance(points, on).max() <= tolerance * 1.01, i
        chords = np.vstack([points, points[:1]]) if torus.closed[i] else points
        assert distance(on, chords).max() <= 2.5 * tolerance, i


def test_real_strokes_need_few_pieces(torus: Strokes) -> None:
    curves = fitted(torus, TOLERANCE)
    assert len(curves.straight) < 0.2 * len(torus.points)


def test_nothing_gives_nothing() -> None:
    curves = fitted(make_strokes([]), TOLERANCE)
    assert curves.offsets.tolist() == [0]
    assert curves.controls.shape == (0, 4, 2)


def test_tolerance_nought_keeps_every_point(torus: Strokes) -> None:
    curves = fitted(torus, 0.0)
    for i in range(len(torus)):
        points = torus.points[torus.span(i)]
        pieces = slice(curves.offsets[i], curves.offsets[i + 1])
        ends = np.vstack([curves.controls[pieces, 0], curves.controls[pieces, 3]])
        assert distance(points, points_on(curves, i, 2)).max() < 1e-9
        assert distance(ends, np.vstack([points, points[:1]])).max() < 1e-9
