"""Meshes that are no cages: sharp where they are shaded so, and on the artist's vertices."""

from __future__ import annotations

import importlib
from pathlib import Path

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_drawing, draw
from shapes import Doubles, look_at

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
HALF_WIDTH, HALF_HEIGHT = 0.8, 0.5
CORNERS = [(-HALF_WIDTH, -HALF_HEIGHT), (HALF_WIDTH, -HALF_HEIGHT), (HALF_WIDTH, HALF_HEIGHT),
           (-HALF_WIDTH, HALF_HEIGHT)]  # fmt: skip

Plane = tuple[list[tuple[float, float]], list[list[int]]]


def rim() -> list[tuple[float, float]]:
    """The rectangle's outline with vertices within its sides."""
    shares = [(0, 0.1, 0.45, 0.7), (0, 0.35), (0, 0.2, 0.25), (0, 0.5)]
    return [
        tuple(np.add(a, np.subtract(b, a) * t))
        for a, b, side in zip(CORNERS, [*CORNERS[1:], CORNERS[0]], shares, strict=True)
        for t in side
    ]


def grid(columns: int, rows: int) -> Plane:
    x = np.linspace(-HALF_WIDTH, HALF_WIDTH, columns + 1)
    y = np.linspace(-HALF_HEIGHT, HALF_HEIGHT, rows + 1)
    quads = [
        [i * (rows + 1) + j, (i + 1) * (rows + 1) + j, (i + 1) * (rows + 1) + j + 1,
         i * (rows + 1) + j + 1]
        for i in range(columns)
        for j in range(rows)
    ]  # fmt: skip
    return [(a, b) for a in x for b in y], quads


def planes() -> dict[str, Plane]:
    around = rim()
    count = len(around)
    return {
        "two triangles": (CORNERS, [[0, 1, 2], [0, 2, 3]]),
        "fan": ([*CORNERS, (0.1, 0.2)], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]),
        "n-gon": (around, [list(range(count))]),
        "fan of the n-gon": (
            [*around, (0.2, -0.1)],
            [[i, (i + 1) % count, count] for i in range(count)],
        ),
        "grid": grid(5, 3),
        "needle": (
            [*CORNERS, (0.1, -HALF_HEIGHT), (0.1, HALF_HEIGHT - 1e-6)],
            [[0, 4, 3], [4, 5, 3], [4, 1, 5], [1, 2, 5], [2, 3, 5]],
        ),
    }


def to_outline(points: Doubles, corners: Doubles) -> float:
    """The farthest that a point is from the sides of a polygon."""
    nearest = np.full(len(points), np.inf)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(points - a - along[:, None] * (b - a), axis=1))
    return float(nearest.max())


def image_of(camera: ill.Camera, points: Doubles) -> Doubles:
    clip = np.c_[points, np.ones(len(points))] @ (camera.projection @ camera.view).T
    share = clip[:, :2] / clip[:, 3:]
    image: Doubles = (share * [1, -1] + 1) / 2 * [camera.width_px, camera.height_px]
    return image


@pytest.mark.parametrize("name", planes())
def test_a_plane_is_a_plane_however_it_is_cut(name: str) -> None:
    places, faces = planes()[name]
    mesh = ill.PolygonMesh(
        np.c_[places, np.zeros(len(places))],
        [len(face) for face in faces],
        np.concatenate(faces),
        cage=False,
        crease_angle_deg=30,
    )
    prepared = ill.prepare([mesh], ill.PrepareOptions(field=False))
    assert prepared.report["corners"] == 4
    camera = look_at()
    drawing = draw(prepared, camera, ill.DrawOptions(hatching=False))
    check_drawing(drawing, camera)
    assert set(drawing.kinds) == {ill.Kind.BOUNDARY}
    corners = image_of(camera, np.c_[CORNERS, np.zeros(4)])
    assert to_outline(drawing.image, corners) < 0.1
    assert to_outline(corners, drawing.image.astype(float)) < 0.1


def cones(count: int) -> ill.Prepared:
    """Cones of 32 triangles shaded flat, open below, with tips at (3 i, 0, 1); of linked copies."""
    sides = 32
    turns = np.arange(sides) * 2 * np.pi / sides
    rim = np.c_[np.cos(turns), np.sin(turns), np.full(sides, -1.0)]
    faces = [[i, (i + 1) % sides, sides] for i in range(sides)]
    original = ill.PolygonMesh(
        np.r_[rim, [[0, 0, 1]]],
        [3] * sides,
        np.concatenate(faces),
        cage=False,
        crease_angle_deg=30,
    )
    places = np.tile(np.eye(4), (count, 1, 1))
    places[:, 0, 3] = 3 * np.arange(count)
    meshes = [original, *(ill.PolygonMesh.instance(original, place) for place in places[1:])]
    return ill.prepare(meshes, ill.PrepareOptions(field=False))


@pytest.mark.parametrize("direction", [(1.0, -2.0, 0.8), (1.0, -2.0, 0.0), (2.0, -2.0, -1.0)])
def test_outlines_of_cones_reach_their_tips(direction: tuple[float, float, float]) -> None:
    prepared = cones(2)
    camera = look_at(direction, radius=3.5, centre=(1.5, 0, 0))
    drawing = draw(prepared, camera, ill.DrawOptions(hatching=False))
    check_drawing(drawing, camera)
    strokes = np.repeat(drawing.kinds, np.diff(drawing.offsets))
    outline = drawing.image[strokes == ill.Kind.SILHOUETTE]
    for tip in image_of(camera, np.array([(0.0, 0, 1), (3.0, 0, 1)])):
        assert np.linalg.norm(outline - tip, axis=1).min() < 0.1


def test_obj_files_are_read_with_their_normals(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(str(EXAMPLES))
    read_corner_normals = importlib.import_module("mesh_files").read_corner_normals
    path = tmp_path / "mesh.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 1 0 1\nf 1//2 2/7/1 3\n")
    assert read_corner_normals(path) == [[1, 0, 1], [0, 0, 1], [0, 0, 0]]
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\n")
    assert read_corner_normals(path) is None
