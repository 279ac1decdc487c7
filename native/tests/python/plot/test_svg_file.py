"""SVG files of plots, read back by the programs that plot them."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from illustrate_native.plot import Pen, Plot, PlotOptions, pens_by_line, plot_of, strokes_of, svg_of
from illustrate_native.plot.errors import PlotError
from illustrate_native.plot.order import ordered, pen_up_ways
from illustrate_native.plot.plans import Thing
from illustrate_native.plot.strokes import Strokes, Subject, lengths, make_strokes
from illustrate_native.svg import read_made_by, to_svg
from plot_drawings import HEIGHT_PX, PAPERS, WIDTH_PX, drawing_of_every_kind, torus_drawing

vpype: Any = pytest.importorskip("vpype", reason="vpype is not installed")
svgelements: Any = pytest.importorskip("svgelements", reason="svgelements is not installed")

ISO_PENS = tuple(pens_by_line(0.7, 0.35, 0.18))
PX_PER_MM = 96 / 25.4


def torus_plot(**options: Any) -> Plot:
    chosen = {"pens": ISO_PENS, **options}
    return plot_of(strokes_of(torus_drawing()), WIDTH_PX, HEIGHT_PX, PlotOptions(**chosen))


def read_by_vpype(text: str, path: Path, step_mm: float = 0.05) -> Any:
    path.write_text(text, encoding="utf-8")
    return vpype.read_multilayer_svg(str(path), quantization=step_mm * PX_PER_MM)


def polylines(layer: Strokes) -> list[Any]:
    points = [layer.points[layer.span(i)] for i in range(len(layer))]
    return [
        np.vstack([p, p[:1]]) if closed else p
        for p, closed in zip(points, layer.closed.tolist(), strict=True)
    ]


def as_complex(points: Any) -> Any:
    return points @ np.array([1, 1j])


def farthest(points: Any, line: Any) -> float:
    """From complex points to a complex polyline, over all points."""
    a, way = line[:-1], np.diff(line)
    share = ((points[:, None] - a) * way.conj()).real / np.maximum(np.abs(way) ** 2, 1e-300)
    return float(np.abs(points[:, None] - a - share.clip(0, 1) * way).min(axis=1).max())


@pytest.mark.parametrize("options", PAPERS)
def test_vpype_reads_the_same_strokes_pens_and_millimetres(
    options: dict[str, Any], tmp_path: Path
) -> None:
    plot = torus_plot(**options)
    document = read_by_vpype(svg_of(plot), tmp_path / "torus.svg")
    left, top, right, bottom = plot.page.outer
    assert document.page_size == pytest.approx(
        ((right - left) * PX_PER_MM, (bottom - top) * PX_PER_MM)
    )
    assert sorted(document.layers) == [layer.number for layer in plot.layers]
    for layer in plot.layers:
        read = document.layers[layer.number]
        assert read.property("vp_name") == layer.label
        assert read.property("vp_pen_width") == pytest.approx(layer.pen.width_mm * PX_PER_MM)
        assert read.property("vp_color") == vpype.Color(layer.pen.colour)
        drawn = polylines(layer.strokes)
        assert len(read.lines) == len(drawn)
        for line, points in zip(read.lines, drawn, strict=True):
            back = line / PX_PER_MM + complex(left, top)
            ends = as_complex(points[[0, -1]])
            assert np.abs(back[[0, -1]] - ends).max() < 0.01
            assert farthest(as_complex(points), back) < 0.0205


@pytest.mark.parametrize("options", PAPERS)
def test_svgelements_reads_the_same_curves_and_nothing_twice(
    options: dict[str, Any], tmp_path: Path
) -> None:
    plot = torus_plot(**options)
    path = tmp_path / "torus.svg"
    path.write_text(svg_of(plot), encoding="utf-8")
    svg = svgelements.SVG.parse(str(path), ppi=25.4)
    left, top, right, bottom = plot.page.outer
    assert (svg.width, svg.height) == pytest.approx((right - left, bottom - top))
    paths = [e for e in svg.elements() if isinstance(e, svgelements.Path)]
    strokes = [line for layer in plot.layers for line in polylines(layer.strokes)]
    assert len(paths) == len(strokes)
    for read, points in zip(paths, strokes, strict=True):
        parts = [part for part in read if not isinstance(part, svgelements.Move)]
        begin, end = (complex(*points[at]) - complex(left, top) for at in (0, -1))
        assert abs(complex(read.first_point) - begin) < 0.01
        assert abs(complex(read.current_point) - end) < 0.01
        for part in parts:
            if not isinstance(part, svgelements.Close):
                assert abs(complex(part.start) - complex(part.end)) > 0.005
    assert any(isinstance(part, svgelements.CubicBezier) for read in paths for part in read)


def test_layers_carry_names_and_one_width_each() -> None:
    plot = torus_plot(pens=tuple(replace(pen, pauses=True) for pen in ISO_PENS))
    root = ElementTree.fromstring(svg_of(plot).encode())
    groups = [e for e in root if e.tag.endswith("}g")]
    inkscape = "{http://www.inkscape.org/namespaces/inkscape}"
    assert [g.get(inkscape + "label") for g in groups] == ["!1 Hidden", "!2 Hatching", "!4 Outline"]
    assert {g.get(inkscape + "groupmode") for g in groups} == {"layer"}
    assert [g.get("stroke-width") for g in groups] == ["0.35", "0.18", "0.7"]
    assert all(set(path.attrib) == {"d"} for g in groups for path in g)
    assert len({g.get("id") for g in groups}) == len(groups)


def test_files_are_at_most_a_third_of_those_in_pixels() -> None:
    drawing = torus_drawing()
    plot = torus_plot(pens=tuple(replace(pen, dashes_mm=()) for pen in ISO_PENS))
    assert len(svg_of(plot)) < len(to_svg(drawing, WIDTH_PX, HEIGHT_PX)) / 3


def test_our_order_is_as_good_as_that_of_vpype(tmp_path: Path) -> None:
    pen = (Pen("All", 0.3),)
    plot = torus_plot(pens=pen)
    path = tmp_path / "drawing.svg"
    path.write_text(svg_of(torus_plot(pens=pen, order="drawing")), encoding="utf-8")
    sort = "linemerge linesort --two-opt reloop"
    command = [*VPYPE, "read", str(path), *sort.split(), "stat"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    theirs = [line for line in text.splitlines() if "Pen-up length" in line][-1]
    ours = pen_up_ways(plot.layers[0].strokes)[1:-1].sum()  # vpype counts no way from home
    assert ours <= 1.1 * float(theirs.split()[-1]) / PX_PER_MM


VPYPE = [sys.executable, "-c", "from vpype_cli import cli; cli()"]


@pytest.mark.parametrize("device", ["hpgl", "gcode"])
def test_vpype_makes_hpgl_and_gcode(tmp_path: Path, device: str) -> None:
    """The commands of docs/plot.md."""
    plot = torus_plot(pens=(Pen("All", 0.3),))
    read = ["read", str(tmp_path / "torus.svg")]
    (tmp_path / "torus.svg").write_text(svg_of(plot), encoding="utf-8")
    out = tmp_path / f"torus.{device}"
    write = {
        "hpgl": ["write", "--device", "hp7475a", "--page-size", "a4", "--landscape", str(out)],
        "gcode": ["gwrite", "--profile", "gcodemm", str(out)],
    }[device]
    subprocess.run([*VPYPE, *read, *write], check=True, capture_output=True)
    text = out.read_text()
    downs = {"hpgl": text.count("PD"), "gcode": text.count("G00")}[device]
    assert downs >= len(plot.layers[0].strokes)


def test_every_kind_of_line_has_its_layer() -> None:
    pens = pens_by_line(0.7, 0.5, 0.3)
    plot = plot_of(strokes_of(drawing_of_every_kind()), 400, 300, PlotOptions(pens=tuple(pens)))
    assert [layer.label for layer in plot.layers] == [
        "1 Hidden",
        "2 Hatching",
        "3 Features",
        "4 Outline",
    ]
    assert [len(layer.strokes) for layer in plot.layers][1:] == [3, 11, 2]
    length = 200 * 190 / 300
    assert lengths(plot.layers[3].strokes) == pytest.approx(length)
    dashes = lengths(plot.layers[0].strokes)
    assert dashes.max() == pytest.approx(2.0)
    assert dashes.sum() == pytest.approx(2.0 * length / 3, abs=2.0)


def test_objects_collections_and_materials_choose_pens() -> None:
    drawing = drawing_of_every_kind()
    materials = np.array(["Clay"] * 3 + ["Glass"] * (len(drawing.kinds) - 3))
    strokes = strokes_of(drawing, [Thing("Cup", ("Kitchen",))], materials)
    assert {subject.object for subject in strokes.subjects} == {"Cup"}
    pens = (Pen("Clay", 0.3, materials=("Clay",)), Pen("Kitchen", 0.3, collections=("Kitchen",)))
    plot = plot_of(strokes, 400, 300, PlotOptions(pens=pens))
    assert [len(layer.strokes) for layer in plot.layers] == [3, len(drawing.kinds) - 3]


def test_tapered_pens_fill_outlines() -> None:
    line = make_strokes([[[100.0, 100.0], [300.0, 100.0]]], [[0.0, 20.0]])
    pen = Pen("Brush", 0.3, "#aa0000", is_tapered=True)
    plot = plot_of(line, 400, 300, PlotOptions(paper=(40, 30), margin_mm=0.0, pens=(pen,)))
    root = ElementTree.fromstring(svg_of(plot).encode())
    [group] = (e for e in root if e.tag.endswith("}g"))
    assert (group.get("fill"), group.get("stroke")) == ("#aa0000", "none")
    box = svgelements.Path(group[0].get("d")).bbox()
    assert box == pytest.approx((10, 9, 31, 11), abs=0.02)


def test_tapered_pens_fill_dashes_that_go_on_widening() -> None:
    line = make_strokes([[[100.0, 100.0], [300.0, 100.0]]], [[0.0, 20.0]])
    pen = Pen("Brush", 0.3, is_tapered=True, dashes_mm=(5.0, 5.0))
    plot = plot_of(line, 400, 300, PlotOptions(paper=(40, 30), margin_mm=0.0, pens=(pen,)))
    root = ElementTree.fromstring(svg_of(plot).encode())
    [group] = (e for e in root if e.tag.endswith("}g"))
    boxes = sorted(svgelements.Path(path.get("d")).bbox() for path in group)
    assert [box[0] for box in boxes] == pytest.approx([10, 19.5], abs=0.02)
    assert [box[3] - box[1] for box in boxes] == pytest.approx([0.5, 1.5], abs=0.02)


@pytest.mark.parametrize("marks", [{"pauses": True}, {"is_plotted": False}])
def test_vpype_knows_the_numbers_of_marked_layers(marks: dict[str, bool], tmp_path: Path) -> None:
    plot = torus_plot(pens=tuple(replace(pen, **marks) for pen in ISO_PENS))  # type: ignore[arg-type]
    document = read_by_vpype(svg_of(plot), tmp_path / "marked.svg")
    assert {i: layer.property("vp_name") for i, layer in document.layers.items()} == {
        layer.number: layer.label for layer in plot.layers
    }


def test_bleed_widens_the_sheet_and_not_the_place(tmp_path: Path) -> None:
    line = make_strokes([[[0.0, 0.0], [400.0, 300.0]]])
    options = PlotOptions(paper=(40, 30), margin_mm=0.0, bleed_mm=3.0)
    document = read_by_vpype(svg_of(plot_of(line, 400, 300, options)), tmp_path / "bleed.svg")
    assert document.page_size == pytest.approx((46 * PX_PER_MM, 36 * PX_PER_MM))
    [read] = document.layers[1].lines
    assert read[[0, -1]] / PX_PER_MM == pytest.approx([3 + 3j, 43 + 33j], abs=0.01)


def test_how_it_was_made_is_read_back() -> None:
    made_by = {"version": "1", "frame": 3, "name": "<&>"}
    assert read_made_by(svg_of(torus_plot(), made_by)) == made_by


def test_the_same_plot_gives_the_same_bytes() -> None:
    assert svg_of(torus_plot()) == svg_of(torus_plot())


def test_nothing_shorter_than_a_dot_is_left() -> None:
    dots = make_strokes(
        [[[0.0, 0.0], [0.01, 0.0]], [[5.0, 5.0], [5.0, 5.0]], [[9.0, 9.0], [99.0, 9.0]]]
    )
    [layer] = plot_of(dots, 400, 300, PlotOptions()).layers
    assert len(layer.strokes) == 1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"margin_mm": 150.0}, "no room between its margins"),
        ({"pens": (Pen("Thin", 0.0),)}, "no width"),
        ({"pens": (Pen("Marks", 0.3, kinds=("Mark",)),)}, "nothing to plot"),
        ({"tolerance_mm": -1.0}, "at least 0"),
        ({"fit": "scale"}, "scale"),
    ],
)
def test_what_cannot_be_plotted_is_said_once(options: dict[str, Any], words: str) -> None:
    with pytest.raises(PlotError, match=words):
        torus_plot(**options)


def test_lines_that_all_lie_outside_of_the_page_cannot_be_plotted() -> None:
    options = PlotOptions(pens=ISO_PENS, paper="A4", fit="scale", scale=1.0)
    outside = make_strokes([[[900, 0], [950, 9]]], subjects=(Subject("Outline"),))
    with pytest.raises(PlotError, match="nothing to plot"):
        plot_of(outside, 100, 100, options)


def test_the_pen_travels_from_and_to_its_home_for_each_layer_that_is_plotted() -> None:
    strokes = make_strokes(
        [[[0, 0], [50, 0]], [[50, 9], [0, 9]]],
        labels=[0, 1],
        subjects=(Subject("Outline"), Subject("Hatch")),
    )
    lines = Pen("Lines", 0.3, kinds=("Outline",))
    for is_plotted in (True, False):
        hatches = Pen("Hatches", 0.3, kinds=("Hatch",), is_plotted=is_plotted)
        plot = plot_of(strokes, 100, 100, PlotOptions(pens=(lines, hatches)))
        layers = [layer.strokes.points for layer in plot.layers if layer.pen.is_plotted]
        assert len(layers) == 1 + is_plotted
        for ways, points in zip(plot.travel(), layers, strict=True):
            assert ways.tolist() == [[[0, 0], [*points[0]]], [[*points[-1]], [0, 0]]]


def test_two_thousand_strokes_take_seconds() -> None:
    """An exact count of the work stands for the time: the tour is left to rest within it."""
    rng = np.random.default_rng(2)
    starts = rng.uniform(0, 200, (2000, 2))
    strokes = make_strokes(
        [np.cumsum(np.vstack([s, rng.normal(0, 0.4, (9, 2))]), 0) for s in starts]
    )
    assert pen_up_ways(ordered(strokes)).sum() < 0.05 * pen_up_ways(strokes).sum()
