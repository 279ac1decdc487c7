"""Paper, how pictures lie on it, and what is cut off at its margins."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from illustrate_native.plot.errors import PlotError
from illustrate_native.plot.pages import (
    FORMATS,
    Box,
    box_of,
    cropped,
    make_page,
    place,
    placed,
    read_paper,
)
from illustrate_native.plot.strokes import lengths, make_strokes

BOX: Box = (0.0, 0.0, 10.0, 10.0)
FRAME: Box = (0.0, 0.0, 400.0, 300.0)


def lines_of(strokes: Any) -> list[list[list[float]]]:
    return [strokes.points[strokes.span(i)].round(9).tolist() for i in range(len(strokes))]


def test_each_format_of_a_series_halves_the_one_before() -> None:
    for i in range(6):
        larger, smaller = FORMATS[f"A{i}"], FORMATS[f"A{i + 1}"]
        assert smaller[1] == larger[0]
        assert math.floor(larger[1] / 2) == smaller[0]


@pytest.mark.parametrize(
    ("orientation", "is_wide", "size"),
    [
        ("portrait", True, (210, 297)),
        ("landscape", False, (297, 210)),
        ("auto", True, (297, 210)),
        ("auto", False, (210, 297)),
    ],
)
def test_pages_lie_as_asked(orientation: str, is_wide: bool, size: tuple[float, float]) -> None:
    page = make_page("A4", orientation, is_wide=is_wide)
    assert (page.width_mm, page.height_mm) == size


def test_own_paper_stays_as_it_is_unless_turned() -> None:
    assert make_page((150, 100), "auto", is_wide=False).width_mm == 150
    assert make_page((150, 100), "portrait").width_mm == 100


@pytest.mark.parametrize(("text", "paper"), [("150x100", (150.0, 100.0)), ("letter", "Letter")])
def test_paper_is_read(text: str, paper: str | tuple[float, float]) -> None:
    assert read_paper(text) == paper


def test_the_inside_the_outside_and_what_is_printed() -> None:
    page = make_page((100, 50), "auto", (1.0, 2.0, 0.0, 4.0), bleed_mm=3.0)
    boxes = [page.inner, page.outer, page.printed]
    assert boxes == [
        (1, 2, 100, 46),
        (-3, -3, 103, 53),
        (1, 2, 103, 46),
    ]  # the bleed only where there is no margin


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"paper": "A4", "margin_mm": 105.0}, "no room between its margins"),
        ({"paper": (10, 10), "margin_mm": (4.0, 0.0, 6.0, 0.0)}, "no room between its margins"),
        ({"paper": "A9"}, "'A9'"),
        ({"paper": (0, 10)}, "0 x 10 mm"),
        ({"paper": "A4", "orientation": "askew"}, "'askew'"),
        ({"paper": "A4", "margin_mm": -1.0}, "at least 0"),
        ({"paper": "A4", "bleed_mm": math.inf}, "finite"),
    ],
)
def test_what_is_no_page_is_refused(arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(PlotError, match=words):
        make_page(**arguments)


@pytest.mark.parametrize("text", ["A9", "10x", "10x20x30", "-1x5"])
def test_what_is_no_paper_is_refused(text: str) -> None:
    with pytest.raises(PlotError):
        read_paper(text)


def test_a_picture_fits_into_the_margins_in_the_middle() -> None:
    page = make_page((120, 220), "auto", 10.0)  # 100 x 200 inside
    placing = place(page, FRAME)
    assert placing.scale == 0.25
    assert placing.shift_mm == (10.0, 110.0 - 37.5)


def test_a_picture_fills_the_page_and_its_bleed() -> None:
    page = make_page((94, 94), "auto", 0.0, bleed_mm=3.0)
    placing = place(page, FRAME, "fill")
    assert placing.scale == pytest.approx(100 / 300)
    assert placing.shift_mm == pytest.approx((47 - 400 / 6, -3))


def test_lines_fit_into_the_margins() -> None:
    page = make_page((120, 120), "auto", 10.0)
    placing = place(page, FRAME, "lines", (100.0, 50.0, 300.0, 100.0))
    assert placing.scale == 0.5
    assert placing.shift_mm == (10 - 50, 60 - 37.5)


def test_at_scale_a_pixel_is_what_it_is_said_to_be() -> None:
    placing = place(make_page("A4", "landscape"), FRAME, "scale", scale=0.7)
    assert placing.scale == 0.7
    assert placing.shift_mm == pytest.approx((148.5 - 140, 105 - 105))
    strokes = placed(make_strokes([[[0, 0], [400, 300]]], 2.0), placing)
    assert strokes.points == pytest.approx(np.array([[8.5, 0], [288.5, 210]]))
    assert strokes.widths == pytest.approx(1.4)


def test_without_lines_the_frame_is_what_is_placed() -> None:
    page = make_page((120, 120), "auto", 10.0)
    nothing = box_of(make_strokes([]))
    assert nothing is None
    assert place(page, FRAME, "lines", nothing) == place(page, FRAME)


@pytest.mark.parametrize(("fit", "scale"), [("scale", 0.0), ("scale", math.nan), ("stretch", 1.0)])
def test_what_is_no_fit_is_refused(fit: str, scale: float) -> None:
    with pytest.raises(PlotError):
        place(make_page("A4"), FRAME, fit, scale=scale)


def test_what_lies_inside_is_the_same_object() -> None:
    strokes = make_strokes([[[0, 0], [10, 10]]])
    assert cropped(strokes, BOX) is strokes


def test_a_stroke_is_cut_where_it_leaves_and_where_it_returns() -> None:
    strokes = make_strokes([[[5, 5], [15, 5], [15, 8], [5, 8]]], [[1.0, 3.0, 3.0, 1.0]])
    left = cropped(strokes, BOX)
    assert lines_of(left) == [[[5, 5], [10, 5]], [[10, 8], [5, 8]]]
    assert left.widths.tolist() == [1, 2, 2, 1]


def test_a_stroke_that_only_passes_is_kept_between() -> None:
    left = cropped(make_strokes([[[-5, 5], [15, 5]], [[-5, -1], [15, -1]]]), BOX)
    assert lines_of(left) == [[[0, 5], [10, 5]]]


def test_closed_strokes_that_leave_are_opened_without_a_seam() -> None:
    ring = [[5, 5], [15, 5], [15, 8], [5, 8]]
    left = cropped(make_strokes([ring], closed=True), BOX)
    assert lines_of(left) == [[[10, 8], [5, 8], [5, 5], [10, 5]]]
    assert left.closed.tolist() == [False]


def test_closed_strokes_inside_stay_closed_and_in_order() -> None:
    ring = [[1, 1], [2, 1], [2, 2]]
    strokes = make_strokes([[[5, 5], [15, 5]], ring], closed=[False, True], labels=[3, 7])
    left = cropped(strokes, BOX)
    assert left.closed.tolist() == [False, True]
    assert left.labels.tolist() == [3, 7]
    assert lines_of(left)[1] == ring


def test_a_circle_larger_than_the_box_leaves_its_four_arcs() -> None:
    angle = np.linspace(0, 2 * np.pi, 4000, endpoint=False)
    circle = 5 + 6 * np.c_[np.cos(angle), np.sin(angle)]
    left = cropped(make_strokes([circle], closed=True), BOX)
    assert len(left) == 4
    arc = np.pi / 2 - 2 * math.acos(5 / 6)
    assert lengths(left) == pytest.approx(6 * arc, rel=1e-3)
    assert ((left.points >= 0) & (left.points <= 10)).all()


def test_many_random_strokes_keep_their_length_inside() -> None:
    rng = np.random.default_rng(5)
    walks = [np.cumsum(rng.normal(0, 3, (30, 2)), axis=0) + 5 for _ in range(50)]
    whole = make_strokes(walks, closed=[bool(i % 2) for i in range(50)])
    left = cropped(whole, BOX)
    fine = 2000
    inside = 0.0
    for i, walk in enumerate(walks):
        ends = np.vstack([walk, walk[:1]]) if i % 2 else walk
        share = (np.arange(fine) + 0.5)[:, None] / fine
        for a, b in pairwise(ends):
            at = (1 - share) * a + share * b
            within = ((at >= 0) & (at <= 10)).all(axis=1).mean()
            inside += within * float(np.linalg.norm(b - a))
    assert lengths(left).sum() == pytest.approx(inside, rel=1e-3)
