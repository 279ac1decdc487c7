"""Guides, prescribed singularities and the last field, through the module."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from illustrate_native import field_svg
from shapes import look_at, sphere, torus

LEVEL = 3


def options(**more: Any) -> ill.PrepareOptions:
    return ill.PrepareOptions(level=LEVEL, parabolic_ratio=0, **more)


@pytest.fixture(scope="module")
def ball() -> ill.Prepared:
    return ill.prepare([sphere().mesh()], options())


def great_circle(tilt: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    u = np.linspace(-1, 1, 200)
    return np.stack([np.cos(u), np.sin(u) * np.cos(tilt), np.sin(u) * np.sin(tilt)], axis=1)


def off_circle(prepared: ill.Prepared, field: ill.CrossField, tilt: float) -> float:
    """Degrees between the field and a great circle, at vertices on its middle part."""
    p, n, d = prepared.surface.positions, prepared.surface.normals, field.directions
    pole = np.array([0, -np.sin(tilt), np.cos(tilt)])
    chosen = (np.abs(p @ pole) < 0.02) & (p[:, 0] > 0.7)
    along = np.cross(pole, n[chosen])
    along /= np.linalg.norm(along, axis=1)[:, None]
    d, n = d[chosen], n[chosen]
    sine = np.minimum(np.abs((d * along).sum(1)), np.abs((np.cross(n, d) * along).sum(1)))
    return float(np.degrees(np.arcsin(sine.max())))


def test_a_guide_is_followed_and_the_last_field_taken_up(ball: ill.Prepared) -> None:
    for tilt in (0.2, 0.6):
        guided = options(guides=[ill.Guide(great_circle(tilt), weight=10)])
        assert off_circle(ball, ill.solve_cross_field(ball, guided), tilt) < 2
        again = ill.prepare([sphere().mesh()], guided, previous=ball)
        assert again.timings["surface"] == 0
        assert off_circle(again, again.field, tilt) < 2


def test_a_moved_mesh_starts_from_the_last_field() -> None:
    shape = torus()
    first = ill.prepare([shape.mesh()], options())
    moved = ill.prepare([shape.moved((1.0, 2.0, 3.0)).mesh()], options(), previous=first)
    fresh = ill.prepare([shape.moved((1.0, 2.0, 3.0)).mesh()], options())
    assert first.field.energy == pytest.approx(fresh.field.energy, rel=1e-4)
    assert moved.field.energy == pytest.approx(fresh.field.energy, rel=1e-4)
    turns = np.abs((first.field.directions * moved.field.directions).sum(1))
    assert np.abs(turns - np.round(turns)).max() < 0.05  # by quarter turns at most


def apart(one: ill.Prepared, other: ill.Prepared) -> float:
    """Median of the degrees between two crosses of a vertex."""
    first, second = one.field.directions, other.field.directions
    sine = np.linalg.norm(np.cross(first, second), axis=1)
    cosine = np.abs((first * second).sum(1))
    return float(np.median(np.degrees(np.arcsin(np.minimum(1, np.minimum(sine, cosine))))))


def test_a_mesh_that_deforms_keeps_its_field_though_quads_are_split_anew() -> None:
    guided = options(guides=[ill.Guide(great_circle(0.6), weight=10)])
    first = ill.prepare([sphere().mesh()], guided)
    shape = sphere()
    shape.positions[:, 0] += 0.02 * np.sin(3 * shape.positions[:, 1])
    fresh = ill.prepare([shape.mesh()], options())
    moved = ill.prepare([shape.mesh()], options(), previous=first)
    assert (moved.surface.triangles != first.surface.triangles).any()
    assert apart(fresh, first) > 10
    assert apart(moved, first) < 3


def test_what_is_not_stretched_keeps_its_field() -> None:
    shape = torus()
    first = ill.prepare([shape.mesh()], options())
    bent = shape.positions.copy()
    bent[:, 2] *= 1 + 0.3 * np.clip(bent[:, 0] - 0.2, 0, 1)
    moved = ill.prepare([shape.mesh().deformed(bent)], options(), previous=first)
    assert (moved.surface.triangles != first.surface.triangles).any()
    rests = first.surface.positions[:, 0] < -0.5
    there, then = moved.field.directions[rests], first.field.directions[rests]
    turns = np.abs((there * then).sum(1))
    assert np.abs(turns - np.round(turns)).max() < 1e-6  # by quarter turns at most
    assert (np.abs(moved.field.directions[~rests] - first.field.directions[~rests]) > 0.01).any()


def test_prescribed_singularities_are_listed_where_they_were_put(ball: ill.Prepared) -> None:
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / np.sqrt(3)
    places = np.concatenate([corners, np.eye(3), -np.eye(3)])
    turns = np.array([1] * 8 + [1] * 3 + [-1] * 3)
    field = ill.solve_cross_field(ball, options(singularities=(places, turns)))
    assert sorted(field.singular_indices) == sorted(turns)
    edge = 0.1
    for place, turn in zip(places, turns, strict=True):
        there = field.singular_positions[field.singular_indices == turn]
        assert np.linalg.norm(there - place, axis=1).min() < edge
    centroids = ball.surface.positions[ball.surface.triangles[field.singular_triangles]].mean(1)
    np.testing.assert_allclose(field.singular_positions, centroids, atol=1e-12)


def test_what_cannot_be_prescribed_is_refused_by_name(ball: ill.Prepared) -> None:
    with pytest.raises(ill.InvalidInput, match=r"mesh 0\) has 3, but must have 4 chi = 8"):
        ill.solve_cross_field(ball, options(singularities=([[0, 0, 1]], [3])))
    with pytest.raises(ill.InvalidInput, match="singularities has 1 positions but 2 quarter turns"):
        options(singularities=([[0, 0, 1]], [3, 5]))
    with pytest.raises(ill.InvalidInput, match="singularities must be"):
        options(singularities=3)
    with pytest.raises(ill.InvalidInput, match=r"guides\[1\] is not a Guide"):
        options(guides=[ill.Guide([[0, 0, 0]]), [[0, 0, 0]]])
    with pytest.raises(ill.InvalidInput, match=r"guides\[0\].weight"):
        ill.solve_cross_field(ball, options(guides=[ill.Guide([[0, 0, 0]], weight=-1)]))
    with pytest.raises(ill.InvalidInput, match="field_start is 'best'"):
        options(field_start="best")


def test_options_are_read_back() -> None:
    guide = ill.Guide([[0, 0, 1], [1, 0, 0]])
    chosen = options(guides=[guide], singularities=([[0, 0, 1]], [8]), field_start="principal")
    assert guide.weight == 10
    np.testing.assert_array_equal(chosen.guides[0].points, guide.points)
    positions, turns = chosen.singularities or ((), ())
    assert np.asarray(positions).tolist() == [[0, 0, 1]]
    assert np.asarray(turns).tolist() == [8]
    assert chosen.field_start == "principal"
    chosen.singularities, chosen.guides = None, None
    assert chosen.singularities is None
    assert chosen.guides == []


def test_the_papers_start_is_no_better_than_the_search() -> None:
    bumpy = sphere()
    x, y, z = bumpy.positions.T
    bumpy = bumpy.__class__(
        bumpy.positions * (1 + 0.2 * np.sin(5 * x) * np.sin(4 * y + 1) * np.cos(3 * z))[:, None],
        bumpy.face_sizes,
        bumpy.corner_vertices,
    )
    prepared = ill.prepare([bumpy.mesh()], options())
    papers = ill.solve_cross_field(prepared, options(field_start="principal"))
    assert papers.energy <= papers.energy_initial
    assert prepared.field.energy <= papers.energy
    assert papers.singular_indices.sum() == prepared.field.singular_indices.sum() == 8


def test_a_picture_of_the_field_shows_its_near_side(ball: ill.Prepared) -> None:
    camera = look_at()
    text = field_svg.field_to_svg(ball.surface, ball.field, camera)
    assert text == field_svg.field_to_svg(ball.surface, ball.field, camera)
    arms = text.count("M")
    assert arms > 100
    assert arms % 2 == 0
    shown = text.count("<circle")
    towards = camera.view[2, :3]
    near = (ball.field.singular_positions @ towards > 0.5).sum()
    far = (ball.field.singular_positions @ towards < 0).sum()
    assert near <= shown <= 8 - far
    denser = field_svg.field_to_svg(ball.surface, ball.field, camera, spacing_px=5)
    assert denser.count("M") > 2 * arms
    for wrong in ({"spacing_px": 0}, {"width_mm": 0}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            field_svg.field_to_svg(ball.surface, ball.field, camera, **wrong)
