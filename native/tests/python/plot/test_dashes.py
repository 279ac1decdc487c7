"""Lines cut into dashes."""

from __future__ import annotations

import numpy as np
import pytest
from illustrate_native.plot.dashes import dashed
from illustrate_native.plot.strokes import lengths, make_strokes


def test_a_line_becomes_dashes_from_its_start() -> None:
    strokes = dashed(make_strokes([[[5.0, 1.0], [15.0, 1.0]]]), (2.0, 1.0))
    assert strokes.points[:, 0].tolist() == [5, 7, 8, 10, 11, 13, 14, 15]
    assert (strokes.points[:, 1] == 1).all()
    assert strokes.sizes.tolist() == [2] * 4


def test_dashes_go_round_corners_and_widths_go_on() -> None:
    line = make_strokes([[[0.0, 0.0], [3.0, 0.0], [3.0, 6.0]]], [[0.0, 3.0, 9.0]])
    strokes = dashed(line, (2.0, 1.5, 2.0, 10.0))
    assert [strokes.points[strokes.span(i)].tolist() for i in range(2)] == [
        [[0, 0], [2, 0]],
        [[3, 0.5], [3, 2.5]],
    ]
    assert strokes.widths == pytest.approx([0, 2, 3.5, 5.5])


def test_a_dash_keeps_the_points_between() -> None:
    strokes = dashed(make_strokes([[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0]]]), (2.5, 1.0))
    assert strokes.points.tolist() == [[0, 0], [1, 0], [1, 1], [1.5, 1]]


def test_closed_strokes_are_dashed_all_round_from_their_start() -> None:
    square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
    strokes = dashed(make_strokes([square], closed=True, labels=[4]), (3.0, 1.0))
    assert len(strokes) == 4
    assert not strokes.closed.any()
    assert lengths(strokes) == pytest.approx(3.0)
    assert strokes.points[-2:].tolist() == [[0, 4], [0, 1]]
    assert set(strokes.labels.tolist()) == {4}


def test_every_stroke_begins_with_a_dash() -> None:
    lines = [[[0.0, float(i)], [2.5 + i, float(i)]] for i in range(30)]
    strokes = dashed(make_strokes(lines, labels=range(30)), (2.0, 1.0))
    firsts = np.unique(strokes.labels, return_index=True)[1]
    assert (strokes.points[strokes.offsets[firsts], 0] == 0).all()
    total = [
        sum(min(2.0, 2.5 + i - 3 * k) for k in range(20) if 2.5 + i > 3 * k) for i in range(30)
    ]
    sums = np.bincount(strokes.labels, lengths(strokes))
    assert sums == pytest.approx(total)


def test_no_pattern_leaves_all_as_it_is() -> None:
    strokes = make_strokes([[[0.0, 0.0], [9.0, 0.0]]])
    assert dashed(strokes, ()) is strokes
