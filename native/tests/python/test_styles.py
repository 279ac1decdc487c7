"""Styles that say what a render makes of an object, and of its materials."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from numpy.typing import NDArray
from shapes import Shape, look_at, plate, sphere

SIZE_PX = 320
CAMERA = look_at((0.4, -1.0, 1.6), radius=2.0, size_px=SIZE_PX)
SUN = ill.Light("sun", (-0.6, 0.3, 1.0))
PLAIN = ill.ObjectStyle()


def is_hatch(drawing: ill.Drawing) -> NDArray[np.bool_]:
    """(s,)"""
    kinds = (ill.Kind.HATCH, ill.Kind.CROSS_HATCH, ill.Kind.UNDERCUT)
    return np.isin(drawing.kinds, [int(kind) for kind in kinds])


def placed(shape: Shape, scale: float, height: float) -> Shape:
    return replace(shape, positions=shape.positions * scale + np.array([0, 0, height]))


@pytest.fixture(scope="module")
def ball_on_floor() -> ill.Prepared:
    """Object 0: a ball above object 1, a floor."""
    shapes = [placed(sphere(), 0.5, 0.7), placed(plate(32), 1.6, 0.0)]
    return ill.prepare([shape.mesh() for shape in shapes])


def drawn(prepared: ill.Prepared, *styles: ill.ObjectStyle, **values: Any) -> ill.Drawing:
    options = ill.DrawOptions(styles=list(styles), cast_shadows=True, undercuts=False, **values)
    return ill.draw(prepared, CAMERA, options, lights=[SUN])


def shadow_cells(drawing: ill.Drawing) -> int:
    return int((drawing.tone.level == 2).sum())


def test_what_the_camera_does_not_see_casts_shadows(ball_on_floor: ill.Prepared) -> None:
    unseen = drawn(ball_on_floor, ill.ObjectStyle(shadow_only=True), PLAIN)
    gone = drawn(ball_on_floor, ill.ObjectStyle(ignore=True), PLAIN)
    assert set(unseen.objects) == {1} == set(gone.objects)
    assert shadow_cells(unseen) > shadow_cells(gone) + 500
    lines = ~is_hatch(unseen)
    assert np.array_equal(
        unseen.image[: unseen.offsets[lines.sum()]], gone.image[: gone.offsets[lines.sum()]]
    )


def test_a_shadow_catcher_is_its_shadows(ball_on_floor: ill.Prepared) -> None:
    caught = drawn(ball_on_floor, PLAIN, ill.ObjectStyle(shadow_catcher=True))
    whole = drawn(ball_on_floor, PLAIN, PLAIN)
    lines, floor = ~is_hatch(caught), caught.objects == 1
    assert not (lines & floor).any() and floor.any()
    hatched = np.concatenate(
        [caught.image[caught.offsets[s] : caught.offsets[s + 1]] for s in np.flatnonzero(floor)]
    )
    cells = (hatched / caught.tone.cell_px).astype(int)
    assert (whole.tone.brightness[cells[:, 1], cells[:, 0]] < 0.5).mean() > 0.95
    unlit = drawn(ball_on_floor, PLAIN, ill.ObjectStyle(shadow_catcher=True), exposure=0.1)
    assert abs((unlit.objects == 1).sum() - floor.sum()) <= 2, "its shadows are not exposed"


@cache
def checked_ball() -> ill.Prepared:
    """A ball whose upper half is of material 1."""
    ball = sphere()
    starts = np.cumsum(ball.face_sizes) - ball.face_sizes
    heights = np.add.reduceat(ball.positions[ball.corner_vertices, 2], starts)
    materials = (heights > 0).astype(np.int32)
    return ill.prepare(
        [ill.PolygonMesh(ball.positions, ball.face_sizes, ball.corner_vertices,
                         face_materials=materials)]
    )  # fmt: skip


def heights_of(drawing: ill.Drawing, hatches: bool) -> NDArray[np.float64]:
    """Of all points of hatches, or of lines."""
    chosen = is_hatch(drawing) == hatches
    points: NDArray[np.float64] = drawing.points[np.repeat(chosen, np.diff(drawing.offsets)), 2]
    return points


def upper(style: ill.MaterialStyle) -> ill.ObjectStyle:
    return ill.ObjectStyle(materials=[ill.MaterialStyle(), style])


def test_a_material_may_be_without_lines_or_hatches() -> None:
    ball, dark = checked_ball(), {"shadow_threshold": 1.0}
    lines = drawn(ball, upper(ill.MaterialStyle(hatching=False)), **dark)
    assert heights_of(lines, hatches=False).max() > 0.5
    assert heights_of(lines, hatches=True).max() < 0.1 and heights_of(lines, hatches=True).size
    tone = drawn(ball, upper(ill.MaterialStyle(lines=False)), **dark)
    assert heights_of(tone, hatches=False).max() < 0.1 and heights_of(tone, hatches=False).size
    assert heights_of(tone, hatches=True).max() > 0.5


def test_a_material_may_have_its_own_width() -> None:
    style = upper(ill.MaterialStyle(width_scale=3))
    wide = drawn(checked_ball(), style, hatching=False, taper_px=0)
    high = wide.points[:, 2] > 0.3
    assert wide.widths[high] == pytest.approx(6) and (wide.points[:, 2] < -0.3).any()
    assert wide.widths[wide.points[:, 2] < -0.3] == pytest.approx(2)


def hatch_length(drawing: ill.Drawing, is_upper: bool) -> float:
    """In pixels, of the upper or lower half of the ball."""
    length = 0.0
    for s in np.flatnonzero(is_hatch(drawing)):
        span = slice(drawing.offsets[s], drawing.offsets[s + 1])
        steps = np.linalg.norm(np.diff(drawing.image[span], axis=0), axis=1)
        middles = drawing.points[span, 2][:-1]
        length += float(steps[(middles > 0) == is_upper].sum())
    return length


@pytest.mark.parametrize("seeding", ["surface-curves", "critical-curves"])
def test_a_material_may_have_its_own_spacing(seeding: str) -> None:
    """Half as many hatches where they are twice as far apart, and no others anywhere else."""
    ball, beside = checked_ball(), look_at((0.4, -1.0, 0.1), radius=1.0, size_px=2 * SIZE_PX)

    def hatched(scale: float) -> ill.Drawing:
        style = upper(ill.MaterialStyle(spacing_scale=scale))
        options = ill.DrawOptions(styles=[style], shadow_threshold=1.0, hatch_seeding=seeding)
        return ill.draw(ball, beside, options)

    plain, wide = hatched(1), hatched(2)
    assert hatch_length(wide, True) / hatch_length(plain, True) == pytest.approx(0.5, abs=0.1)
    assert hatch_length(wide, False) / hatch_length(plain, False) == pytest.approx(1, abs=0.1)
    for s in np.flatnonzero(is_hatch(wide)):  # each ends where its material does
        heights = wide.points[wide.offsets[s] : wide.offsets[s + 1], 2]
        assert min(heights.max(), -heights.min()) < 0.08


def test_one_spacing_for_all_materials_is_the_objects() -> None:
    ball, values = checked_ball(), {"shadow_threshold": 1.0}
    style = ill.MaterialStyle(spacing_scale=2)
    of_materials = drawn(ball, ill.ObjectStyle(materials=[style, style]), **values)
    of_object = drawn(ball, ill.ObjectStyle(spacing_scale=2), **values)
    assert np.array_equal(of_materials.image, of_object.image)


def test_the_next_frame_keeps_hatches_of_all_spacings() -> None:
    ball, beside = checked_ball(), look_at((0.4, -1.0, 0.1), radius=1.0, size_px=2 * SIZE_PX)
    style = upper(ill.MaterialStyle(spacing_scale=2))
    options = ill.DrawOptions(styles=[style], shadow_threshold=1.0)
    first = ill.draw(ball, beside, options)
    again = ill.draw(ball, beside, options, previous=first)
    assert is_hatch(again).sum() == pytest.approx(is_hatch(first).sum(), rel=0.1)
    for is_upper in (True, False):
        length = hatch_length(first, is_upper)
        assert hatch_length(again, is_upper) == pytest.approx(length, rel=0.05)
    old = again.stroke_births[is_hatch(again)] < again.frame
    assert old.mean() > 0.8


def test_strokes_end_where_the_pen_changes() -> None:
    style = ill.ObjectStyle(pen=4, materials=[ill.MaterialStyle(), ill.MaterialStyle(pen=7)])
    drawing = drawn(checked_ball(), style, taper_px=0)
    assert set(drawing.pens) == {4, 7}
    heights = [
        drawing.points[a:b, 2]
        for a, b in zip(drawing.offsets[:-1], drawing.offsets[1:], strict=True)
    ]
    reach = 0.08  # of the last point before the border
    for pen, z in zip(drawing.pens, heights, strict=True):
        assert z.min() > -reach if pen == 7 else z.max() < reach
    plain = drawn(checked_ball(), PLAIN)
    assert set(plain.pens) == {0} and len(plain.kinds) < len(drawing.kinds)


@pytest.mark.parametrize("name, value", [("width_scale", -1), ("spacing_scale", 0), ("pen", -1)])
def test_wrong_values_of_materials_are_named(name: str, value: float) -> None:
    style = ill.ObjectStyle(materials=[ill.MaterialStyle(**{name: value})])
    with pytest.raises(ill.InvalidInput, match=rf"styles\[0\]\.materials\[0\]\.{name}"):
        drawn(checked_ball(), style)
