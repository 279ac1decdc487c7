"""Hatches through the module: seeding, curves on the surface, drawings that follow another."""

import illustrate_native as ill
import numpy as np
import pytest
from scipy.spatial import cKDTree  # type: ignore[import-untyped]
from shapes import Shape, cube, look_at, torus

OPTIONS = ill.PrepareOptions(level=2)
LENGTHS = [
    *("spacing_px", "undercut_spacing_px", "mach_band_px", "undercut_px", "min_length_px"),
    *("max_length_px", "step_px", "simplify_px", "taper_px"),
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


def hatch_points(drawing: ill.Drawing) -> np.ndarray:
    """Points (n, 3) of all hatches, four pixels apart or less."""
    points = []
    for i in np.flatnonzero(
        np.isin(drawing.kinds, [int(ill.Kind.HATCH), int(ill.Kind.CROSS_HATCH)])
    ):
        stroke = drawing.points[drawing.offsets[i] : drawing.offsets[i + 1]]
        shares = np.linspace(0, 1, 8, endpoint=False)
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


def test_a_drawing_of_another_surface_is_refused(prepared: ill.Prepared) -> None:
    previous = ill.draw(prepared, look_at())
    small = ill.prepare([cube().mesh()], ill.PrepareOptions(level=0))
    with pytest.raises(ill.InvalidInput, match="previous is a drawing of another surface"):
        ill.draw(small, look_at(), previous=previous)


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


def test_half_the_pixels_give_the_same_tones_and_hatches(prepared: ill.Prepared) -> None:
    drawings = []
    for size, scale in ((800, 2.0), (400, 1.0)):
        lengths = {name: scale * getattr(ill.DrawOptions(), name) for name in LENGTHS}
        drawings.append(ill.draw(prepared, look_at(size_px=size), ill.DrawOptions(**lengths)))
    fine, coarse = drawings
    assert fine.tone.cell_px == 2 * coarse.tone.cell_px
    assert (fine.tone.level == coarse.tone.level).all()
    assert (fine.tone.band != coarse.tone.band).mean() < 1e-3
    assert share_near(hatch_points(fine), hatch_points(coarse), 0.01) > 0.99
    assert share_near(hatch_points(coarse), hatch_points(fine), 0.01) > 0.99
