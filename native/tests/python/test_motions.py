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


def moved(camera: ill.Camera, turn: NDArray[np.float64], shift: NDArray[np.float64]) -> ill.Camera:
    """The camera that sees a scene turned and shifted as this one sees it where it was."""
    view = np.array(camera.view)
    view[:3, :3] = view[:3, :3] @ turn.T
    view[:3, 3] -= view[:3, :3] @ shift
    return ill.Camera(camera.projection, view, camera.width_px, camera.height_px)


def a_turn() -> NDArray[np.float64]:
    """By the Cayley transform, about an axis that is none of the world's."""
    angle = np.array([0.7, -0.4, 1.1])
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
    ],
    ids=["cube", "quads", "polygons", "pocket", "wobble"],
)  # fmt: skip
def test_rigid_motions_move_no_line(shape: Shape, scheme: str, crease_deg: float) -> None:
    turn, shift = a_turn(), np.array([5.0, -3.0, 2.0])
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
