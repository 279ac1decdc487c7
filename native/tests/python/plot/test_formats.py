"""PDF, DXF and animations of plots, read back and rendered by other programs."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from illustrate_native.plot import (
    Pen,
    Plot,
    PlotError,
    PlotOptions,
    file_of,
    make_strokes,
    pdf_file,
    pens_by_line,
    plot_of,
    strokes_of,
)
from illustrate_native.plot.animation import animated_svg_of
from illustrate_native.plot.dxf_file import dxf_of
from illustrate_native.plot.formats import check, read_made_by
from illustrate_native.plot.pdf_file import POINTS_PER_MM, pdf_of
from plot_drawings import HEIGHT_PX, PAPERS, WIDTH_PX, torus_drawing

pypdf: Any = pytest.importorskip("pypdf", reason="pypdf is not installed")
ezdxf: Any = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
PENS = tuple(pens_by_line(0.7, 0.35, 0.18))
DPI = 100


def torus_plot(**options: Any) -> Plot:
    chosen = {"pens": PENS, **options}
    return plot_of(strokes_of(torus_drawing()), WIDTH_PX, HEIGHT_PX, PlotOptions(**chosen))


def line_plot(**options: Any) -> Plot:
    """A line of 200 mm, .5 mm wide, 50 mm from the top of A4 lying."""
    strokes = make_strokes([[[38.5, 40.0], [238.5, 40.0]]])
    chosen = {"pens": (Pen("Ink", 0.5, "#0000ff"),), "fit": "scale", "scale": 1.0, **options}
    return plot_of(strokes, 277, 190, PlotOptions(**chosen))


def rendered(pdf: bytes, folder: Path, page: int = 1, dpi: int = DPI) -> Any:
    """(h, w, 3) in [0, 255] of a page, by pdftoppm."""
    if not shutil.which("pdftoppm"):
        pytest.skip("pdftoppm is not installed")
    path = folder / "page.pdf"
    path.write_bytes(pdf)
    command = ["pdftoppm", "-r", str(dpi), "-f", str(page), "-singlefile", str(path)]
    data = subprocess.run(command, check=True, capture_output=True).stdout
    kind, width, height, _ = data.split(maxsplit=4)[:4]
    assert kind == b"P6"
    pixels = np.frombuffer(data[-int(width) * int(height) * 3 :], np.uint8)
    return pixels.reshape(int(height), int(width), 3)


def test_a_pdf_is_the_page_with_its_boxes_and_layers() -> None:
    plot = torus_plot(margin_mm=0.0, bleed_mm=3.0)
    reader = pypdf.PdfReader(io.BytesIO(pdf_of([plot])))
    [page] = reader.pages
    size = [float(side) / POINTS_PER_MM for side in page.mediabox]
    assert size == pytest.approx([0, 0, 303, 216])
    trim = [float(side) / POINTS_PER_MM for side in page.trimbox]
    assert trim == pytest.approx([3, 3, 300, 213], abs=1e-3)
    layers = reader.trailer["/Root"]["/OCProperties"]["/D"]["/Order"]
    assert [layer.get_object()["/Name"] for layer in layers] == [
        layer.label for layer in plot.layers
    ]
    content = page.get_contents().get_data().decode()
    assert content.count(" m ") == sum(len(layer.strokes) for layer in plot.layers)
    assert content.count("BDC") == content.count("EMC") == len(plot.layers)


def test_pdftoppm_shows_a_line_at_its_millimetres(tmp_path: Path) -> None:
    pixels = rendered(pdf_of([line_plot()]), tmp_path, dpi=254)
    assert pixels.shape[:2] == pytest.approx((2100, 2970), abs=1)
    ink = np.argwhere(pixels[..., 0] < 128)
    (top, left), (bottom, right) = ink.min(axis=0), ink.max(axis=0) + 1
    # From 48.5 mm, with round caps, and .5 mm high about 50 mm, at 10 pixels a millimetre.
    assert [left, right] == pytest.approx([485 - 2.5, 2485 + 2.5], abs=1.5)
    assert [top, bottom] == pytest.approx([500 - 2.5, 500 + 2.5], abs=1.5)
    assert pixels[500, 1000].tolist() == [0, 0, 255]


@pytest.mark.parametrize("options", PAPERS)
def test_poppler_reads_the_same_strokes_and_millimetres(
    options: dict[str, Any], tmp_path: Path
) -> None:
    """pdftocairo writes paths as they are in the file, in our units, with a matrix for the page."""
    if not shutil.which("pdftocairo"):
        pytest.skip("pdftocairo is not installed")
    plot = torus_plot(**options)
    (tmp_path / "torus.pdf").write_bytes(pdf_of([plot]))
    names = [str(tmp_path / f"torus.{end}") for end in ("pdf", "svg")]
    subprocess.run(["pdftocairo", "-svg", *names], check=True)
    paths = [e for e in ElementTree.parse(names[1]).iter() if e.tag.endswith("}path")]
    drawn = [(layer, i) for layer in plot.layers for i in range(len(layer.strokes))]
    for path, (layer, i) in zip(paths, drawn, strict=True):
        data = path.get("d", "")
        points = np.array(re.findall(r"-?[\d.]+", data), float).reshape(-1, 2)
        strokes = layer.strokes
        ends = strokes.points[strokes.span(i)][[0, 0 if strokes.closed[i] else -1]]
        assert np.abs(points[[0, -1]] - ends).max() < 0.01
        assert ("Z" in data) == strokes.closed[i]
        assert f"stroke-width:{layer.pen.width_mm:g};" in path.get("style", "")


def sampled(line: Any) -> Any:
    """Points of a complex polyline, .2 apart."""
    along = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(line)))])
    at = np.arange(0.0, along[-1], 0.2)
    return np.interp(at, along, line.real) + 1j * np.interp(at, along, line.imag)


def test_pdf_and_svg_are_one_picture(tmp_path: Path) -> None:
    """The points that vpype reads of the SVG are dark in the PDF, and there is no other ink."""
    vpype = pytest.importorskip("vpype", reason="vpype is not installed")
    plot = torus_plot()
    path = tmp_path / "torus.svg"
    path.write_bytes(file_of("svg", [plot]))
    dark = rendered(pdf_of([plot]), tmp_path).min(axis=2) < 250
    lines = vpype.read_svg(str(path), quantization=0.2)[0]
    points = np.concatenate([sampled(line) for line in lines]) * DPI / 96
    column, row = (np.floor(v).astype(int) for v in (points.real, points.imag))
    assert dark[row, column].mean() > 0.99
    near = np.zeros_like(dark)
    for across in range(-3, 4):
        for down in range(-3, 4):
            near[row + down, column + across] = True
    assert not (dark & ~near).any()


def test_a_sequence_is_a_pdf_of_many_pages(tmp_path: Path) -> None:
    plots = [line_plot(), line_plot(pens=(Pen("Ink", 2.0, "#ff0000"),)), torus_plot()]
    pdf = file_of("pdf", plots)
    reader = pypdf.PdfReader(io.BytesIO(pdf))
    assert len(reader.pages) == 3
    assert len(reader.trailer["/Root"]["/OCProperties"]["/OCGs"]) == 4  # "1 Ink" is one layer
    assert rendered(pdf, tmp_path, page=2, dpi=254)[500, 1000].tolist() == [255, 0, 0]


def test_tapered_pens_fill_areas_in_a_pdf(tmp_path: Path) -> None:
    strokes = make_strokes([[[38.5, 40.0], [238.5, 40.0]]], [[0.0, 20.0]])
    pen = Pen("Brush", 0.3, is_tapered=True)
    plot = plot_of(strokes, 277, 190, PlotOptions(pens=(pen,), fit="scale", scale=1.0))
    pixels = rendered(pdf_of([plot]), tmp_path, dpi=254)[..., 0] < 128
    assert pixels[:, 2485 - 500].sum() == pytest.approx(150, abs=3)
    assert pixels[:, 485 + 500].sum() == pytest.approx(50, abs=3)


def test_a_pdf_says_how_it_was_made() -> None:
    assert pdf_file.read_made_by(pdf_of([line_plot()], {"frame": 3})) == {"frame": 3}
    with pytest.raises(ValueError, match="says how it was made"):
        pdf_file.read_made_by(pdf_of([line_plot()]))
    with pytest.raises(ValueError, match="says how it was made"):
        pdf_file.read_made_by(pdf_of([line_plot()], {"frame": 3})[:200])


@pytest.mark.parametrize("extension", ["svg", "pdf", "dxf"])
def test_the_same_plot_gives_the_same_file(extension: str) -> None:
    assert file_of(extension, [torus_plot()]) == file_of(extension, [torus_plot()])


@pytest.mark.parametrize("version", ["R12", "R2000"])
def test_a_dxf_has_the_strokes_in_millimetres_on_layers(version: str, tmp_path: Path) -> None:
    plot = torus_plot()
    path = tmp_path / "torus.dxf"
    path.write_bytes(dxf_of(plot, version))
    document = ezdxf.readfile(path)
    assert not document.audit().errors
    names = {"R12": ["1_HIDDEN", "2_HATCHING", "4_OUTLINE"]}.get(
        version, [layer.label for layer in plot.layers]
    )
    for layer, name in zip(plot.layers, names, strict=True):
        found = document.modelspace().query(f'*[layer=="{name}"]')
        assert len(found) == len(layer.strokes)
        for entity, i in zip(found, range(len(layer.strokes)), strict=True):
            points = layer.strokes.points[layer.strokes.span(i)]
            path_ = ezdxf.path.make_path(entity)
            start = (points[0, 0], 210 - points[0, 1])
            assert (path_.start.x, path_.start.y) == pytest.approx(start, abs=0.01)
            flat = np.array([(p.x, 210 - p.y) for p in path_.flattening(0.001)])
            box = np.r_[flat.min(axis=0), flat.max(axis=0)]
            assert box == pytest.approx(np.r_[points.min(axis=0), points.max(axis=0)], abs=0.1)
    if version == "R2000":
        assert [document.layers.get(name).dxf.lineweight for name in names] == [35, 18, 70]


def test_dxf_layers_of_one_name_are_told_apart() -> None:
    strokes = make_strokes([[[0, 0], [50, 0]], [[0, 9], [50, 9]]], labels=[0, 1])
    subjects = (strokes.subjects[0], strokes.subjects[0]._replace(kind="Hatch"))
    strokes = replace(strokes, subjects=subjects)
    pens = (Pen("A/B", 0.3, number=1, kinds=("Hatch",)), Pen("A:B", 0.3, "#ff0000", number=1))
    plot = plot_of(strokes, 100, 100, PlotOptions(pens=pens))
    document = ezdxf.read(io.StringIO(dxf_of(plot).decode("cp1252")))
    layers = {layer.dxf.name: layer.dxf.color for layer in document.layers}
    assert layers["1 A_B"] == 7
    assert layers["1 A_B_2"] == 1


def test_tapered_pens_are_areas_in_a_dxf() -> None:
    pen = Pen("Brush", 0.3, is_tapered=True)
    for version, kind in (("R12", "POLYLINE"), ("R2000", "HATCH")):
        text = dxf_of(line_plot(pens=(pen,)), version).decode("cp1252")
        assert len(ezdxf.read(io.StringIO(text)).modelspace().query(kind)) == 1


def test_closed_tapered_strokes_are_rings_in_a_dxf() -> None:
    square = [[10, 10], [70, 10], [70, 70], [10, 70]]
    strokes = make_strokes([square], [[2.0] * 4], closed=True)
    pen = Pen("Brush", 0.3, is_tapered=True)
    plot = plot_of(strokes, 80, 80, PlotOptions(pens=(pen,), fit="scale", scale=1.0))
    for version, kind in (("R12", "POLYLINE"), ("R2000", "HATCH")):
        document = ezdxf.read(io.StringIO(dxf_of(plot, version).decode("cp1252")))
        found = document.modelspace().query(kind)
        paths = found[0].paths.paths if kind == "HATCH" else found
        corners = [[getattr(v, "dxf", v) for v in path_.vertices] for path_ in paths]
        xs = [[getattr(v, "location", v)[0] for v in ring] for ring in corners]
        inner, outer = sorted(np.ptp(ring) for ring in xs)
        assert [inner, outer] == pytest.approx([58, 62], abs=2e-3)  # its corners are mitred


@pytest.mark.parametrize("extension", ["svg", "pdf", "dxf"])
def test_files_say_how_they_were_made(extension: str) -> None:
    said = {"frame": 3, "by": "Ä \n %%EOF --> ]]>"}
    data = file_of(extension, [line_plot()], said)
    assert read_made_by(extension, data) == said
    for damaged in (file_of(extension, [line_plot()]), data[: len(data) // 2], b""):
        with pytest.raises(ValueError, match="made"):
            read_made_by(extension, damaged)


def test_a_dxf_is_of_a_version_that_is_known() -> None:
    with pytest.raises(PlotError, match="'R13', not one of R12, R2000"):
        dxf_of(line_plot(), "R13")


def shown_at(root: Any, time: float) -> list[str]:
    """Ids of the frames that are shown at a share of the round."""
    found = []
    for group in root:
        if not group.get("id", "").startswith("frame"):
            continue
        [animate] = (e for e in group if e.tag.endswith("animate"))
        times = [float(t) for t in animate.get("keyTimes").split(";")]
        assert times[0] == 0 and times == sorted(times) and times[-1] < 1
        last = max(i for i, t in enumerate(times) if t <= time)
        if animate.get("values").split(";")[last] == "inline":
            found.append(group.get("id"))
    return found


def test_an_animation_shows_one_frame_after_another() -> None:
    plots = [line_plot(), line_plot(), line_plot()]
    root = ElementTree.fromstring(file_of("svg", plots, frames_per_second=12.0))
    times = {0.0: 1, 0.32: 1, 0.34: 2, 0.66: 2, 0.67: 3, 0.99: 3}
    assert [shown_at(root, t) for t in times] == [[f"frame-{n}"] for n in times.values()]
    assert {e.get("dur") for e in root.iter() if e.tag.endswith("animate")} == {"0.25s"}
    ids = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(ids) == len(set(ids))
    still = [g.get("display") for g in root if g.get("id", "").startswith("frame")]
    assert still == [None, "none", "none"]  # of programs that do not animate


def test_an_animation_of_one_frame_stands_still() -> None:
    root = ElementTree.fromstring(animated_svg_of([line_plot()], 24.0))
    [frame] = [g for g in root if g.get("id") == "frame-1"]
    assert frame.get("display") is None
    assert not [e for e in root.iter() if e.tag.endswith("animate")]


def test_sequences_need_pages_of_one_size_and_a_format_for_them() -> None:
    with pytest.raises(PlotError, match="one size"):
        file_of("svg", [line_plot(), line_plot(paper="A3")])
    with pytest.raises(PlotError, match="one drawing"):
        file_of("dxf", [line_plot(), line_plot()])
    with pytest.raises(PlotError, match="no format"):
        file_of("hpgl", [line_plot()])
    with pytest.raises(PlotError, match="needs frames"):
        file_of("svg", [])


@pytest.mark.parametrize(("extension", "library"), [("pdf", "pypdf"), ("dxf", "ezdxf")])
def test_a_missing_library_is_named_with_the_way_to_it(
    extension: str, library: str, monkeypatch: Any
) -> None:
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(
        PlotError, match=f"{library}, which is not there: install it with .* -m pip"
    ):
        file_of(extension, [line_plot()])


def test_regions_need_shapely_before_anything_is_drawn(monkeypatch: Any) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    check("svg")
    with pytest.raises(PlotError, match="Filling regions needs the Python package shapely"):
        check("svg", has_regions=True)
