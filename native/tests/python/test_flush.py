"""Parts that overlap in one plane, in whole drawings and in those without one of the parts."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
from checker import LEVEL, draw
from illustrate_native import debug
from shapes import cube, look_at
from test_debug import drawn_lines

Corner = tuple[float, float, float]


def block(low: Corner, high: Corner) -> ill.PolygonMesh:
    unit = cube()
    share = (unit.positions + 1) / 2
    positions = np.array(low) + share * (np.array(high) - np.array(low))
    return ill.PolygonMesh(
        positions, unit.face_sizes, unit.corner_vertices, crease_angle_deg=30, cage=False
    )


WALL = block((-1.5, -0.5, -1), (1.5, 0, 1))
BEAM = block((-0.25, -1.5, -0.25), (0.25, 0, 0.25))


def strokes(*meshes: ill.PolygonMesh, **options: Any) -> ill.Drawing:
    """From the front, where the wall hides all of the beam but its end, which is flush."""
    prepared = ill.prepare(list(meshes), ill.PrepareOptions(level=LEVEL))
    camera = look_at(direction=(0.2, 1, 0.2), radius=2)
    return draw(prepared, camera, ill.DrawOptions(hatching=False, **options))


def length_px(drawing: ill.Drawing, hidden: bool = False) -> float:
    lengths = []
    pieces = np.split(drawing.image, drawing.offsets[1:-1])
    for points, is_closed in zip(pieces, drawing.closed, strict=True):
        line = np.vstack([points, points[:1]]) if is_closed else points
        lengths.append(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
    return float(np.sum(np.array(lengths)[(drawing.invisibility > 0) == hidden]))


def test_only_the_wall_is_seen_whichever_part_comes_first() -> None:
    alone = length_px(strokes(WALL))
    for meshes in ((WALL, BEAM), (BEAM, WALL)):
        # At the beam's corners edges meet to within rounding; without the rule its end adds 15 %.
        assert abs(length_px(strokes(*meshes)) - alone) < 0.02 * alone


def test_without_the_wall_the_beam_has_its_end() -> None:
    styles = [ill.ObjectStyle(ignore=True), ill.ObjectStyle()]
    without = strokes(WALL, BEAM, styles=styles)
    np.testing.assert_array_equal(without.image, strokes(BEAM).image)
    assert not without.graph.arc_flush.any()


def test_hidden_lines_show_the_end_of_the_beam() -> None:
    both = [strokes(*m, hidden_lines=(1, 9)) for m in ((WALL, BEAM), (BEAM, WALL))]
    hidden = [length_px(drawing, hidden=True) for drawing in both]
    assert abs(hidden[0] - hidden[1]) < 0.02 * hidden[0]


def test_arcs_within_a_face_are_hidden_by_it() -> None:
    graph = strokes(WALL, BEAM).graph
    is_flush = graph.arc_flush == 1
    assert is_flush.any() and not is_flush.all()
    np.testing.assert_array_equal(
        graph.arc_layers_over, np.maximum(graph.arc_invisibility, graph.arc_flush)
    )


def test_pictures_of_stages_draw_no_line_within_a_face() -> None:
    prepared = ill.prepare([BEAM, WALL], ill.PrepareOptions(level=LEVEL))
    camera = look_at(direction=(0.2, 1, 0.2), radius=2)
    drawing = draw(prepared, camera, ill.DrawOptions(hatching=False))
    seen = int((drawing.graph.arc_layers_over == 0).sum())
    assert seen < (drawing.graph.arc_invisibility == 0).sum()
    picture = debug.pictures(prepared, drawing, camera)["visibility"]
    assert drawn_lines(picture, debug.BLACK) == seen


def turned(mesh: tuple[Corner, Corner], by: Any) -> ill.PolygonMesh:
    unit = cube()
    low, high = np.array(mesh[0]), np.array(mesh[1])
    positions = low + (unit.positions + 1) / 2 * (high - low)
    return ill.PolygonMesh(
        positions @ by.T, unit.face_sizes, unit.corner_vertices, crease_angle_deg=30, cage=False
    )


def test_no_edge_is_seen_behind_the_corners_of_a_flush_end() -> None:
    """A third of these views drew edges of the beam within the wall."""
    random = np.random.default_rng(0)
    for _ in range(20):
        by, _ = np.linalg.qr(random.normal(size=(3, 3)))
        by *= np.sign(np.linalg.det(by))
        (width, height), aside = random.uniform(0.1, 0.4, 2), random.uniform(-0.5, 0.5)
        beam = turned(((aside - width, -1.5, -height), (aside + width, 0, height)), by)
        wall = turned(((-1.5, -0.5, -1), (1.5, 0, 1)), by)
        prepared = ill.prepare([beam, wall], ill.PrepareOptions(level=LEVEL))
        x, z = random.uniform(-0.25, 0.25, 2)
        camera = look_at(tuple(by @ (x, 1, z)), radius=2.2, size_px=1024)
        drawing = draw(prepared, camera, ill.DrawOptions(hatching=False))
        assert not (drawing.objects == 0).any()
