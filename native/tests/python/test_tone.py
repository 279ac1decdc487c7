"""Tone as a drawing shows it: bands along folds, shares, shadows, extra levels."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_drawing
from numpy.typing import NDArray
from shapes import Shape, look_at, sphere

SIZE_PX = 256


def ball(radius: float, centre: tuple[float, float, float]) -> Shape:
    unit = sphere()
    return replace(unit, positions=radius * unit.positions + np.array(centre))


@pytest.fixture(scope="module")
def balls() -> ill.Prepared:
    """A small ball before a large one."""
    shapes = [ball(1.0, (0, 0, -1.5)), ball(0.5, (0.1, 0.05, 1.0))]
    return ill.prepare([shape.mesh() for shape in shapes], ill.PrepareOptions(level=4))


CAMERA = look_at((0.0, 0.0, 1.0), radius=1.8, perspective=False, size_px=SIZE_PX)


def distance_to_outline(prepared: ill.Prepared, drawing: ill.Drawing) -> NDArray[np.float64]:
    """(h, w) px from each cell's centre to the small ball's outline, positive outside of it."""
    on_ball = prepared.surface.positions[prepared.surface.objects == 1]
    clip = np.c_[on_ball, np.ones(len(on_ball))] @ (CAMERA.projection @ CAMERA.view).T
    image = SIZE_PX / 2 * np.c_[1 + clip[:, 0], 1 - clip[:, 1]]
    middle = (image.min(axis=0) + image.max(axis=0)) / 2
    radius = (image.max(axis=0) - image.min(axis=0)).mean() / 2
    rows, columns = np.indices(drawing.tone.band.shape) + 0.5
    outside: NDArray[np.float64] = np.hypot(columns - middle[0], rows - middle[1]) - radius
    return outside


def check_bands(
    outside: NDArray[np.float64], band: NDArray[np.uint8], mach: float, cut: float
) -> None:
    slack = 0.6  # half the diagonal of a cell is in doubt, and how the outline is sampled
    assert (band[(outside > -mach + slack) & (outside < -slack)] == 1).all()
    assert (band[(outside > slack) & (outside < cut - slack)] == 2).all()
    assert not (band[outside < -mach - slack] == 1).any()
    assert not (band[(outside > cut + slack) & (outside < 2 * cut)] == 2).any()


def test_overlapping_balls_have_both_bands(balls: ill.Prepared) -> None:
    drawing = ill.draw(balls, CAMERA, ill.DrawOptions(undercut_contact=0))
    outside = distance_to_outline(balls, drawing)
    check_bands(outside, drawing.tone.band, 6, 14)
    check_drawing(drawing, CAMERA)
    bright = drawing.tone.level == 0
    assert (drawing.tone.band[bright] == 2).any(), "undercuts lie in highlights too"


def test_bands_may_be_given_in_millimetres(balls: ill.Prepared) -> None:
    lengths = ill.lengths_in_pixels(SIZE_PX / 64, mach_band_mm=2.0, undercut_mm=4.5)
    assert lengths == {"mach_band_px": 8, "undercut_px": 18}
    drawing = ill.draw(balls, CAMERA, ill.DrawOptions(undercut_contact=0, **lengths))
    check_bands(distance_to_outline(balls, drawing), drawing.tone.band, 8, 18)


@pytest.mark.parametrize(
    ("scale", "lengths", "error", "message"),
    [
        (0.0, {"undercut_mm": 1.0}, ValueError, "pixels_per_mm is 0.0"),
        (4.0, {"undercut_mm": -1.0}, ValueError, "undercut_mm is -1.0"),
        (4.0, {"undercut_px": 1.0}, TypeError, "undercut_px is no length in millimetres"),
    ],
)
def test_wrong_lengths_are_named(
    scale: float, lengths: dict[str, float], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        ill.lengths_in_pixels(scale, **lengths)


def hatch_points(drawing: ill.Drawing) -> NDArray[np.float64]:
    kinds = [int(k) for k in (ill.Kind.HATCH, ill.Kind.CROSS_HATCH, ill.Kind.UNDERCUT)]
    per_point = np.repeat(drawing.kinds, np.diff(drawing.offsets))
    points: NDArray[np.float64] = drawing.image[np.isin(per_point, kinds)]
    return points


def test_hatches_keep_out_of_mach_bands_and_fill_undercuts(balls: ill.Prepared) -> None:
    options = ill.DrawOptions(
        mach_band_px=8, undercut_px=16, highlight_threshold=0.5, undercut_contact=0
    )
    drawing = ill.draw(balls, CAMERA, options)
    outside = distance_to_outline(balls, drawing)
    points = hatch_points(drawing)
    column, row = np.minimum(points.astype(int), SIZE_PX - 1).T
    around = outside[row, column]
    assert not ((around > -7) & (around < -1)).any()
    area = {
        name: ((outside > low) & (outside < high)).sum()
        for name, low, high in (("undercut", 1, 15), ("beyond", 18, 30))
    }
    inked = {
        "undercut": ((around > 1) & (around < 15)).sum(),
        "beyond": ((around > 18) & (around < 30)).sum(),
    }
    assert inked["undercut"] / area["undercut"] > 2 * inked["beyond"] / area["beyond"]


def share(drawing: ill.Drawing, level: int) -> float:
    seen = drawing.tone.level != 255
    return float((drawing.tone.level == level).sum() / seen.sum())


def test_shares_divide_what_is_seen(balls: ill.Prepared) -> None:
    options = ill.DrawOptions(highlight_share=0.3, shadow_share=0.2, smallest_tone=0)
    drawing = ill.draw(balls, CAMERA, options)
    assert share(drawing, 0) == pytest.approx(0.3, abs=1e-3)
    assert share(drawing, 2) == pytest.approx(0.2, abs=1e-3)
    tone = drawing.tone
    assert (tone.level[tone.brightness > tone.highlight_threshold + 1e-5] == 0).all()
    options.highlight_share = None
    assert options.highlight_share is None
    again = ill.draw(balls, CAMERA, options)
    assert again.tone.highlight_threshold == 0.85
    assert again.tone.shadow_threshold == tone.shadow_threshold


def test_a_ball_shades_the_one_behind(balls: ill.Prepared) -> None:
    lights = [ill.Light("sun", (0.6, 0, 1))]
    lit = ill.draw(balls, CAMERA, lights=lights).tone
    shaded = ill.draw(balls, CAMERA, ill.DrawOptions(cast_shadows=True), lights=lights).tone
    darker = shaded.brightness < lit.brightness
    assert darker.sum() > 500 and (shaded.brightness[darker] == 0).all()
    lights = [ill.Light("sun", (0.6, 0, 1), casts_shadows=False)]
    same = ill.draw(balls, CAMERA, ill.DrawOptions(cast_shadows=True), lights=lights).tone
    assert (same.brightness == lit.brightness).all()


def ink(drawing: ill.Drawing, where: NDArray[np.bool_]) -> float:
    """Length of the hatches whose middle lies in the cells, per cell, px."""
    total = 0.0
    for i, kind in enumerate(drawing.kinds):
        if kind not in (int(ill.Kind.HATCH), int(ill.Kind.CROSS_HATCH)):
            continue
        line = drawing.image[drawing.offsets[i] : drawing.offsets[i + 1]]
        column, row = np.minimum((line[:-1] + line[1:]).T / 2, SIZE_PX - 1).astype(int)
        total += float(np.linalg.norm(np.diff(line, axis=0), axis=1)[where[row, column]].sum())
    return total / float(where.sum())


def test_extra_levels_are_hatched_more_densely(balls: ill.Prepared) -> None:
    assert ill.draw(balls, CAMERA).tone.extra.shape == (0, 0)
    options = ill.DrawOptions(
        shadow_share=0.8, extra_levels=3, undercuts=False, mach_bands=False, spacing_px=8,
        undercut_spacing_px=4, simplify_px=0.01,
    )  # fmt: skip
    drawing = ill.draw(balls, CAMERA, options)
    check_drawing(drawing, CAMERA)
    extra, shadow = drawing.tone.extra, drawing.tone.level == 2
    assert extra.shape == (SIZE_PX, SIZE_PX) and set(np.unique(extra)) == {0, 1, 2, 3}
    assert not extra[~shadow].any()
    densities = [ink(drawing, shadow & (extra == level)) for level in range(4)]
    assert all(b > 1.15 * a for a, b in pairwise(densities)), densities


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"kind": "sky"}, "light.kind is 'sky'"),
        ({"kind": "area", "vector": (0, 0, 1), "direction": (0, 0, -1), "edges": [(1, 0, 0)]},
         "light.edges"),
        ({"kind": "spot", "vector": (0, 0, 1), "direction": (0, 0, -1)}, "light.angle_rad"),
    ],
)  # fmt: skip
def test_wrong_lights_are_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ill.InvalidInput, match=message):
        ill.Light(**arguments)


def test_lights_keep_what_they_are_given() -> None:
    area = ill.Light(
        "area", (0, 0, 3), 2.0, (0, 0, -1), edges=[(1, 0, 0), (0, 2, 0)], ellipse=True,
        falloff_distance=1.0, casts_shadows=False,
    )  # fmt: skip
    assert area.edges.tolist() == [[1, 0, 0], [0, 2, 0]]
    assert area.ellipse and not area.casts_shadows and area.falloff_distance == 1
    assert ill.Light("side").vector.tolist() == [-1, 1, 1]
    spot = ill.Light("spot", (0, 0, 3), 1.0, (0, 0, -1), 0.5, blend=0.25)
    assert spot.blend == 0.25 and spot.edges.tolist() == [[0, 0, 0], [0, 0, 0]]


# --- reflectance, exposure, ambient light

FRONT = ill.Camera(
    np.diag([0.8, 0.8, -0.1, 1.0]),
    np.array([*np.eye(4)[:2], [0, 0, 1, -3], [0, 0, 0, 1]]),
    100,
    100,
)
SQUARE = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
CORNERS = [[0, 0], [1, 0], [1, 1], [0, 1]]
FACING = ill.Light("sun", vector=(0, 0, 1))


def tone_of_square(
    lights: list[ill.Light], options: dict[str, float] | None = None, **mesh: Any
) -> ill.ToneMap:
    prepared = ill.prepare(
        [ill.PolygonMesh(SQUARE, [4], range(4), scheme="none", **mesh)],
        ill.PrepareOptions(field=False),
    )
    drawing = ill.DrawOptions(mach_bands=False, undercuts=False, cell_px=1, **(options or {}))
    return ill.draw(prepared, FRONT, drawing, lights=lights).tone


def test_faces_throw_back_their_share_of_the_light() -> None:
    tone = tone_of_square([FACING], reflectance=[0.25])
    assert np.unique(tone.brightness) == pytest.approx([0, 0.25])
    for influence in (0.0, 0.5):
        tone = tone_of_square([FACING], {"reflectance": influence}, reflectance=[0.25])
        assert tone.brightness.max() == pytest.approx(1 - 0.75 * influence)


def test_corners_shade_a_face_evenly() -> None:
    brightness = tone_of_square([FACING], reflectance=[0, 1, 1, 0]).brightness
    x = (np.arange(100) + 0.5 - 10) / 80
    inside = (x > 0) & (x < 1)
    assert brightness[50, inside] == pytest.approx(x[inside], abs=1e-6)
    assert np.ptp(brightness[15:85, 50]) < 1e-6


def test_a_texture_is_seen_where_its_uv_lie() -> None:
    checks = np.kron(np.indices((4, 4)).sum(0) % 2, np.ones((8, 8)))
    mesh: dict[str, Any] = {"uv": CORNERS, "textures": [ill.Texture(checks)], "face_textures": [0]}
    brightness = tone_of_square([FACING], **mesh).brightness
    for row in range(4):
        for column in range(4):
            place = brightness[90 - 10 - 20 * row, 10 + 10 + 20 * column]  # v is upwards
            assert place == (row + column) % 2
    with pytest.raises(ill.InvalidInput, match="uv"):
        tone_of_square([FACING], textures=mesh["textures"], face_textures=[0])
    with pytest.raises(ill.InvalidInput, match="face_textures"):
        tone_of_square([FACING], **{**mesh, "face_textures": [1]})


@pytest.mark.parametrize(
    ("shade", "width", "has_band"),
    [(0.05, 0.3, False), (1.0, 0.3, True), (0.05, 1.6, True), (0.4, 0.3, False)],
)
def test_narrow_dark_parts_have_no_mach_bands(shade: float, width: float, has_band: bool) -> None:
    """At the long sides of a strip before the square."""
    strip = [[x * width / 2, y * 0.8, 0.1] for x, y, _ in SQUARE]
    meshes = [
        ill.PolygonMesh(SQUARE, [4], range(4), scheme="none"),
        ill.PolygonMesh(strip, [4], range(4), scheme="none", reflectance=[shade]),
    ]
    prepared = ill.prepare(meshes, ill.PrepareOptions(field=False))
    options = ill.DrawOptions(mach_band_px=4)
    tone = ill.draw(prepared, FRONT, options, lights=[FACING]).tone
    size = tone.band.shape[0]
    side = tone.band[size // 3 : 2 * size // 3, int(size * (0.5 - 0.2 * width)) + 2]
    assert (side == 1).all() == has_band
    assert (side == 1).any() == has_band


def test_a_recoloured_mesh_keeps_all_that_was_prepared() -> None:
    options = ill.PrepareOptions(field=False)

    def mesh(shade: float) -> list[ill.PolygonMesh]:
        return [ill.PolygonMesh(SQUARE, [4], range(4), scheme="none", reflectance=[shade])]

    first = ill.prepare(mesh(1.0), options)
    second = ill.prepare(mesh(0.5), options, previous=first)
    assert second.timings["surface"] == 0
    bright, dark = (
        ill.draw(p, FRONT, lights=[FACING]).tone.brightness.max() for p in (first, second)
    )
    assert (bright, dark) == pytest.approx((1, 0.5))


@pytest.mark.parametrize("strength", [1e-4, 0.3, 700.0])
def test_auto_exposure_makes_the_lightest_white(strength: float) -> None:
    lamp = ill.Light("sun", vector=(0, 0, 1), strength=strength)
    tone = tone_of_square([lamp], {"auto_exposure": True}, reflectance=[0, 1, 1, 0])
    assert tone.exposure == pytest.approx(1 / (0.95 * strength), rel=0.02)
    again = tone_of_square([lamp], {"exposure": tone.exposure}, reflectance=[0, 1, 1, 0])
    assert np.array_equal(again.brightness, tone.brightness)


def test_ambient_light_comes_from_everywhere() -> None:
    away = ill.Light("sun", vector=(0, 0, -1))
    tone = tone_of_square([away, ill.Light("ambient", strength=0.3)])
    assert tone.brightness.max() == pytest.approx(0.3)
