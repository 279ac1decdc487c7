"""Closed areas of drawings: what is seen of each object."""

from __future__ import annotations

import io
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from drawings import drawing_of
from illustrate_native.plot import (
    PlotError,
    PlotOptions,
    file_of,
    mask_names,
    mask_of,
    plot_of,
    strokes_of,
)
from illustrate_native.plot.dxf_file import dxf_of
from illustrate_native.plot.masks import coverage
from illustrate_native.plot.pages import Placing
from illustrate_native.plot.regions import Region, cut_open, placed_regions, regions_of, turn
from illustrate_native.plot.seen import NOTHING, Seen, seen_from, triangles_at
from illustrate_native.png import to_png
from illustrate_native.svg import to_svg
from plot_drawings import HEIGHT_PX, WIDTH_PX, camera, torus_mesh

pytest.importorskip("shapely", reason="shapely is not installed")


def square(middle: tuple[float, float], half: float) -> Any:
    return np.array(middle) + half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)


def seen_squares(*squares: tuple[Any, float]) -> Seen:
    """Squares with their nearness, two triangles each, numbered as objects."""
    corners = np.array([s[[0, i, i + 1]] for s, _ in squares for i in (1, 2)])
    near = np.repeat([near for _, near in squares], 2)
    objects = np.repeat(np.arange(len(squares)), 2)
    return Seen(corners, np.tile(near[:, None], 3), objects, np.zeros_like(objects))


def objects_at(points: Any, seen: Seen) -> Any:
    found = triangles_at(points, seen)
    return np.where(found == NOTHING, NOTHING, seen.objects[found])


def test_the_nearest_triangle_is_seen() -> None:
    seen = seen_squares((square((20, 20), 10), 1.0), (square((28, 20), 5), 2.0))
    points = np.array([[15.0, 20], [25, 20], [31, 20], [40, 20], [12, 12], [500, 3]])
    assert objects_at(points, seen).tolist() == [0, 1, 1, NOTHING, 0, NOTHING]


def graph_of(*loops: Any, hidden: int = 0) -> Any:
    """Closed arcs; the last `hidden` ones have a layer in front."""
    sizes = [len(loop) for loop in loops]
    return SimpleNamespace(
        arc_layers_over=np.array([0] * (len(loops) - hidden) + [1] * hidden),
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


def test_materials_of_an_object_are_regions_of_their_own() -> None:
    """A square of two triangles; the border between them is no line of the drawing."""
    ring = square((50, 50), 30)
    whole = seen_squares((ring, 1.0))
    painted = replace(whole, materials=np.array([4, 7]), borders=ring[None, [0, 2]])
    first, second = regions_of(graph_of(ring), painted, 100, 100)
    assert [(r.object, r.material) for r in (first, second)] == [(0, 4), (0, 7)]
    assert [first.area, second.area] == pytest.approx([1800, 1800])
    plain = replace(whole, borders=ring[None, [0, 2]])
    [region] = regions_of(graph_of(ring), plain, 100, 100)
    assert region.area == pytest.approx(3600)


def test_borders_lie_where_materials_meet() -> None:
    prepared = ill.prepare([torus_mesh()], ill.PrepareOptions())
    surface, eye = prepared.surface, camera()
    halves = (surface.triangle_faces >= 128).astype(int)  # quads in order round the ring
    view = (eye.projection, eye.view, WIDTH_PX, HEIGHT_PX)
    seen = seen_from(surface, *view, halves)
    ends = {tuple(p) for p in np.round(seen.borders.reshape(-1, 2), 6)}
    assert len(seen.borders) == len(ends) >= 32  # two closed rims, where y is 0
    positions = np.asarray(surface.positions)
    rims = positions[np.abs(positions[:, 1]) < 1e-9]
    clip = np.c_[rims, np.ones(len(rims))] @ (eye.projection @ eye.view).T
    image = (clip[:, :2] / clip[:, 3:] * (1, -1) + 1) / 2 * (WIDTH_PX, HEIGHT_PX)
    assert ends == {tuple(p) for p in np.round(image, 6)}
    assert not len(seen_from(surface, *view).borders)


def test_what_is_seen_through_is_no_region() -> None:
    meshes = [torus_mesh(), torus_mesh(None, (0.0, 0.0, 1.0))]
    surface, eye = ill.prepare(meshes).surface, camera()
    view = (eye.projection, eye.view, WIDTH_PX, HEIGHT_PX)
    both = seen_from(surface, *view)
    assert set(seen_from(surface, *view, see_through=[1]).objects) == {0} < set(both.objects)


def test_a_polygon_is_cut_open_to_its_holes() -> None:
    places = [(10 * i, 10 * j) for i in range(1, 5) for j in range(1, 5)]
    holes = [square(place, 3) for place in places]
    outer = square((25, 25), 25)
    ring = cut_open((outer, *(hole[::-1] if i % 2 else hole for i, hole in enumerate(holes))))
    assert abs(turn(ring)) / 2 == pytest.approx(50 * 50 - 16 * 36)
    corners = {tuple(point) for rings in (outer, *holes) for point in rings}
    assert corners <= {tuple(point) for point in ring}
    shapely: Any = pytest.importorskip("shapely", reason="shapely is not installed")
    polygon = shapely.polygons(outer, [square(place, 2.999) for place in places])
    assert polygon.covers(shapely.linearrings(ring))  # no cut crosses a hole or leaves
    assert cut_open((outer,)) is outer


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
    corner = np.array([(13, 3), (17, 3), (15, 6)], float)  # holes need not have as many points
    several = Region(0, ((ring, hole, corner),))
    [placed] = placed_regions([several], Placing(1.0, (0.0, 0.0)), (0.0, 0.0, 25.0, 100.0))
    assert len(placed.polygons[0]) == 3
    assert placed.area == pytest.approx(16 * 16 - 4 * 4 - 6)


COLOURS = ("#ff0000", "#00ff00")


def coloured_plot(prepared: Any, drawing: Any) -> Any:
    eye = camera()
    seen = seen_from(prepared.surface, eye.projection, eye.view, WIDTH_PX, HEIGHT_PX)
    regions = [
        replace(region, name=f"Ring {region.object}", colour=COLOURS[region.object])
        for region in regions_of(drawing.graph, seen, WIDTH_PX, HEIGHT_PX)
    ]
    return plot_of(strokes_of(drawing), WIDTH_PX, HEIGHT_PX, PlotOptions(), regions)


def test_svg_and_pdf_fill_them_below_the_lines(scene: tuple[Any, Any]) -> None:
    plot = coloured_plot(*scene)
    root = ElementTree.fromstring(file_of("svg", [plot]))
    first = next(e for e in root if e.tag.endswith("}g"))
    assert [path.get("fill") for path in first] == list(COLOURS)
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


@pytest.mark.parametrize("version", ["R12", "R2000"])
def test_dxf_has_them_on_layers_of_their_own(version: str) -> None:
    ezdxf: Any = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    prepared = ill.prepare([torus_mesh(), torus_mesh(None, (0.0, 2.5, 0.5))])
    plot = coloured_plot(prepared, ill.draw(prepared, camera(), ill.DrawOptions()))
    assert max(len(polygon) for region in plot.regions for polygon in region.polygons) > 1
    document = ezdxf.read(io.StringIO(dxf_of(plot, version).decode("cp1252")))
    assert not document.audit().errors
    for region, colour in zip(plot.regions, (1, 3), strict=True):
        name = f"Fill {region.name}"
        name = name.upper().replace(" ", "_") if version == "R12" else name
        assert document.layers.get(name).dxf.color == colour
        found = document.modelspace().query(f'*[layer=="{name}"]')
        rings = [ring for polygon in region.polygons for ring in polygon]
        if version == "R12":
            assert [len(polyline) for polyline in found] == [len(ring) for ring in rings]
            continue
        paths = [path for hatch in found for path in hatch.paths]
        assert [len(hatch.paths) for hatch in found] == [len(p) for p in region.polygons]
        for path, ring in zip(paths, rings, strict=True):
            points = np.array([(x, 210 - y) for x, y, _ in path.vertices])
            assert np.abs(points - ring).max() < 0.001
        areas = [abs(turn(np.array([v[:2] for v in path.vertices]))) / 2 for path in paths]
        signs = [1 if path.path_type_flags & 1 else -1 for path in paths]
        assert np.dot(areas, signs) == pytest.approx(region.area, rel=1e-3)


def test_masks_cover_exactly_the_area() -> None:
    ring, hole = square((10.3, 9.7), 8.25), square((11, 10), 2.5)
    tilted = np.array([(30.5, 2.25), (38.75, 11.5), (31.1, 17.9)])
    region = Region(0, ((ring, hole[::-1]), (tilted,)))
    cover = coverage(region, 40, 20)
    assert cover.sum() == pytest.approx(region.area)
    assert cover[10, 11] == 0 and cover[3, 8] == 1
    assert cover[9, 2] == pytest.approx(1 - 0.05)  # the left side is at 2.05
    assert cover[1, 5] == pytest.approx(1 - 0.45)  # the upper one at 1.45
    whole = Region(0, ((np.array([(0, 0), (40, 0), (40, 20), (0, 20)], float),),))
    assert (coverage(whole, 40, 20) == 1).all()


def test_a_mask_is_a_grey_png_with_a_name_of_its_own() -> None:
    region = Region(0, ((square((10, 10), 4),),), "Cup/1")
    data = mask_of(region, 30, 20)
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert data[16:26] == (30).to_bytes(4, "big") + (20).to_bytes(4, "big") + b"\x08\x00"
    grey = pixels_of(data, 1)[..., 0]
    expected = np.zeros((20, 30))
    expected[6:14, 6:14] = 255
    assert (grey == expected).all()
    names = ["Cup/1", "cup:1", "cup_1_2", "Pot"]
    assert list(mask_names([replace(region, name=name) for name in names], "x")) == [
        "x_mask_Cup_1.png", "x_mask_cup_1_2.png", "x_mask_cup_1_2_2.png", "x_mask_Pot.png",
    ]  # fmt: skip


def test_a_drawing_in_pixels_is_filled_below_its_lines() -> None:
    left, right = square((10, 10), 4.25), square((18.5, 10), 4.25)
    regions = [
        Region(0, ((left, square((10, 10), 2)),), "Left & all", "#ff0000"),
        Region(1, ((right,),), "Right", "#0000ff"),
    ]
    line = drawing_of([(ill.Kind.SILHOUETTE, [(0.0, 10.0), (30.0, 10.0)], [2.0, 2.0], False, 0)])
    root = ElementTree.fromstring(to_svg(line, 30, 20, regions=regions).encode())
    first, second = (e for e in root if e.tag.endswith("}g"))
    assert [(path.get("fill"), path.get("fill-rule")) for path in first] == [
        ("#ff0000", "evenodd"), ("#0000ff", "evenodd"),
    ]  # fmt: skip
    assert first[0].get("d", "").count("M") == 2 and second.get("id") == "silhouette"
    colours = ((255, 0, 0, 255), (0, 0, 255, 255))
    fills = [(coverage(r, 30, 20), c) for r, c in zip(regions, colours, strict=True)]
    picture = pixels_of(to_png(line, 30, 20, fills=fills), 3)
    assert picture[6, 8].tolist() == [255, 0, 0] and picture[6, 20].tolist() == [0, 0, 255]
    assert picture[8, 10].tolist() == picture[2, 2].tolist() == [255, 255, 255]  # the hole, paper
    assert picture[10, 8].max() < 10
    assert picture[6, 14].tolist() == [64, 0, 191]  # half and half, no paper between
    clear = pixels_of(to_png(line, 30, 20, paper=(255, 255, 255, 0), fills=fills), 4)
    assert clear[6, 8].tolist() == [255, 0, 0, 255] and clear[2, 2, 3] == 0


def pixels_of(data: bytes, channels: int) -> Any:
    """(20, 30, channels) of a PNG of the project's own."""
    at = data.index(b"IDAT")
    rows = zlib.decompress(data[at + 4 : at + 4 + int.from_bytes(data[at - 4 : at], "big")])
    return np.frombuffer(rows, np.uint8).reshape(20, 1 + 30 * channels)[:, 1:].reshape(20, 30, -1)


def test_without_shapely_there_is_one_message(monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    ring = square((50, 50), 30)
    with pytest.raises(PlotError, match="Filling regions needs the Python package shapely"):
        regions_of(graph_of(ring), seen_squares((ring, 1.0)), 100, 100)
