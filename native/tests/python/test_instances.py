"""Objects that share what is prepared of one mesh are drawn as if each had its own."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import LEVEL, draw, lengths_px
from shapes import Doubles, Shape, drape, klein_bottle, look_at, torus

OPTIONS = ill.PrepareOptions(level=LEVEL)


def placement(angle: float, scale: Any = 1.0, offset: tuple[float, ...] = (0, 0, 0)) -> Doubles:
    """A turn about an axis that is none of the world's, a scale along the axes, an offset."""
    axis = np.array([1.0, 2.0, 2.0]) / 3
    k = np.cross(np.eye(3), -axis)
    turn = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k
    result = np.eye(4)
    result[:3, :3] = turn * scale
    result[:3, 3] = offset
    return result


def moved(shape: Shape, place: Doubles) -> Shape:
    positions = shape.positions @ place[:3, :3].T + place[:3, 3]
    return Shape(positions, shape.face_sizes, shape.corner_vertices)


PLACES = [
    placement(0.0),
    placement(0.7, 0.5, (2.5, 0.5, 0.2)),
    placement(-2.1, 1.5, (-1.0, 3.0, -1.0)),
]
VIEW = look_at(radius=5.0)


@pytest.fixture(
    scope="module", params=[torus, drape, klein_bottle], ids=lambda shape: shape.__name__
)
def shape(request: pytest.FixtureRequest) -> Shape:
    made: Shape = request.param()
    return made


@pytest.fixture(scope="module")
def shared(shape: Shape) -> ill.Prepared:
    mesh = shape.mesh(name="original")
    return ill.prepare([mesh.instance(place) for place in PLACES], OPTIONS)


@pytest.fixture(scope="module")
def separate(shape: Shape) -> ill.Prepared:
    return ill.prepare([moved(shape, place).mesh() for place in PLACES], OPTIONS)


def test_the_surface_is_that_of_separate_meshes(
    shared: ill.Prepared, separate: ill.Prepared
) -> None:
    ours, theirs = shared.surface, separate.surface
    np.testing.assert_array_equal(ours.triangles, theirs.triangles)
    np.testing.assert_array_equal(ours.objects, theirs.objects)
    np.testing.assert_array_equal(ours.base_faces, theirs.base_faces)
    np.testing.assert_array_equal(ours.feature_edges, theirs.feature_edges)
    for name in ("positions", "normals", "base_uv"):
        np.testing.assert_allclose(getattr(ours, name), getattr(theirs, name), atol=1e-9)
    for name in ("k1", "k2", "hatch_k1", "hatch_k2"):
        np.testing.assert_allclose(getattr(ours, name), getattr(theirs, name), atol=1e-3, rtol=1e-3)


def test_the_limit_surface_goes_with_each_object(shared: ill.Prepared) -> None:
    surface = shared.surface
    faces, uv = surface.base_faces, surface.base_uv
    position, du, dv, *_ = surface.evaluate(faces, uv)
    np.testing.assert_allclose(position, surface.positions, atol=1e-9)
    normals = np.cross(du, dv)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    cosines = np.abs((normals * surface.normals).sum(axis=1))
    assert np.median(cosines) > 1 - 1e-9


def test_the_drawing_is_that_of_separate_meshes(
    shared: ill.Prepared, separate: ill.Prepared
) -> None:
    options = ill.DrawOptions(hatching=False)
    ours, theirs = draw(shared, VIEW, options), draw(separate, VIEW, options)
    if (ours.graph.arc_kind == ill.Kind.INTERSECTION).any():
        # The bottle meets itself exactly at vertices: rounding decides which triangles cross there.
        assert lengths_px(ours).sum() == pytest.approx(lengths_px(theirs).sum(), rel=0.05)
        return
    for name in ("cusps", "crossings", "loops"):
        assert ours.counts[name] == theirs.counts[name], name
    np.testing.assert_array_equal(ours.graph.arc_invisibility, theirs.graph.arc_invisibility)
    np.testing.assert_allclose(ours.graph.node_image, theirs.graph.node_image, atol=1e-3)


def test_the_field_turns_with_each_object(shared: ill.Prepared) -> None:
    field, surface = shared.field, shared.surface
    first, others = surface.objects == 0, (1, 2)
    for other in others:
        turn = PLACES[other][:3, :3]
        turn = turn / np.cbrt(np.linalg.det(turn))
        theirs = field.directions[surface.objects == other]
        np.testing.assert_allclose(theirs, field.directions[first] @ turn.T, atol=1e-9)
    assert len(field.singular_triangles) % len(PLACES) == 0
    assert field.energy <= field.energy_initial
    draw(shared, VIEW)


def test_reports_count_every_object(shared: ill.Prepared, separate: ill.Prepared) -> None:
    assert shared.report == separate.report


def test_the_largest_and_the_finest_decide_the_level() -> None:
    mesh = torus().mesh()
    places = [placement(0.0, scale) for scale in (1.0, 4.0)]
    levels = [
        ill.prepare(
            [
                mesh.instance(place, edge_length=edge)
                for place, edge in zip(places, edges, strict=True)
            ],
            ill.PrepareOptions(field=False, triangle_budget=1_000_000),
        ).report["level_1"]
        for edges in ((1.0, 0.1), (0.025, 1.0), (1.0, 1.0))
    ]
    alone = [
        ill.prepare([torus().mesh(edge_length=edge)], ill.PrepareOptions(field=False)).report[
            "level_0"
        ]
        for edge in (0.025, 0.025, 0.25)
    ]
    assert levels == alone


@pytest.mark.parametrize("scale", [(-1.0, 1.0, 1.0), (1.0, 2.0, 1.0)], ids=["mirror", "stretched"])
def test_what_is_no_similarity_is_a_mesh_of_its_own(scale: tuple[float, ...]) -> None:
    shape, place = drape(), placement(0.4, scale)
    instance = shape.mesh().instance(place, name="other")
    assert instance.name == "other"
    found = ill.prepare([instance], OPTIONS)
    theirs = ill.prepare([moved(shape, place).mesh()], OPTIONS)
    if scale[0] > 0:
        np.testing.assert_allclose(found.surface.positions, theirs.surface.positions, atol=1e-9)
    else:  # front stays front
        outward = ill.prepare([shape.mesh()], OPTIONS).surface
        mirror = np.linalg.inv(place[:3, :3]).T
        expected = outward.normals @ mirror.T
        expected /= np.linalg.norm(expected, axis=1, keepdims=True)
        order = np.lexsort(found.surface.positions.T)
        wanted = np.lexsort((outward.positions @ place[:3, :3].T).T)
        np.testing.assert_allclose(found.surface.normals[order], expected[wanted], atol=1e-6)


def test_an_instance_of_an_instance_has_the_same_original() -> None:
    shape = torus()
    a, b = placement(0.3, 2.0, (1, 0, 0)), placement(-0.8, 0.5, (0, 1, 0))
    twice = shape.mesh().instance(a).instance(b)
    found = ill.prepare([shape.mesh(), twice], OPTIONS)
    expected = moved(shape, b @ a).positions
    alone = ill.prepare([Shape(expected, shape.face_sizes, shape.corner_vertices).mesh()], OPTIONS)
    own = found.surface.positions[found.surface.objects == 1]
    np.testing.assert_allclose(own, alone.surface.positions, atol=1e-9)


@pytest.mark.parametrize(
    "bad", [np.full((4, 4), np.nan), np.diag([1.0, 1.0, 1.0, 2.0])], ids=["nan", "projective"]
)
def test_a_placement_must_be_affine(bad: Doubles) -> None:
    with pytest.raises(ill.InvalidInput, match="placement"):
        torus().mesh().instance(bad)
