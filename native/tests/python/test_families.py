"""One direction of hatches stays where there is room for one: the same from everywhere, in motion,
and of linked copies."""

from __future__ import annotations

from collections.abc import Callable

import illustrate_native as ill
import numpy as np
import pytest
from checker import LEVEL, draw
from numpy.typing import NDArray
from scipy.spatial import cKDTree  # type: ignore[import-untyped]
from shapes import SIZE_PX, Doubles, Shape, drape, klein_bottle, look_at, sphere

# A single family everywhere.
MIDTONES = ill.DrawOptions(
    highlight_threshold=1.0, shadow_threshold=0.0, mach_bands=False, undercuts=False
)
SPACING = MIDTONES.spacing_px


def bump() -> Shape:
    """A sphere with dents: its field has singularities, and seams between them."""
    ball = sphere(10)
    x, y, z = ball.positions.T
    radius = 1 + 0.15 * np.sin(3 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(5 * z)
    return Shape(ball.positions * radius[:, None], ball.face_sizes, ball.corner_vertices)


def prepared_of(shape: Shape, previous: ill.Prepared | None = None) -> ill.Prepared:
    return ill.prepare([shape.mesh()], ill.PrepareOptions(level=LEVEL), previous=previous)


def hatches(drawing: ill.Drawing, along: Doubles) -> tuple[Doubles, Doubles]:
    """Middles and unit directions of the segments of all hatches, by points of the world or of the
    image."""
    middles, ways = [], []
    for i in np.flatnonzero(drawing.kinds == int(ill.Kind.HATCH)):
        line = along[drawing.offsets[i] : drawing.offsets[i + 1]]
        way = np.diff(line, axis=0)
        length = np.linalg.norm(way, axis=1)
        middles.append((line[:-1] + line[1:])[length > 0] / 2)
        ways.append(way[length > 0] / length[length > 0, None])
    return np.concatenate(middles), np.concatenate(ways)


def turned(
    one: tuple[Doubles, Doubles], other: tuple[Doubles, Doubles], radius: float
) -> NDArray[np.bool_]:
    """Of the segments that have some of the other drawing within the radius: whether all of those
    are across."""
    tree = cKDTree(other[0])
    found = []
    for middle, way in zip(*one, strict=True):
        near = tree.query_ball_point(middle, radius)
        if near:
            found.append(bool((np.abs(other[1][near] @ way) < np.sqrt(0.5)).all()))
    return np.array(found)


@pytest.mark.parametrize("make", [bump, drape, klein_bottle])
def test_the_same_direction_stays_in_all_views(make: Callable[[], Shape]) -> None:
    prepared = prepared_of(make())
    seen = []
    for direction in ((1.0, -2.0, 0.8), (1.6, -1.6, 0.5), (0.3, -2.0, 1.6)):
        drawing = draw(prepared, look_at(direction, size_px=2 * SIZE_PX), MIDTONES)
        seen.append(hatches(drawing, np.asarray(drawing.points)))
    camera = look_at(size_px=2 * SIZE_PX)
    spacing = 2 * 1.8 / 0.95 / camera.width_px * SPACING  # in the world
    for other in seen[1:]:
        found = turned(seen[0], other, 0.5 * spacing)
        assert len(found) > 50
        assert found.mean() < 0.02


def test_hatches_of_two_families_keep_apart() -> None:
    prepared = prepared_of(bump())
    drawing = draw(prepared, look_at(), MIDTONES)
    middles, ways = hatches(drawing, np.asarray(drawing.image))
    pairs = cKDTree(middles).query_pairs(0.7 * SPACING, output_type="ndarray")
    cosines = np.abs(np.sum(ways[pairs[:, 0]] * ways[pairs[:, 1]], axis=1))
    assert (cosines < 0.3).mean() < 0.01, "in the image foreshortened ones may seem across"


def test_what_deforms_keeps_its_families() -> None:
    shape, camera = bump(), look_at()
    prepared, last = None, None
    for frame in range(4):
        bent = shape.positions.copy()
        bent[:, 0] += 0.01 * frame * np.sin(2 * bent[:, 2])
        prepared = prepared_of(Shape(bent, shape.face_sizes, shape.corner_vertices), prepared)
        drawing = draw(prepared, camera, MIDTONES)
        now = hatches(drawing, np.asarray(drawing.image))
        if last is not None:
            found = turned(last, now, 0.75 * SPACING)
            assert len(found) > 200
            assert found.mean() < 0.02
        last = now
