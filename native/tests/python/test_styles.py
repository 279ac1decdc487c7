"""Styles that say what a render makes of an object, and of its materials."""

from __future__ import annotations

from dataclasses import replace
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


def checked_ball(**more: Any) -> ill.Prepared:
    """A ball whose upper half is of material 1."""
    ball = sphere()
    starts = np.cumsum(ball.face_sizes) - ball.face_sizes
    heights = np.add.reduceat(ball.positions[ball.corner_vertices, 2], starts)
    materials = (heights > 0).astype(np.int32)
    return ill.prepare(
        [ill.PolygonMesh(ball.positions, ball.face_sizes, ball.corner_vertices,
                         face_materials=materials, **more)]
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


def test_wrong_widths_of_materials_are_named() -> None:
    style = ill.ObjectStyle(materials=[ill.MaterialStyle(width_scale=-1)])
    with pytest.raises(ill.InvalidInput, match=r"styles\[0\]\.materials\[0\]\.width_scale"):
        drawn(checked_ball(), style)
