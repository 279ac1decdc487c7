"""Closed areas of drawings: what is seen of each object."""

from __future__ import annotations

import io
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from illustrate_native.plot import PlotError, PlotOptions, file_of, plot_of, strokes_of
from illustrate_native.plot.pages import Placing
from illustrate_native.plot.regions import (
    NOTHING,
    Region,
    Seen,
    objects_at,
    placed_regions,
    regions_of,
    seen_from,
)
from plot_drawings import HEIGHT_PX, WIDTH_PX, camera, torus_mesh

pytest.importorskip("shapely", reason="shapely is not installed")


def square(middle: tuple[float, float], half: float) -> Any:
    return np.array(middle) + half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)


def seen_squares(*squares: tuple[Any, float]) -> Seen:
    """Squares with their nearness, two triangles each, numbered as objects."""
    corners = np.array([s[[0, i, i + 1]] for s, _ in squares for i in (1, 2)])
    near = np.repeat([near for _, near in squares], 2)
    return Seen(corners, np.tile(near[:, None], 3), np.repeat(np.arange(len(squares)), 2))


def test_the_nearest_triangle_is_seen() -> None:
    seen = seen_squares((square((20, 20), 10), 1.0), (square((28, 20), 5), 2.0))
    points = np.array([[15.0, 20], [25, 20], [31, 20], [40, 20], [12, 12], [500, 3]])
    assert objects_at(points, seen).tolist() == [0, 1, 1, NOTHING, 0, NOTHING]


def graph_of(*loops: Any, hidden: int = 0) -> Any:
    """Closed arcs; the last `hidden` ones have a layer in front."""
    sizes = [len(loop) for loop in loops]
    return SimpleNamespace(
        arc_invisibility=np.array([0] * (len(loops) - hidden) + [1] * hidden),
        arc_nodes=np.full((len(loops), 2), -1),
        arc_offsets=np.cumsum([0, *sizes]),
        arc_image=np.concatenate(loops),
    )


def test_a_square_before_another_makes_a_hole_in_it() -> None:
    large, small = square((50, 50), 30), square((50, 50), 10)
    seen = seen_squares((large, 1.0), (small, 2.0))
    first, second = regions_of(graph_of(large, small), seen, 100, 100)
    assert (first.object, second.object) == (0, 1)
    assert [len(polygon) for polygon in first.polygons] == [2]
    assert first.area == pytest.approx(60 * 60 - 20 * 20)
    assert second.area == pytest.approx(20 * 20)


def test_regions_end_at_the_frame_and_ignore_hidden_lines() -> None:
    large, behind = square((0, 50), 30), square((10, 50), 5)
    seen = seen_squares((large, 2.0), (behind, 1.0))
    [region] = regions_of(graph_of(large, behind, hidden=1), seen, 100, 100)
    assert region.area == pytest.approx(30 * 60)
    assert [len(polygon) for polygon in region.polygons] == [1]


def test_neighbours_share_their_border() -> None:
    left, right = square((40, 50), 10), square((55, 50), 10)
    seen = seen_squares((left, 1.0), (right, 2.0))
    first, second = regions_of(graph_of(left, right), seen, 100, 100)
    assert first.area + second.area == pytest.approx(2 * 400 - 5 * 20)
    border = {tuple(p) for p in first.polygons[0][0]} & {tuple(p) for p in second.polygons[0][0]}
    assert {(45.0, 40.0), (45.0, 60.0)} <= border


@pytest.fixture(scope="module")
def scene() -> tuple[Any, Any]:
    """Two tori, the second one through and before the first; and their drawing."""
    second = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], float)
    meshes = [torus_mesh(), torus_mesh(second * 0.7, (0.6, -1.0, 0.3))]
    prepared = ill.prepare(meshes)
    return prepared, ill.draw(prepared, camera(), ill.DrawOptions())


def test_real_regions_have_the_area_of_the_pixels_that_are_covered(scene: tuple[Any, Any]) -> None:
    prepared, drawing = scene
    eye = camera()
    seen = seen_from(prepared.surface, eye.projection, eye.view, WIDTH_PX, HEIGHT_PX)
    regions = regions_of(drawing.graph, seen, WIDTH_PX, HEIGHT_PX)
    assert [region.object for region in regions] == [0, 1]
    covered = (np.asarray(drawing.tone.level) != 255).sum() * drawing.tone.cell_px**2
    assert sum(region.area for region in regions) == pytest.approx(covered, rel=0.002)
    column, row = np.meshgrid(np.arange(2.5, WIDTH_PX, 5), np.arange(2.5, HEIGHT_PX, 5))
    shown = objects_at(np.c_[column.ravel(), row.ravel()], seen)
    for region in regions:
        assert region.area == pytest.approx(25 * (shown == region.object).sum(), rel=0.01)


def test_regions_are_placed_and_cut_at_the_margin() -> None:
    ring, hole = square((10, 10), 8), square((10, 10), 2)
    region = Region(3, ((ring, hole),), "Cup", "#00ff00")
    [cut] = placed_regions([region], Placing(2.0, (5.0, 0.0)), (0.0, 0.0, 25.0, 100.0))
    assert (cut.object, cut.name, cut.colour) == (3, "Cup", "#00ff00")
    assert cut.area == pytest.approx(16 * 32 - 4 * 8)
    assert placed_regions([region], Placing(2.0, (500.0, 0.0)), (0.0, 0.0, 25.0, 100.0)) == ()


def test_svg_and_pdf_fill_them_below_the_lines(scene: tuple[Any, Any]) -> None:
    prepared, drawing = scene
    eye = camera()
    seen = seen_from(prepared.surface, eye.projection, eye.view, WIDTH_PX, HEIGHT_PX)
    colours = ("#ff0000", "#00ff00")
    regions = [
        replace(region, name=f"Ring {region.object}", colour=colours[region.object])
        for region in regions_of(drawing.graph, seen, WIDTH_PX, HEIGHT_PX)
    ]
    plot = plot_of(strokes_of(drawing), WIDTH_PX, HEIGHT_PX, PlotOptions(), regions)
    root = ElementTree.fromstring(file_of("svg", [plot]))
    first = next(e for e in root if e.tag.endswith("}g"))
    assert [path.get("fill") for path in first] == list(colours)
    assert {path.get("fill-rule") for path in first} == {"evenodd"}
    svgelements: Any = pytest.importorskip("svgelements", reason="svgelements is not installed")
    box = svgelements.Path(first[1].get("d")).bbox()
    points = np.concatenate([ring for polygon in plot.regions[1].polygons for ring in polygon])
    assert box == pytest.approx([*points.min(axis=0), *points.max(axis=0)], abs=0.01)
    pypdf: Any = pytest.importorskip("pypdf", reason="pypdf is not installed")
    reader = pypdf.PdfReader(io.BytesIO(file_of("pdf", [plot])))
    content = reader.pages[0].get_contents().get_data().decode()
    assert content.count(" f*") == 2
    layers = reader.trailer["/Root"]["/OCProperties"]["/D"]["/Order"]
    assert [layer.get_object()["/Name"] for layer in layers] == ["%Regions", "1 All"]


def test_without_shapely_there_is_one_message(monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    ring = square((50, 50), 30)
    with pytest.raises(PlotError, match="Filling regions needs the Python package shapely"):
        regions_of(graph_of(ring), seen_squares((ring, 1.0)), 100, 100)
