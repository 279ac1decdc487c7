"""Pictures of the stages' results say what the results are."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import illustrate_native as ill
import pytest
from illustrate_native import debug
from shapes import look_at, sphere, torus

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def view() -> tuple[ill.Prepared, ill.Drawing, ill.Camera]:
    meshes = [torus().mesh(), sphere().moved((0.9, -0.5, 0.3)).mesh(level=1)]
    prepared = ill.prepare(meshes, ill.PrepareOptions(level=1))
    camera = look_at((1, -2, 1.2))
    return prepared, ill.draw(prepared, camera, lights=[ill.Light("side")]), camera


@pytest.fixture(scope="module")
def pictures(view: tuple[ill.Prepared, ill.Drawing, ill.Camera]) -> dict[str, str]:
    return debug.pictures(*view)


def drawn_lines(picture: str, colour: str) -> int:
    """How many polylines of a colour a picture has."""
    root = ElementTree.fromstring(picture)
    return sum(
        path.get("d", "").count("M")
        for path in root.iter(f"{SVG}path")
        if path.get("stroke") == colour
    )


def test_each_stage_has_a_picture_of_the_view(pictures: dict[str, str]) -> None:
    assert list(pictures) == list(debug.STAGES)
    for stage, text in pictures.items():
        root = ElementTree.fromstring(text.encode())
        assert root.get("viewBox") == "0 0 256 256", stage
        assert root.get("width") == root.get("height") == "120mm", stage
        assert "nan" not in text and "inf" not in text, stage


def test_visibility_shows_all_arcs_and_nodes(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    graph = view[1].graph
    visible = int((graph.arc_layers_over == 0).sum())
    assert drawn_lines(pictures["visibility"], debug.BLACK) == visible > 0
    assert pictures["visibility"].count("<circle") == len(graph.node_kind) > 0


def test_contour_tells_kinds_apart(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    crossed = int((view[1].graph.arc_kind == ill.Kind.INTERSECTION).sum())
    assert drawn_lines(pictures["contour"], debug.RED) == crossed > 0
    assert "intersection" in pictures["contour"] and "boundary" not in pictures["contour"]


def test_tone_covers_the_cells_of_each_tone(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    tone = view[1].tone
    root = ElementTree.fromstring(pictures["tone"])
    shadow = next(path for path in root.iter(f"{SVG}path") if path.get("fill") == "#808080")
    runs = [run.split("h")[1].split("v")[0] for run in shadow.get("d", "").split("z") if run]
    cells = sum(float(width) for width in runs) / tone.cell_px
    assert cells == pytest.approx(int((tone.level == 2).sum()), abs=1)


def test_strokes_and_hatches_are_counted(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    drawing = view[1]
    assert f"{len(drawing.kinds)} strokes" in pictures["stroke"]
    assert f"{int((drawing.kinds == ill.Kind.HATCH).sum())} hatch" in pictures["hatch"]
    assert f"{len(view[0].surface.triangles):,} triangles" in pictures["surface"]


def test_curves_behind_the_form_are_left_out(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    assert drawn_lines(pictures["curves"], debug.RED) > 0
    root = ElementTree.fromstring(pictures["curves"])
    points = sum(path.get("d", "").count(",") for path in root.iter(f"{SVG}path"))
    assert 0 < points < len(view[0].hatch_curves.points)


def test_pictures_repeat(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], pictures: dict[str, str]
) -> None:
    assert debug.pictures(*view) == pictures


def test_chosen_stages_are_written(
    view: tuple[ill.Prepared, ill.Drawing, ill.Camera], tmp_path: Path
) -> None:
    files = debug.write_pictures(tmp_path / "new", *view, stages=["stroke", "tone"])
    assert [file.name for file in files] == ["tone.svg", "stroke.svg"]
    assert all(file.read_text(encoding="utf-8").endswith("</svg>\n") for file in files)


def test_an_unknown_stage_is_named(view: tuple[ill.Prepared, ill.Drawing, ill.Camera]) -> None:
    with pytest.raises(ValueError, match="stage is 'strokes', not one of surface, field"):
        debug.pictures(*view, stages=["strokes"])


def test_a_view_without_hatches_or_lines_is_drawn() -> None:
    away = look_at((0, 0, 1), centre=(50.0, 0.0, 0.0))
    prepared = ill.prepare([sphere().mesh()], ill.PrepareOptions(level=0))
    drawing = ill.draw(prepared, away, ill.DrawOptions(hatching=False))
    assert not len(drawing.kinds)
    for text in debug.pictures(prepared, drawing, away).values():
        ElementTree.fromstring(text.encode())
        assert "nan" not in text
