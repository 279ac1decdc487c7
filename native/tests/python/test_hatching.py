"""Hatches through the module: seeding, curves on the surface, drawings that follow another."""

from dataclasses import replace

import illustrate_native as ill
import numpy as np
import pytest
from scipy.spatial import cKDTree  # type: ignore[import-untyped]
from shapes import Shape, cube, drape, klein_bottle, look_at, torus

OPTIONS = ill.PrepareOptions(level=2)
LENGTHS = [
    *("spacing_px", "undercut_spacing_px", "mach_band_px", "undercut_px", "min_length_px"),
    "least_spacing_px",
    *("max_length_px", "step_px", "simplify_px", "taper_px", "speck_px"),
    *("line_width_px", "feature_width_px", "hatch_width_px"),
]
# Both families everywhere, no bands.
EVERYWHERE = {
    "highlight_threshold": 1.0,
    "shadow_threshold": 1.0,
    "mach_bands": False,
    "undercuts": False,
}


def prepared_of(shape: Shape) -> ill.Prepared:
    return ill.prepare([shape.mesh()], OPTIONS)


@pytest.fixture(scope="module")
def prepared() -> ill.Prepared:
    return prepared_of(torus())


def hatch_points(drawing: ill.Drawing, parts: int = 8, in_image: bool = False) -> np.ndarray:
    """Points (n, 3), or (n, 2) px, of all hatches: so many parts of each of their segments."""
    along = drawing.image if in_image else drawing.points
    points = []
    for i in np.flatnonzero(
        np.isin(drawing.kinds, [int(ill.Kind.HATCH), int(ill.Kind.CROSS_HATCH)])
    ):
        stroke = along[drawing.offsets[i] : drawing.offsets[i + 1]]
        shares = np.linspace(0, 1, parts, endpoint=False)
        points += [stroke[:-1] + share * np.diff(stroke, axis=0) for share in shares]
    return np.concatenate(points)


def share_near(points: np.ndarray, others: np.ndarray, radius: float) -> float:
    """Share of points (n, 3) that lie within radius of one of the others (m, 3)."""
    return float((cKDTree(others).query(points)[0] < radius).mean())


def test_curves_on_the_surface_are_points_of_their_triangles(prepared: ill.Prepared) -> None:
    curves, surface = prepared.hatch_curves, prepared.surface
    assert curves.offsets[0] == 0
    assert curves.offsets[-1] == len(curves.points) == len(curves.triangles) > 1000
    assert (np.diff(curves.offsets) >= 2).all()
    b1, b2 = curves.barycentrics.T
    corners = surface.positions[surface.triangles[curves.triangles]]
    weights = np.stack([1 - b1 - b2, b1, b2], axis=1)
    np.testing.assert_allclose(curves.points, (weights[..., None] * corners).sum(1), atol=1e-12)
    assert prepared.timings["hatch_curves"] > 0


def test_both_seedings_hatch_and_others_are_named(prepared: ill.Prepared) -> None:
    even = ill.draw(prepared, look_at(), ill.DrawOptions(**EVERYWHERE))
    papers = ill.DrawOptions(hatch_seeding="critical-curves", **EVERYWHERE)
    assert ill.DrawOptions().hatch_seeding == "surface-curves"
    other = ill.draw(prepared, look_at(), papers)
    for drawing in (even, other):
        assert (drawing.kinds == int(ill.Kind.CROSS_HATCH)).sum() > 20
    assert len(even.points) != len(other.points)
    with pytest.raises(ill.InvalidInput, match="hatch_seeding is 'random'"):
        ill.DrawOptions(hatch_seeding="random")


def test_a_drawing_keeps_the_hatches_of_the_one_before(prepared: ill.Prepared) -> None:
    options = ill.DrawOptions(**EVERYWHERE)
    papers = ill.DrawOptions(hatch_seeding="critical-curves", **EVERYWHERE)
    first = ill.draw(prepared, look_at(), papers)
    turned = look_at((1.02, -2.0, 0.8))
    alone = ill.draw(prepared, turned, options)
    after = ill.draw(prepared, turned, options, previous=first)
    by_chance = share_near(hatch_points(alone), hatch_points(first), 0.02)
    kept = share_near(hatch_points(after), hatch_points(first), 0.02)
    assert kept > 0.65
    assert kept > by_chance + 0.15


def test_hatches_move_with_a_mesh_of_the_same_triangles(prepared: ill.Prepared) -> None:
    options = ill.DrawOptions(**EVERYWHERE)
    first = ill.draw(prepared, look_at(), options)
    shift = (0.3, 0.1, 0.0)
    moved = prepared_of(torus().moved(shift))
    after = ill.draw(moved, look_at(), options, previous=first)
    assert share_near(hatch_points(after) - shift, hatch_points(first), 0.02) > 0.75


def test_after_a_drawing_of_another_surface_all_is_placed_anew(prepared: ill.Prepared) -> None:
    small = ill.prepare([cube().mesh()], ill.PrepareOptions(level=0))
    options = ill.DrawOptions(**EVERYWHERE)
    alone = ill.draw(prepared, look_at(), options)
    after = ill.draw(prepared, look_at(), options, previous=ill.draw(small, look_at(), options))
    assert after.points.shape == alone.points.shape
    assert (np.sort(after.points, axis=0) == np.sort(alone.points, axis=0)).all()


def test_half_the_pixels_give_the_same_hatches(prepared: ill.Prepared) -> None:
    drawings = []
    for size, scale in ((400, 1.0), (200, 0.5)):
        options = ill.DrawOptions(
            spacing_px=8 * scale, simplify_px=0.1 * scale, taper_px=6 * scale, **EVERYWHERE
        )
        drawings.append(ill.draw(prepared, look_at(size_px=size), options))
    fine, coarse = (hatch_points(drawing) for drawing in drawings)
    assert share_near(fine, coarse, 0.01) > 0.999
    assert share_near(coarse, fine, 0.01) > 0.999


def drawing_of_width(prepared: ill.Prepared, size: int, names: list[str]) -> ill.Drawing:
    """With lengths that grow with the image, which is 200 px wide in the defaults' pixels."""
    lengths = {name: size / 200 * getattr(ill.DrawOptions(), name) for name in names}
    return ill.draw(prepared, look_at(radius=2.0, size_px=size), ill.DrawOptions(**lengths))


@pytest.mark.parametrize("shape", [torus(), klein_bottle(), drape()])
def test_twice_the_pixels_give_the_same_drawing(shape: Shape) -> None:
    prepared = prepared_of(shape)
    first, *others = (drawing_of_width(prepared, size, LENGTHS) for size in (200, 400, 800))
    for drawing in others:
        scale = drawing.tone.cell_px / first.tone.cell_px
        assert scale == drawing.tone.level.shape[1] * drawing.tone.cell_px / 200
        for array in ("offsets", "kinds", "points", "triangles", "barycentrics"):
            assert np.array_equal(getattr(drawing, array), getattr(first, array))
        np.testing.assert_allclose(drawing.image, scale * first.image, rtol=0, atol=1e-9)
        np.testing.assert_allclose(drawing.widths, scale * first.widths, rtol=1e-6)
        assert np.array_equal(drawing.graph.arc_points, first.graph.arc_points)
        assert np.array_equal(drawing.tone.level, first.tone.level)
        assert np.array_equal(drawing.tone.band, first.tone.band)


def test_lengths_on_paper_alone_decide_where_hatches_are() -> None:
    prepared = prepared_of(drape())
    on_paper = [name for name in LENGTHS if name not in ("step_px", "simplify_px")]
    coarse, fine = (drawing_of_width(prepared, size, on_paper) for size in (200, 400))
    assert len(fine.kinds) == len(coarse.kinds)
    for one, other in ((coarse, fine), (fine, coarse)):
        points = [400 / d.tone.level.shape[1] / d.tone.cell_px * hatch_points(d, parts, True)
                  for d, parts in ((one, 8), (other, 200))]  # fmt: skip
        assert share_near(points[0], points[1], 0.4) == 1, "less than 0.2 px of the smaller image"


def bows(drawing: ill.Drawing, least: float) -> np.ndarray:
    """Of each hatch of at least this length, px: its greatest distance from its chord, px."""
    result = []
    is_hatch = np.isin(drawing.kinds, [int(ill.Kind.HATCH), int(ill.Kind.CROSS_HATCH)])
    for i in np.flatnonzero(is_hatch):
        points = drawing.image[drawing.offsets[i] : drawing.offsets[i + 1]]
        way = points - points[0]
        length = np.linalg.norm(way[-1])
        if length < least:
            continue
        result.append(np.abs(way[:, 0] * way[-1, 1] - way[:, 1] * way[-1, 0]).max() / length)
    return np.array(result)


@pytest.mark.parametrize("perspective", [True, False])
def test_hatches_on_flat_faces_are_straight(perspective: bool) -> None:
    box = replace(cube(), positions=cube().positions * [1, 0.6, 1.4])
    prepared = ill.prepare([box.mesh(crease_angle_deg=40, cage=False)])
    camera = look_at((1.0, -2.0, 1.1), 1.9, perspective=perspective, size_px=512)
    drawing = ill.draw(prepared, camera, ill.DrawOptions(spacing_px=8, **EVERYWHERE))
    found = bows(drawing, 24)
    assert len(found) > 50
    assert np.percentile(found, 95) < 0.05 * 8
    assert found.max() < 0.25 * 8
