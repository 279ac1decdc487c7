"""The order of strokes: nothing lost, short ways, what a plot costs."""

from __future__ import annotations

from itertools import permutations, product

import numpy as np
import pytest
from illustrate_native.plot.errors import PlotError
from illustrate_native.plot.order import (
    Cost,
    Machine,
    cost,
    ends_of,
    ordered,
    passes_of,
    pen_up_segments,
    pen_up_ways,
)
from illustrate_native.plot.strokes import Strokes, make_strokes


def random_strokes(count: int, seed: int = 3) -> Strokes:
    rng = np.random.default_rng(seed)
    walks = [rng.uniform(0, 200, 2) + np.cumsum(rng.normal(0, 2, (5, 2)), 0) for _ in range(count)]
    return make_strokes(walks, closed=[i % 7 == 0 for i in range(count)], labels=range(count))


def keys(strokes: Strokes) -> list[tuple[int, frozenset[tuple[float, ...]]]]:
    """Strokes whatever their order and direction."""
    points = [map(tuple, strokes.points[strokes.span(i)].tolist()) for i in range(len(strokes))]
    return sorted(
        (int(label), frozenset(p)) for label, p in zip(strokes.labels, points, strict=True)
    )


@pytest.mark.parametrize("mode", ["shortest", "drawing", "wet"])
def test_each_order_has_every_stroke_once(mode: str) -> None:
    strokes = random_strokes(60)
    done = ordered(strokes, mode)
    assert keys(done) == keys(strokes)
    assert done.sizes.tolist() == strokes.sizes[done.labels].tolist()
    assert done.closed.tolist() == strokes.closed[done.labels].tolist()
    for i, label in enumerate(done.labels.tolist()):
        points, was = done.points[done.span(i)], strokes.points[strokes.span(label)]
        steps, before = (np.linalg.norm(np.diff(p, axis=0), axis=1) for p in (points, was))
        if not done.closed[i]:
            assert min(np.abs(steps - before).max(), np.abs(steps - before[::-1]).max()) < 1e-12


def test_the_same_strokes_come_in_the_same_order() -> None:
    a, b = (ordered(random_strokes(200)) for _ in range(2))
    assert a.points.tobytes() == b.points.tobytes()


def test_a_few_strokes_are_in_the_best_order_there_is() -> None:
    strokes = random_strokes(5, seed=11)
    strokes = make_strokes([strokes.points[strokes.span(i)] for i in range(5)])
    first, last = ends_of(strokes)
    best = np.inf
    for sequence, turned in product(permutations(range(5)), product((False, True), repeat=5)):
        starts = [last[i] if turned[i] else first[i] for i in sequence]
        stops = [first[i] if turned[i] else last[i] for i in sequence]
        way = np.array([[0.0, 0.0], *stops]) - np.array([*starts, [0.0, 0.0]])
        best = min(best, float(np.linalg.norm(way, axis=1).sum()))
    assert pen_up_ways(ordered(strokes)).sum() == pytest.approx(best)


def test_a_row_of_strokes_is_drawn_there_and_back_without_lifting() -> None:
    """Ten strokes end to end, shuffled and turned: the pen is up only to them and from them."""
    row = [[[10.0 * i, 0.0], [10.0 * i + 10.0, 0.0]][:: 1 if i % 3 else -1] for i in range(10)]
    order = np.random.default_rng(0).permutation(10)
    done = ordered(make_strokes([row[i] for i in order]))
    assert pen_up_ways(done).tolist() == [0.0] * 10 + [100.0]


def test_closed_strokes_start_where_the_pen_is() -> None:
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ring = np.c_[50 + 10 * np.cos(angle), 10 * np.sin(angle)]
    strokes = make_strokes([ring, [[0.0, 0.0], [39.0, 0.0]]], closed=[True, False])
    done = ordered(strokes)
    assert done.closed.tolist() == [False, True]
    assert done.points[done.span(1)][0] == pytest.approx((40.0, 0.0))
    assert pen_up_ways(done) == pytest.approx([0.0, 1.0, 40.0])


def test_wet_strokes_near_each_other_are_in_different_passes() -> None:
    lines = make_strokes([[[0.0, float(y)], [100.0, float(y)]] for y in range(12)])
    turns = passes_of(lines, 1.0, 4)
    assert sorted(np.bincount(turns)) == [6, 6]
    assert (turns[1:] != turns[:-1]).all()
    done = ordered(lines, "wet", 1.0, 4)
    heights = done.points[::2, 1]
    assert np.abs(np.diff(heights)).min() > 1


def test_far_strokes_are_dry_in_one_pass() -> None:
    lines = make_strokes([[[0.0, 10.0 * y], [100.0, 10.0 * y]] for y in range(12)])
    assert not passes_of(lines, 1.0, 4).any()


def test_time_is_of_ways_and_lifts() -> None:
    strokes = make_strokes([[[3.0, 4.0], [3.0, 14.0]], [[3.0, 24.0], [3.0, 25.0], [4.0, 25.0]]])
    found = cost(strokes, Machine(down_mm_s=2.0, up_mm_s=10.0, lift_s=0.5))
    up = 5.0 + 10.0 + np.hypot(4, 25)
    assert found.strokes == 2
    assert (found.down_mm, found.up_mm) == pytest.approx((12.0, up))
    assert found.seconds == pytest.approx(12 / 2 + up / 10 + 2 * 0.5)
    assert (found + Cost()) == found
    assert pen_up_segments(strokes)[1].tolist() == [[3, 14], [3, 24]]


@pytest.mark.parametrize("mode", ["shortest", "drawing", "wet"])
def test_nothing_is_in_order(mode: str) -> None:
    assert len(ordered(make_strokes([]), mode)) == 0


def test_a_thousand_strokes_are_near_the_best_known_way() -> None:
    """2-opt and Or-opt come within 10 % of the best tours; nearest first is 25 % above."""
    points = np.random.default_rng(9).uniform(0, 1, (1000, 2))
    dots = make_strokes([[p, p + 1e-9] for p in points])
    way = pen_up_ways(ordered(dots)).sum()
    assert way < 1.10 * 0.7124 * np.sqrt(1000)  # of random tours (Johnson and McGeoch 1996)


@pytest.mark.parametrize(
    ("mode", "wet_mm", "passes"), [("random", 1.0, 2), ("wet", 0.0, 2), ("wet", 1.0, 0)]
)
def test_what_is_no_order_is_refused(mode: str, wet_mm: float, passes: int) -> None:
    with pytest.raises(PlotError):
        ordered(random_strokes(3), mode, wet_mm, passes)


def test_a_machine_that_never_moves_is_refused() -> None:
    with pytest.raises(PlotError):
        Machine(down_mm_s=0.0).check()
