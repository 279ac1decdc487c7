"""Frames one after another: strokes that live on, and meshes that deform."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_drawing, digest
from illustrate_native import svg
from illustrate_native.drawing_json import from_json, to_json
from numpy.typing import NDArray
from scipy.spatial import cKDTree  # type: ignore[import-untyped]
from shapes import SIZE_PX, Shape, look_at, sphere, torus

HATCHES = [int(kind) for kind in (ill.Kind.HATCH, ill.Kind.CROSS_HATCH, ill.Kind.UNDERCUT)]
LEVEL = ill.PrepareOptions(level=3)


def orbit(frames: int, degrees: float = 1.0) -> list[ill.Camera]:
    turns = np.radians(degrees * np.arange(frames))
    return [look_at((2 * np.sin(t), -2 * np.cos(t), 0.8)) for t in turns]


def lines_of(drawing: ill.Drawing) -> NDArray[np.intp]:
    return np.flatnonzero(~np.isin(drawing.kinds, HATCHES))


def points_of(drawing: ill.Drawing, stroke: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Image points of a stroke, and what each counts as along it."""
    image = drawing.image[drawing.offsets[stroke] : drawing.offsets[stroke + 1]]
    steps = np.linalg.norm(np.diff(image, axis=0), axis=1)
    return image, drawing.stroke_starts[stroke] + np.r_[0, np.cumsum(steps)]


def test_a_drawing_alone_begins_a_sequence() -> None:
    drawing = ill.draw(ill.prepare([torus().mesh()], LEVEL), look_at())
    strokes = len(drawing.kinds)
    assert drawing.frame == 0
    assert (drawing.stroke_ids == np.arange(strokes)).all()
    assert not drawing.stroke_births.any()
    assert not drawing.stroke_starts.any()
    assert not len(drawing.stroke_deaths)


def test_lines_live_on_while_the_camera_turns() -> None:
    drawings = list(ill.draw_sequence([torus().mesh()], orbit(6), prepare_options=LEVEL))
    for last, now in pairwise(drawings):
        assert now.frame == last.frame + 1
        lengths = np.array([points_of(now, s)[1][-1] for s in lines_of(now)])
        lived = np.isin(now.stroke_ids[lines_of(now)], last.stroke_ids)
        assert lengths[lived].sum() > 0.95 * lengths.sum()
        assert len(np.unique(now.stroke_ids)) == len(now.stroke_ids)
        assert (now.stroke_births[np.isin(now.stroke_ids, last.stroke_ids)] < now.frame).all()
        gone = np.setdiff1d(last.stroke_ids, now.stroke_ids)
        assert (now.stroke_deaths == gone).all()


def test_what_is_drawn_along_a_line_does_not_swim() -> None:
    drawings = list(ill.draw_sequence([torus().mesh()], orbit(6), prepare_options=LEVEL))
    slides = []
    for last, now in pairwise(drawings):
        before = {int(last.stroke_ids[s]): s for s in lines_of(last)}
        for stroke in lines_of(now):
            if int(now.stroke_ids[stroke]) not in before:
                continue
            there, then = points_of(last, before[int(now.stroke_ids[stroke])])
            here, counts = points_of(now, stroke)
            distance, nearest = cKDTree(there).query(here)
            slides.append(np.abs(counts - then[nearest])[distance < 1.5])
    assert np.median(np.concatenate(slides)) < 1.5


def test_only_hatches_and_where_closed_lines_begin_depend_on_the_frame_before() -> None:
    prepared = ill.prepare([torus().mesh()], LEVEL)
    options = ill.DrawOptions(hatching=False)
    first, second = orbit(2, 3.0)
    alone = ill.draw(prepared, second, options)
    after = ill.draw(prepared, second, options, previous=ill.draw(prepared, first, options))
    assert (alone.offsets == after.offsets).all()
    for start, end in pairwise(alone.offsets):
        one, other = alone.image[start:end], after.image[start:end]
        assert (np.sort(one, axis=0) == np.sort(other, axis=0)).all()
    check_drawing(after, second)


def test_a_sequence_is_that_of_single_drawings() -> None:
    cameras = orbit(3)
    prepared, last = ill.prepare([torus().mesh()], LEVEL), None
    for drawing, camera in zip(
        ill.draw_sequence([torus().mesh()], cameras, prepare_options=LEVEL), cameras, strict=True
    ):
        last = ill.draw(prepared, camera, previous=last)
        assert digest(drawing) == digest(last)


def test_a_mesh_that_deforms_keeps_its_hatches_where_it_rests() -> None:
    """One half swells and turns; on the other, hatches away from it are as they were."""
    shape, view = sphere(10), look_at((0.0, -2.0, 0.3))
    moving = np.clip((shape.positions[:, 0] - 0.3) / 0.4, 0, 1)[:, None]
    poses = [np.asarray(shape.positions * (1 + 0.05 * k * moving)) for k in range(4)]
    drawings = list(
        ill.draw_sequence(
            [shape.mesh()], [view] * 4, [[pose] for pose in poses], prepare_options=LEVEL
        )
    )
    still = hatch_points(drawings[0])
    still = still[still[:, 0] < -0.5]
    alone = ill.draw(ill.prepare([shape.mesh().deformed(poses[-1])], LEVEL), view)
    off_alone = cKDTree(hatch_points(alone)).query(still)[0]
    off = cKDTree(hatch_points(drawings[-1])).query(still)[0]
    assert off.max() < 0.01, "strokes that go on into what moves get other points"
    assert (off_alone > 0.01).any()


def gaps(drawing: ill.Drawing, spacing_px: float) -> NDArray[np.float64]:
    """In spacings, how far the nearest parallel hatch is of each pixel of all hatches."""
    image, tangents, owners = [], [], []
    for stroke in np.flatnonzero(np.isin(drawing.kinds, HATCHES[:2])):
        run = slice(drawing.offsets[stroke], drawing.offsets[stroke + 1])
        for (a, b), (start, end) in zip(
            pairwise(drawing.image[run]), pairwise(drawing.points[run]), strict=True
        ):
            parts = max(1, int(np.linalg.norm(b - a)))
            image.append(a + (np.arange(parts)[:, None] + 0.5) / parts * (b - a))
            tangents += [(end - start) / np.linalg.norm(end - start)] * parts
            owners += [stroke] * parts
    points, along, owner = np.concatenate(image), np.array(tangents), np.array(owners)
    distance, nearest = cKDTree(points).query(points, k=64, distance_upper_bound=2 * spacing_px)
    found = np.isfinite(distance)
    nearest = np.where(found, nearest, 0)
    cosine = np.abs(np.einsum("nkd,nd->nk", along[nearest], along))
    found &= (owner[nearest] != owner[:, None]) & (cosine > np.sqrt(0.5))
    least = np.where(found, distance, np.inf).min(axis=1)
    return np.asarray(least[np.isfinite(least)] / spacing_px)


def test_hatches_do_not_crowd_in_a_sequence() -> None:
    """On a ball, which looks the same in each frame, though a quarter of it is new in the last."""
    options = ill.DrawOptions(
        highlight_threshold=1.0, shadow_threshold=1.0, mach_bands=False, undercuts=False
    )
    first, *_, last = ill.draw_sequence(
        [sphere(10).mesh()], orbit(30, 3.0), options=options, prepare_options=LEVEL
    )
    before, after = gaps(first, options.spacing_px), gaps(last, options.spacing_px)
    assert (after < 0.65).mean() < 0.06
    assert after.std() / after.mean() < before.std() / before.mean() + 0.06


def strokes_of(drawing: ill.Drawing) -> dict[bytes, int]:
    """The strokes by the bits of their image."""
    return {
        drawing.image[drawing.offsets[s] : drawing.offsets[s + 1]].tobytes(): s
        for s in range(len(drawing.kinds))
    }


@pytest.mark.parametrize("shape", [torus(), sphere(10)])
def test_a_view_that_rests_is_drawn_the_same_again(shape: Shape) -> None:
    prepared, view = ill.prepare([shape.mesh()], LEVEL), look_at((0.3, -1.5, 0.8))
    first = ill.draw(prepared, view)
    assert ill.Kind.HATCH in first.kinds
    second = ill.draw(prepared, view, previous=first)
    assert strokes_of(second).keys() == strokes_of(first).keys()
    again = ill.draw(ill.prepare([shape.mesh()], LEVEL), view, previous=second)
    assert strokes_of(again).keys() == strokes_of(first).keys()


def test_what_rests_beside_something_that_moves_keeps_its_strokes() -> None:
    """A ball passes before a ring: of the ring only strokes near it are others."""
    ring, ball, view = torus(), sphere(6), look_at((0.0, -1.0, 2.0))

    small = replace(ball, positions=0.25 * ball.positions)
    start = [ring.mesh(), small.moved((0.6, 0.0, 0.6)).mesh()]
    moved = [None, small.moved((0.65, 0.0, 0.6)).positions]
    first, second = ill.draw_sequence(
        start, [view, view], [[None, None], moved], prepare_options=LEVEL
    )
    of_ball = np.repeat(first.objects == 1, np.diff(first.offsets))
    middle = first.image[of_ball].mean(axis=0)
    reach = np.linalg.norm(first.image[of_ball] - middle, axis=1).max() + 60
    kept = strokes_of(second)
    lost = [
        s for bits, s in strokes_of(first).items() if first.objects[s] == 0 and bits not in kept
    ]
    assert lost, "the ball hides other hatches than before"
    for stroke in lost:
        line = first.image[first.offsets[stroke] : first.offsets[stroke + 1]]
        assert np.linalg.norm(line - middle, axis=1).min() < reach


def test_strokes_live_on_beside_something_that_comes_or_goes() -> None:
    """A ball comes before a ring in the list, and goes."""
    ring, ball = torus().mesh(name="ring"), sphere(5).moved((0.0, 9.0, 0.0)).mesh(name="ball")
    view = look_at((0.0, -1.0, 2.0))
    alone = ill.prepare([ring], LEVEL)
    both = ill.prepare([ball, ring], LEVEL, previous=alone)
    first = ill.draw(alone, view)
    second = ill.draw(both, view, previous=first)
    third = ill.draw(ill.prepare([ring], LEVEL, previous=both), view, previous=second)
    of_ring = {s: n for s, n in strokes_of(second).items() if second.objects[n] == 1}
    assert of_ring.keys() == strokes_of(first).keys() == strokes_of(third).keys()
    ids = {int(second.stroke_ids[n]) for n in of_ring.values()}
    assert ids == set(first.stroke_ids.tolist()) == set(third.stroke_ids.tolist())


def hatch_points(drawing: ill.Drawing) -> NDArray[np.float64]:
    """Points along all hatches, a hundredth apart."""
    found = []
    for stroke in np.flatnonzero(np.isin(drawing.kinds, HATCHES[:2])):
        line = drawing.points[drawing.offsets[stroke] : drawing.offsets[stroke + 1]]
        for a, b in pairwise(line):
            parts = max(1, int(np.linalg.norm(b - a) / 0.01))
            found.append(a + np.linspace(0, 1, parts + 1)[:, None] * (b - a))
    return np.concatenate(found)


def test_lines_of_a_chunk_are_those_of_the_whole_and_a_full_warm_up_gives_its_hatches() -> None:
    prepared, cameras = ill.prepare([torus().mesh()], LEVEL), orbit(4, 2.0)

    def drawn(views: list[ill.Camera]) -> ill.Drawing:
        last = None
        for view in views:
            last = ill.draw(prepared, view, previous=last)
        assert last is not None
        return last

    whole, again, chunk = drawn(cameras), drawn(cameras), drawn(cameras[2:])
    assert digest(whole) == digest(again)
    assert (whole.stroke_ids == again.stroke_ids).all()
    lines = [np.sort(d.points[: d.offsets[len(lines_of(d))]], axis=0) for d in (whole, chunk)]
    assert np.array_equal(lines[0], lines[1])


def test_files_tell_which_strokes_are_the_same() -> None:
    [_, drawing] = ill.draw_sequence([torus().mesh()], orbit(2), prepare_options=LEVEL)
    text = to_json(drawing, SIZE_PX, SIZE_PX, ["Torus"], tracks=True)
    stored = from_json(text)
    assert (stored.stroke_ids == drawing.stroke_ids).all()
    assert (stored.stroke_starts == drawing.stroke_starts).all()
    untold = from_json(to_json(drawing, SIZE_PX, SIZE_PX))
    assert (untold.stroke_ids == -1).all()
    page = svg.to_svg(drawing, SIZE_PX, SIZE_PX, tracks=True)
    assert all(f'data-id="{number}" ' in page for number in drawing.stroke_ids)
    assert "data-id" not in svg.to_svg(drawing, SIZE_PX, SIZE_PX)


def test_what_does_not_fit_together_is_named() -> None:
    mesh = sphere().mesh()
    with pytest.raises(ill.InvalidInput, match="positions has 3 rows, but the mesh has"):
        mesh.deformed(np.zeros((3, 3)))
    short = ill.draw_sequence([mesh], orbit(2), [None], prepare_options=LEVEL)
    next(short)
    with pytest.raises(ill.InvalidInput, match="positions has nothing for frame 1"):
        next(short)
    with pytest.raises(ill.InvalidInput, match="positions has 2 arrays for 1 meshes"):
        next(ill.draw_sequence([mesh], orbit(1), [[None, None]], prepare_options=LEVEL))


def test_a_deformed_mesh_has_the_same_faces() -> None:
    shape = sphere()
    mesh = shape.mesh(name="ball").deformed(2 * shape.positions)
    prepared = ill.prepare([mesh], LEVEL)
    assert mesh.name == "ball"
    assert np.abs(np.linalg.norm(prepared.surface.positions, axis=1) - 2).max() < 0.2
