"""Jobs: started, looked at, stopped, dropped, at any moment."""

from __future__ import annotations

import random
import subprocess
import sys
import time
from pathlib import Path

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_drawing, digest, lengths_px, prepared_of
from numpy.typing import NDArray
from shapes import Shape, cube, drape, klein_bottle, look_at, torus

PATIENCE_S = 60.0
TIMES = 100
LONG = ill.PrepareOptions(level=5, triangle_budget=10**8)


def long_job() -> ill.Job:
    """Takes far longer than any test waits."""
    return ill.start_prepare([torus(32, 16).mesh()], LONG)


def test_jobs_make_what_is_made_at_once() -> None:
    options = ill.PrepareOptions(level=2)
    job = ill.start_prepare([torus().mesh()], options)
    assert job.wait(PATIENCE_S) and job.is_done
    prepared = job.result()
    assert job.result() is prepared
    view = ill.start_draw(prepared, look_at(), lights=[ill.Light("head")])
    assert view.wait(PATIENCE_S)
    fraction, stage = view.poll()
    assert 0 < fraction <= 1 and stage
    again = ill.draw(ill.prepare([torus().mesh()], options), look_at(), lights=[ill.Light("head")])
    assert digest(view.result()) == digest(again)
    drawing = view.result()
    assert view.result() is drawing


def test_a_job_follows_a_previous_drawing() -> None:
    prepared = prepared_of(torus())
    first = ill.draw(prepared, look_at())
    job = ill.start_draw(prepared, look_at(), previous=first)
    assert job.wait(PATIENCE_S) and job.result().frame == 1


def test_a_view_is_made_before_the_drawing_that_it_follows() -> None:
    prepared, lights = prepared_of(torus()), [ill.Light("head")]
    job = ill.start_view(prepared, look_at(), lights=lights)
    first = ill.draw(prepared, look_at(), lights=lights)
    assert job.wait(PATIENCE_S)
    view = job.result()
    assert view.exposure == first.tone.exposure == 1
    drawing = view.start_draw(first)
    assert drawing.wait(PATIENCE_S)
    at_once = ill.draw(prepared, look_at(), lights=lights, previous=first)
    assert digest(drawing.result()) == digest(at_once) == digest(view.draw(previous=first))
    assert drawing.result().frame == 1
    other = ill.view(prepared, look_at(), lights=lights)
    assert digest(other.draw()) == digest(first)


@pytest.mark.parametrize("shape", [cube(), torus(), klein_bottle(), drape()])
def test_lines_and_a_draft_come_before_the_whole(shape: Shape) -> None:
    camera = look_at()
    view = ill.view(prepared_of(shape), camera, lights=[ill.Light("head")])
    lines, draft, whole = (view.draw(detail=detail) for detail in ("lines", "draft", "whole"))
    for drawing in (lines, draft, whole):
        check_drawing(drawing, camera)
        assert np.array_equal(points_of_lines(drawing), points_of_lines(whole))
    assert lines.kinds.max() < ill.Kind.HATCH
    assert 0 < hatched_px(draft) < 1.2 * hatched_px(whole)
    job = view.start_draw(detail="draft")
    assert job.wait(PATIENCE_S) and digest(job.result()) == digest(draft)
    assert digest(view.draw()) == digest(whole), "drafts leave nothing behind"


def test_a_draft_is_followed_and_follows() -> None:
    view = ill.view(prepared_of(torus()), look_at())
    draft, alone = view.draw(detail="draft"), view.draw()
    after = view.draw(previous=draft)
    assert after.frame == 1 and hatched_px(after) > 0.9 * hatched_px(alone)
    followed = view.draw(previous=alone, detail="draft")
    assert hatched_px(followed) > 0.9 * hatched_px(alone), "a draft follows what was placed"


def test_a_detail_that_there_is_none_of_is_refused() -> None:
    view = ill.view(prepared_of(torus()), look_at())
    for draw in (view.draw, view.start_draw):
        with pytest.raises(
            ill.InvalidInput, match="detail is 'fine', expected 'lines', 'draft' or"
        ):
            draw(detail="fine")


def points_of_lines(drawing: ill.Drawing) -> NDArray[np.float64]:
    is_line = np.repeat(drawing.kinds < ill.Kind.HATCH, np.diff(drawing.offsets))
    return drawing.points[is_line]


def hatched_px(drawing: ill.Drawing) -> float:
    """How long the hatches are, but those of undercuts, which drafts have none of."""
    is_hatch = np.isin(drawing.kinds, (ill.Kind.HATCH, ill.Kind.CROSS_HATCH))
    return float(lengths_px(drawing)[is_hatch].sum())


def test_a_view_keeps_what_it_is_of() -> None:
    view = ill.view(prepared_of(torus()), look_at())
    assert len(view.draw().kinds)


def test_views_tell_how_far_they_are_and_stop() -> None:
    prepared, told = prepared_of(torus()), set()

    def progress(_fraction: float, stage: str) -> bool:
        told.add(stage)
        return True

    ill.view(prepared, look_at(), progress=progress)
    assert {"contour", "visibility", "tone"} <= told
    with pytest.raises(ill.Cancelled):
        ill.view(prepared, look_at(), progress=lambda _f, _s: False)
    view = ill.view(prepared, look_at())
    with pytest.raises(ill.Cancelled):
        view.draw(progress=lambda _f, _s: False)
    assert len(view.draw().kinds)


def test_what_is_wrong_is_told_at_once_or_as_the_result() -> None:
    with pytest.raises(ill.InvalidInput, match=r"meshes\[0\]"):
        ill.start_prepare([None])  # type: ignore[list-item]
    with pytest.raises(TypeError):
        ill.start_draw(None, look_at())  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        ill.view(None, look_at())  # type: ignore[arg-type]
    options = ill.PrepareOptions(level=2)
    options.triangle_budget = -5
    job = ill.start_prepare([cube().mesh()], options)
    assert job.wait(PATIENCE_S)
    with pytest.raises(ill.InvalidInput, match="triangle_budget"):
        job.result()


def test_there_is_no_result_before_the_end() -> None:
    job = long_job()
    with pytest.raises(ill.InvalidInput, match="not done"):
        job.result()
    assert not job.wait(0.001)
    job.cancel()
    assert job.wait(PATIENCE_S)
    with pytest.raises(ill.Cancelled):
        job.result()


def test_jobs_are_stopped_dropped_and_looked_at_at_any_moment() -> None:
    chance = random.Random(5)
    for _ in range(TIMES):
        job = long_job()
        time.sleep(chance.random() * 0.02)
        job.poll()
        if chance.random() < 0.5:
            job.cancel()
            job.cancel()
            assert job.wait(PATIENCE_S)
        del job


def test_what_a_job_was_given_may_go_and_change() -> None:
    shape = torus()
    meshes, options = [shape.mesh()], ill.PrepareOptions(level=2)
    job = ill.start_prepare(meshes, options)
    options.level = 0
    shape.positions[:] = 0
    meshes.clear()
    assert job.wait(PATIENCE_S)
    expected = ill.prepare([torus().mesh()], ill.PrepareOptions(level=2))
    assert np.array_equal(job.result().surface.positions, expected.surface.positions)


def test_all_jobs_are_stopped() -> None:
    jobs = [long_job() for _ in range(3)]
    ill.stop_jobs()
    assert all(job.is_done for job in jobs)
    ill.stop_jobs()


ENDS = """
import sys, time
sys.path.insert(0, sys.argv[1])
from test_jobs import long_job
jobs = [long_job(), long_job()]
time.sleep(float(sys.argv[2]))
{end}
"""


@pytest.mark.parametrize("end", ["", "raise SystemExit(0)", "jobs = None"])
def test_python_ends_while_jobs_run(end: str) -> None:
    for wait in ("0", "0.03"):
        script = ENDS.format(end=end)
        command = [sys.executable, "-c", script, str(Path(__file__).parent), wait]
        ran = subprocess.run(command, timeout=PATIENCE_S, capture_output=True, check=False)
        assert ran.returncode == 0, ran.stderr.decode()
