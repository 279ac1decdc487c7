"""Pens, and which strokes each of them draws."""

from __future__ import annotations

from dataclasses import replace

import pytest
from illustrate_native.line_groups import line_groups
from illustrate_native.plot.errors import PlotError
from illustrate_native.plot.pens import (
    FEATURES,
    HATCHES,
    HIDDEN,
    OUTLINES,
    Layer,
    Pen,
    check_pens,
    layers_of,
    pens_by_line,
)
from illustrate_native.plot.strokes import Subject, make_strokes
from plot_drawings import drawing_of_every_kind

LINE = [[0.0, 0.0], [1.0, 0.0]]
CUP = Subject("Silhouette", "Cup", ("Tableware", "Kitchen"), "Clay")
FLOOR = Subject("Hatch", "Floor", ("House",))
BEHIND = Subject("Hidden", "Cup", ("Tableware",))
STROKES = make_strokes([LINE] * 4, labels=[0, 1, 1, 2], subjects=(CUP, FLOOR, BEHIND))


@pytest.mark.parametrize(
    ("choice", "taken"),
    [
        ({}, (True, True, True)),
        ({"kinds": ("Hatch", "Hidden")}, (False, True, True)),
        ({"objects": ("Cup",)}, (True, False, True)),
        ({"collections": ("Kitchen",)}, (True, False, False)),
        ({"materials": ("Clay",)}, (True, False, False)),
        ({"objects": ("Cup",), "kinds": ("Hidden",)}, (False, False, True)),
    ],
)
def test_a_pen_takes_what_all_its_choices_have(
    choice: dict[str, tuple[str, ...]], taken: tuple[bool, ...]
) -> None:
    pen = Pen("One", 0.3, **choice)  # type: ignore[arg-type]
    assert tuple(pen.takes(subject) for subject in (CUP, FLOOR, BEHIND)) == taken


def test_a_stroke_is_drawn_by_the_first_pen_that_takes_it() -> None:
    layers, warnings = layers_of(STROKES, [Pen("Hatching", 0.2, kinds=("Hatch",)), Pen("All", 1)])
    assert [(layer.number, layer.strokes.labels.tolist()) for layer in layers] == [
        (1, [1, 1]),
        (2, [0, 2]),
    ]
    assert warnings == []


def test_pens_without_strokes_and_strokes_without_a_pen_are_said() -> None:
    layers, warnings = layers_of(
        STROKES, [Pen("Red", 0.2, kinds=("Mark",)), Pen("Blue", 0.2, kinds=("Silhouette",))]
    )
    assert [layer.pen.name for layer in layers] == ["Blue"]
    assert layers[0].number == 2
    assert warnings == [
        "no pen takes Hatch: 2 strokes are not drawn",
        "no pen takes Hidden: 1 strokes are not drawn",
        "pen 'Red' has nothing to draw: there is no layer of it",
    ]


@pytest.mark.parametrize(
    ("changes", "label"),
    [
        ({}, "3 Outline"),
        ({"pauses": True}, "!3 Outline"),
        ({"is_plotted": False}, "%3 Outline"),
        ({"pauses": True, "is_plotted": False}, "!%3 Outline"),
    ],
)
def test_layers_are_called_as_axidraw_reads_them(changes: dict[str, bool], label: str) -> None:
    assert Layer(Pen("Outline", 0.3, **changes), 3, STROKES).label == label  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("pen", "words"),
    [
        (Pen("Thin", 0.0), "pen 'Thin' has no width"),
        (Pen("Odd", float("nan")), "no width"),
        (Pen(" ", 0.3), "no name"),
        (Pen("Red", 0.3, "red"), "colour 'red'"),
        (Pen("Far", 0.3, number=1001), "0-1000"),
        (Pen("Half", 0.3, dashes_mm=(1.0,)), "odd number"),
        (Pen("Gaps", 0.3, dashes_mm=(0.0, 1.0)), "no length"),
    ],
)
def test_what_nothing_can_be_drawn_with_is_refused(pen: Pen, words: str) -> None:
    with pytest.raises(PlotError, match=words):
        check_pens([Pen("Good", 0.3), pen])


def test_there_is_a_pen_at_least() -> None:
    with pytest.raises(PlotError, match="no pens"):
        check_pens([])


def test_pens_by_line_know_every_group_of_lines_once() -> None:
    drawing = drawing_of_every_kind()
    titles = {group.title for group in line_groups(drawing)}
    known = [*OUTLINES, *FEATURES, *HATCHES, *HIDDEN]
    assert sorted(titles) == sorted(known)
    for title in titles:
        takers = [pen for pen in pens_by_line(0.7, 0.5, 0.3) if pen.takes(Subject(title))]
        assert len(takers) == 1, title


def test_layers_keep_the_order_of_pens_and_own_numbers() -> None:
    pens = [replace(pen, number=10 + i) for i, pen in enumerate(pens_by_line(0.7, 0.5, 0.3))]
    layers, _ = layers_of(STROKES, pens)
    assert [layer.label for layer in layers] == ["10 Hidden", "11 Hatching", "13 Outline"]
