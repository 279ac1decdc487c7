"""SVG files of drawings whose strokes are known."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from drawings import Stroke, drawing_of
from illustrate_native.line_groups import KIND_NAMES, line_groups
from illustrate_native.svg import to_svg

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"

LINE = (
    ill.Kind.SILHOUETTE,
    [(10.0, 20.0), (30.0, 20.004), (30.0, 45.5)],
    [1.0, 2.0, 3.0],
    False,
    0,
)
LOOP = (ill.Kind.HATCH, [(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)], [2.0, 2.0, 2.0], True, 0)
BEHIND = (ill.Kind.CREASE, [(1.0, 1.0), (2.0, 2.0)], [0.5, 0.5], False, 2)


def groups_of(text: str) -> dict[str, ElementTree.Element]:
    root = ElementTree.fromstring(text.encode())
    return {group.attrib[INKSCAPE + "label"]: group for group in root.iter(SVG + "g")}


def path_of(strokes: list[Stroke], **options: Any) -> ElementTree.Element:
    [group] = groups_of(to_svg(drawing_of(strokes), 400, 300, **options)).values()
    return group[0]


def outline(data: str) -> np.ndarray[Any, Any]:
    """Points of the closed polygon of a path, arcs as chords."""
    data = re.sub(r"A\S+ 0 0 1 ", "L", data)
    return np.array(
        [[float(x) for x in pair.split(",")] for pair in re.findall(r"[-\d.]+,[-\d.]+", data)]
    )


def signed_area(points: np.ndarray[Any, Any]) -> float:
    x, y = points.T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def test_names_of_kinds_are_those_of_the_module() -> None:
    for number, name in enumerate(KIND_NAMES):
        assert int(getattr(ill.Kind, name)) == number
    assert set(ill.Kind.__members__) == set(KIND_NAMES)


def test_page_has_its_size_in_millimetres_and_pixels_inside() -> None:
    root = ElementTree.fromstring(to_svg(drawing_of([LINE]), 400, 300, 120).encode())
    assert (root.attrib["width"], root.attrib["height"]) == ("120mm", "90mm")
    assert root.attrib["viewBox"] == "0 0 400 300"


def test_one_group_per_kind_from_the_bottom_to_the_top() -> None:
    text = to_svg(drawing_of([LINE, LOOP, BEHIND, LINE]), 400, 300)
    groups = groups_of(text)
    assert list(groups) == ["Hidden", "Hatch", "Silhouette"]
    assert [len(group) for group in groups.values()] == [1, 1, 2]
    assert {group.attrib[INKSCAPE + "groupmode"] for group in groups.values()} == {"layer"}
    assert [group.attrib["id"] for group in groups.values()] == ["hidden", "hatch", "silhouette"]


def test_every_kind_but_the_seam_has_a_group() -> None:
    strokes: list[Stroke] = [(getattr(ill.Kind, name), *LINE[1:]) for name in KIND_NAMES]
    groups = line_groups(drawing_of(strokes))
    drawn = [i for i, name in enumerate(KIND_NAMES) if name != "SEAM"]
    assert sorted(i for group in groups for i in group.strokes) == drawn
    assert [g.title for g in groups if g.is_hatching] == ["Undercut", "Cross-hatch", "Hatch"]


def test_centre_lines_are_as_wide_as_their_strokes_on_average() -> None:
    path = path_of([LINE])
    assert path.attrib == {"stroke-width": "2.06", "d": "M10,20 30,20 30,45.5"}
    assert path_of([LOOP]).attrib["d"] == "M0,0 10,0 0,10Z"


def test_centre_lines_have_the_ink_of_their_strokes() -> None:
    """However unevenly the points lie along them: most of these are in a thin tail."""
    points = [(0.0, 0.0), (90.0, 0.0), *((90.0 + k, 0.0) for k in range(1, 11))]
    widths = [4.0, 4.0, *np.linspace(3.6, 0, 10)]
    path = path_of([(ill.Kind.HATCH, points, widths, False, 0)])
    assert float(path.attrib["stroke-width"]) == pytest.approx((90 * 4 + 10 * 2) / 100)
    ring = [(0.0, 0.0), (30.0, 0.0), (30.0, 10.0), (0.0, 10.0)]
    path = path_of([(ill.Kind.HATCH, ring, [1.0, 1.0, 2.0, 2.0], True, 0)])
    assert float(path.attrib["stroke-width"]) == pytest.approx((30 + 15 + 60 + 15) / 80)
    dot = path_of([(ill.Kind.HATCH, [(5.0, 5.0)], [3.0], False, 0)])
    assert dot.attrib["stroke-width"] == "3"


def test_tapered_outline_of_a_straight_stroke() -> None:
    straight = (
        ill.Kind.SILHOUETTE,
        [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)],
        [1.0, 4.0, 1.0],
        False,
        0,
    )
    path = path_of([straight], style="tapered")
    assert "stroke-width" not in path.attrib
    points = outline(path.attrib["d"])
    assert abs(signed_area(points)) == pytest.approx(20 * 2.5)
    assert sorted(set(points[:, 1])) == [-2, -0.5, 0.5, 2]


def test_caps_bulge_outwards() -> None:
    straight = (ill.Kind.SILHOUETTE, [(0.0, 0.0), (10.0, 0.0)], [4.0, 4.0], False, 0)
    data = path_of([straight], style="tapered").attrib["d"]
    # From (10, -2) over (12, 0) to (10, 2), y down: the positive sweep.
    assert data == "M0,-2 10,-2A2,2 0 0 1 10,2L10,2 0,2A2,2 0 0 1 0,-2Z"


def test_tapered_outline_of_a_loop_is_a_ring() -> None:
    turn = 2 * np.pi * np.arange(64) / 64
    circle = [(100 + 50 * float(np.cos(t)), 100 + 50 * float(np.sin(t))) for t in turn]
    data = path_of([(ill.Kind.HATCH, circle, [2.0] * 64, True, 0)], style="tapered").attrib["d"]
    rings = [outline(ring) for ring in data.split("Z") if ring]
    radii = sorted(float(np.linalg.norm(ring - 100, axis=1).mean()) for ring in rings)
    assert radii == pytest.approx([49, 51], abs=0.02)
    assert (
        signed_area(rings[0]) * signed_area(rings[1]) < 0
    )  # wound against each other: the inside stays white


def test_corners_do_not_reach_farther_than_twice() -> None:
    spike = (ill.Kind.HATCH, [(0.0, 0.0), (50.0, 0.0), (0.0, 0.5)], [2.0] * 3, False, 0)
    assert outline(path_of([spike], style="tapered").attrib["d"])[:, 0].max() <= 52


@pytest.mark.parametrize("style", ["centerline", "tapered"])
def test_odd_strokes_give_finite_numbers(style: str) -> None:
    strokes: list[Stroke] = [
        (ill.Kind.HATCH, [(5.0, 5.0)], [1.0], False, 0),
        (ill.Kind.HATCH, [(5.0, 5.0), (5.0, 5.0)], [1.0, 0.0], False, 0),
        (ill.Kind.HATCH, [(5.0, 5.0), (9.0, 5.0), (5.0, 5.0)], [1.0] * 3, True, 0),
        (ill.Kind.HATCH, [(-0.001, -0.001), (1e-9, 3.0)], [1.0] * 2, False, 0),
        (ill.Kind.HATCH, [], [], False, 0),
    ]
    text = to_svg(drawing_of(strokes), 400, 300, style=style)
    paths = re.findall(r'<path .*d="(.*)"', text)
    assert len(paths) == 4
    for data in paths:
        assert re.fullmatch(r"[MLAZ\d., -]+", data)
        assert "-0," not in data
        assert not data.endswith("-0")


def test_no_strokes_give_an_empty_page() -> None:
    assert not groups_of(to_svg(drawing_of([]), 400, 300))


def test_same_drawing_same_text() -> None:
    assert to_svg(drawing_of([LINE, LOOP]), 400, 300) == to_svg(drawing_of([LINE, LOOP]), 400, 300)


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ((400, 300, 0.0), "width_mm"),
        ((400, 300, float("nan")), "width_mm"),
        ((0, 300, 200.0), "image"),
        ((400, 300, 200.0, "dotted"), "style"),
    ],
)
def test_wrong_arguments_are_named(arguments: Any, name: str) -> None:
    with pytest.raises(ValueError, match=name):
        to_svg(drawing_of([LINE]), *arguments)
