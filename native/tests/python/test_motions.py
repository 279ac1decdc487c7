"""Rigid motions of a scene and its camera: no line moves, whatever decides about it."""

from __future__ import annotations

import illustrate_native as ill
import numpy as np
import pytest
from checker import draw
from numpy.typing import NDArray
from shapes import Shape, cube, look_at, plate, sphere

LINES = ill.DrawOptions(hatching=False)
CAMERAS = [
    look_at(direction, 1.9, perspective=perspective, size_px=512)
    for direction in ((1.0, -2.0, 0.8), (-1.1, -0.3, 0.35), (0.2, 0.9, -1.3))
    for perspective in (True, False)
]


def walled() -> Shape:
    """A box of six polygons with four corners on each side."""
    box, steps = cube(), np.arange(4) / 4
    corners = np.concatenate(
        [
            (1 - s) * box.positions[quad[k]] + s * box.positions[quad[(k + 1) % 4]]
            for quad in box.corner_vertices.reshape(-1, 4)
            for k in range(4)
            for s in steps
        ]
    ).reshape(-1, 3)
    positions, merged = np.unique(np.round(corners, 9), axis=0, return_inverse=True)
    return Shape(positions, np.full(6, 16, np.int32), merged.reshape(-1).astype(np.int32))


def of_triangles(positions: NDArray[np.float64], triangles: list[list[int]]) -> Shape:
    corners = np.array(triangles, np.int32)
    return Shape(positions, np.full(len(corners), 3, np.int32), corners.reshape(-1))


def prism(sides: int) -> Shape:
    """Of radius and height 1, its ends fans from their first corners."""
    around = 2 * np.pi * np.arange(sides) / sides
    low = np.stack([np.cos(around), np.sin(around), np.zeros(sides)], axis=-1)
    walls = [[i, (i + 1) % sides, sides + i] for i in range(sides)]
    walls += [[(i + 1) % sides, sides + (i + 1) % sides, sides + i] for i in range(sides)]
    floor = [[0, i + 1, i] for i in range(1, sides - 1)]
    roof = [[sides, sides + i, sides + i + 1] for i in range(1, sides - 1)]
    high = low + np.array([0.0, 0.0, 1.0])
    return of_triangles(np.concatenate([low, high]), walls + floor + roof)


def nested(one: Shape, two: Shape) -> Shape:
    """Both at their places, as one mesh."""
    return Shape(
        np.concatenate([one.positions, two.positions]),
        np.concatenate([one.face_sizes, two.face_sizes]),
        np.concatenate([one.corner_vertices, two.corner_vertices + len(one.positions)]),
    )


def blunt_cone(sides: int = 7) -> Shape:
    """Its tip is a ring of vertices and a fan within it, all in one place."""
    around = 2 * np.pi * np.arange(sides) / sides
    low = np.stack([np.cos(around), np.sin(around), np.zeros(sides)], axis=-1) / 2
    tip = np.tile([0.05, 0.1, 0.9], (sides + 1, 1))
    triangles = []
    for i in range(sides):
        k = (i + 1) % sides
        triangles += [[i, k, sides + k], [i, sides + k, sides + i]]
        triangles += [[sides + i, sides + k, 2 * sides]]
    return of_triangles(np.concatenate([low, tip]), triangles)


def moved(camera: ill.Camera, turn: NDArray[np.float64], shift: NDArray[np.float64]) -> ill.Camera:
    """The camera that sees a scene turned and shifted as this one sees it where it was."""
    view = np.array(camera.view)
    view[:3, :3] = view[:3, :3] @ turn.T
    view[:3, 3] -= view[:3, :3] @ shift
    return ill.Camera(camera.projection, view, camera.width_px, camera.height_px)


def torn() -> Shape:
    """A box of which one face has moved a corner inward, within its plane."""
    corners = [[-1, 1, 1], [-1, -1, 1], [1, -1, 1], [-1, -1, -1], [-1, 1, -1],
               [1, 1, 1], [1, 1, -1], [1, -1, -1], [0.9, 0.9, 1]]  # fmt: skip
    triangles = [[0, 1, 2], [3, 2, 1], [0, 4, 1], [4, 3, 1], [7, 2, 3], [6, 7, 3], [4, 6, 3],
                 [6, 4, 5], [6, 5, 7], [5, 2, 7], [4, 0, 5], [8, 0, 2]]  # fmt: skip
    return of_triangles(np.array(corners) / np.sqrt(3.0), triangles)


def joined_tetrahedra() -> Shape:
    """Two, closed by one face twice."""
    angles = 2 * np.pi * np.arange(3) / 3
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(3)], axis=-1)
    faces = [[3, 0, 1], [3, 1, 2], [3, 2, 0], [2, 1, 0],
             [4, 1, 0], [4, 2, 1], [4, 0, 2], [2, 0, 1]]  # fmt: skip
    return of_triangles(np.concatenate([ring, [[0, 0, 1], [0, 0, -1]]]), faces)


def a_turn(x: float = 0.7, y: float = -0.4, z: float = 1.1) -> NDArray[np.float64]:
    """By the Cayley transform, about an axis that is none of the world's."""
    angle = np.array([x, y, z])
    skew = np.array([[0, -angle[2], angle[1]], [angle[2], 0, -angle[0]], [-angle[1], angle[0], 0]])
    return np.linalg.solve(np.eye(3) + skew, np.eye(3) - skew)


@pytest.mark.parametrize(
    ("shape", "scheme", "crease_deg"),
    [
        (cube(), "loop", 180.0),
        (cube(), "catmull-clark", 180.0),
        (walled(), "loop", 180.0),
        (plate(5), "loop", 60.0),
        (plate(24, 0.08), "loop", 60.0),
        (nested(prism(12), prism(18)), "loop", 60.0),
        (nested(prism(9), prism(15)), "loop", 60.0),
        (blunt_cone(), "loop", 180.0),
        (joined_tetrahedra(), "loop", 180.0),
        (torn(), "loop", 180.0),
    ],
    ids=["cube", "quads", "polygons", "pocket", "wobble", "flush", "flush sides", "tip",
         "joined", "torn"],
)  # fmt: skip
@pytest.mark.parametrize(
    ("turn", "shift"),
    [
        (a_turn(), np.array([5.0, -3.0, 2.0])),
        (a_turn(-1.7, 0.25, 0.6), np.array([-6.0, 7.0, 4.0])),
    ],
    ids=["one", "other"],
)
def test_rigid_motions_move_no_line(
    shape: Shape,
    scheme: str,
    crease_deg: float,
    turn: NDArray[np.float64],
    shift: NDArray[np.float64],
) -> None:
    there = Shape(shape.positions @ turn.T + shift, shape.face_sizes, shape.corner_vertices)
    options = ill.PrepareOptions(level=4, scheme=scheme, field=False)
    here, gone = (
        ill.prepare([s.mesh(crease_angle_deg=crease_deg)], options) for s in (shape, there)
    )
    for camera in CAMERAS:
        one = draw(here, camera, LINES)
        two = draw(gone, moved(camera, turn, shift), LINES)
        assert one.image.shape == two.image.shape
        assert np.abs(one.image - two.image).max() < 1e-3


def stretched_sphere(share: float) -> Shape:
    """A sphere whose limit cuts the plain one's in curves where both are nearly tangent."""
    s = sphere()
    stretched = s.positions * [1 + share, 1 - share, 1] + share * np.array([0.31, 0.17, 0.07])
    return Shape(stretched, s.face_sizes, s.corner_vertices)


def unwelded(shape: Shape) -> Shape:
    """Every face with corners of its own, which agree but for rounding."""
    positions = shape.positions[shape.corner_vertices]
    noise = np.random.default_rng(5).integers(-2, 3, positions.shape) * np.finfo(float).eps
    return Shape(positions + noise, shape.face_sizes, np.arange(len(positions), dtype=np.int32))


@pytest.mark.parametrize(
    "parts",
    [
        [cube(), cube().moved((0.6, 0.35, 0.8))],
        [sphere(), stretched_sphere(0.01)],
        [sphere(), stretched_sphere(0.002)],
        [unwelded(cube())],
    ],
    ids=["cubes", "near", "nearer", "unwelded"],
)
def test_rigid_motions_move_no_line_where_parts_touch(parts: list[Shape]) -> None:
    turn, shift = a_turn(), np.array([5.0, -3.0, 2.0])
    gone = [Shape(p.positions @ turn.T + shift, p.face_sizes, p.corner_vertices) for p in parts]
    options = ill.PrepareOptions(level=4, field=False)
    here, there = (ill.prepare([s.mesh() for s in shapes], options) for shapes in (parts, gone))
    for camera in CAMERAS:
        one = draw(here, camera, LINES)
        two = draw(there, moved(camera, turn, shift), LINES)
        assert one.image.shape == two.image.shape
        assert np.abs(one.image - two.image).max() < 1e-3


# The farther away, the coarser positions in single precision are, and the farther surfaces that
# touch are kept apart: in octaves, not with every step.
def test_shifts_far_from_the_origin_move_no_line() -> None:
    away, step = np.array([221.0, 0.0, 0.0]), np.array([5.0, -3.0, 2.0])
    parts = [sphere(), stretched_sphere(0.002)]
    near, far = ([p.moved(tuple(shift)) for p in parts] for shift in (away, away + step))
    options = ill.PrepareOptions(level=4, field=False)
    here, there = (ill.prepare([s.mesh() for s in shapes], options) for shapes in (near, far))
    for camera in CAMERAS:
        one = draw(here, moved(camera, np.eye(3), away), LINES)
        two = draw(there, moved(camera, np.eye(3), away + step), LINES)
        assert one.image.shape == two.image.shape
        assert np.abs(one.image - two.image).max() < 1e-3


# Sizes are the surface's own and not those of a box along the axes: it would be half as large
# again, with coarser triangles, and rounder edges.
def test_rigid_motions_change_no_surface() -> None:
    turn, shift = a_turn(), np.array([5.0, -3.0, 2.0])
    for shape, cage in [(cube(), True), (walled(), False), (sphere(3), False), (plate(24), False)]:
        there = Shape(shape.positions @ turn.T + shift, shape.face_sizes, shape.corner_vertices)
        options = ill.PrepareOptions(field=False, scheme="catmull-clark")
        one, two = (ill.prepare([s.mesh(cage=cage)], options).surface for s in (shape, there))
        assert np.abs(one.positions @ turn.T + shift - two.positions).max() < 1e-9
