"""How the module runs: progress, cancelling, threads."""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Callable

import illustrate_native as ill
import numpy as np
import pytest
from checker import LEVEL, digest, draw, prepared_of
from shapes import Shape, cube, drape, klein_bottle, look_at, torus


def test_progress_tells_every_stage_and_rises() -> None:
    told: list[tuple[float, str]] = []

    def progress(fraction: float, stage: str) -> bool:
        told.append((fraction, stage))
        return True

    found = ill.prepare([torus().mesh()], ill.PrepareOptions(level=LEVEL), progress=progress)
    draw(found, look_at(), progress=progress)
    assert {"sanitize", "surface", "curvature", "field", "contour", "visibility", "tone", "hatch",
            "stroke"} <= {stage for _, stage in told}  # fmt: skip
    assert all(0 <= fraction <= 1 for fraction, _ in told)
    start_of_draw = next(i for i, (_, stage) in enumerate(told) if stage == "contour")
    for part in (told[:start_of_draw], told[start_of_draw:]):
        assert (np.diff([fraction for fraction, _ in part]) >= -1e-12).all()


def test_progress_cancels_at_any_call() -> None:
    shape = torus()
    plain = digest(draw(prepared_of(shape), look_at()))
    for stop_after in (0, 1, 3, 10):
        calls = iter(range(stop_after))
        with pytest.raises(ill.Cancelled):
            draw(prepared_of(shape, field=False), look_at(),
                     progress=lambda *_, calls=calls: next(calls, None) is not None)  # fmt: skip
    half = prepared_of(shape, field=False)
    with pytest.raises(ill.Cancelled):
        draw(half, look_at(), progress=lambda _, stage: stage != "field")
    assert digest(draw(half, look_at())) == plain


def test_exception_in_progress_passes_through() -> None:
    class OwnError(Exception):
        pass

    def progress(*_: object) -> bool:
        raise OwnError

    with pytest.raises(OwnError):
        ill.prepare([cube().mesh()], progress=progress)
    with pytest.raises(OwnError):
        draw(prepared_of(cube()), look_at(), progress=progress)


@pytest.mark.parametrize("shape", [torus(), klein_bottle(), drape()])
def test_threads_do_not_change_a_byte(shape: Shape) -> None:
    found = {
        b"".join(digest(draw(prepared_of(shape, threads=n), look_at(radius=3.2),
                                 ill.DrawOptions(threads=n))))
        for n in (1, 2, 5)
    }  # fmt: skip
    assert len(found) == 1


def test_threads_may_share_a_prepared() -> None:
    shared = prepared_of(torus(), field=False)
    drawn: list[list[bytes]] = []
    workers = [
        threading.Thread(target=lambda: drawn.append(digest(draw(shared, look_at()))))
        for _ in range(4)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(drawn) == 4
    assert all(d == drawn[0] for d in drawn)


STAGES = {
    "sanitize": 4, "surface": 12, "intersections": 4, "curvature": 8, "field": 100, "contour": 4,
    "visibility": 2, "hatch curves": 16, "tone": 16, "hatch": 32, "stroke": 1,
}  # fmt: skip
"""How often each stage reports at least, for 33,000 vertices and 65,000 cells on one thread."""

EVERYTHING = ill.DrawOptions(threads=1, suggestive_contours=True, cast_shadows=True)


def stages_of(goes_on: Callable[[str], bool]) -> list[str]:
    """The stage of each report until `goes_on` says no."""
    told: list[str] = []

    def progress(_: float, stage: str) -> bool:
        told.append(stage)
        return goes_on(stage)

    mesh = torus(64, 32).mesh()
    found = ill.prepare([mesh], ill.PrepareOptions(level=2, threads=1), progress=progress)
    ill.draw(found, look_at(radius=1.4), EVERYTHING, progress=progress)
    return told


def test_every_stage_reports_often_enough_to_be_stopped() -> None:
    told = Counter(stages_of(lambda _: True))
    assert not {stage for stage, least in STAGES.items() if told[stage] < least}, told
    assert set(told) - {""} <= set(STAGES)


@pytest.mark.parametrize("stage", STAGES)
def test_every_stage_stops_when_it_is_told_to(stage: str) -> None:
    after: list[str] = []

    def goes_on(now: str) -> bool:
        after.extend([now] if after or now == stage else [])
        return not after

    with pytest.raises(ill.Cancelled):
        stages_of(goes_on)
    assert after == [stage]


def note_down() -> tuple[list[str], Callable[[float, str], bool]]:
    """A list of stages and the progress that fills it."""
    told: list[str] = []

    def progress(_: float, stage: str) -> bool:
        told.append(stage)
        return True

    return told, progress


def test_trees_and_intersections_are_ready_for_the_first_drawing() -> None:
    told, progress = note_down()
    options = ill.PrepareOptions(level=2, field=False)
    found = ill.prepare([torus(64, 32).mesh()], options, progress=progress)
    assert told[-1] == "intersections"
    lines = ill.DrawOptions(hatching=False)
    ill.draw(found, look_at(), lines, progress=lambda _, stage: stage != "intersections")


def test_the_first_drawing_of_a_huge_surface_without_field_searches_in_progress() -> None:
    options = ill.PrepareOptions(level=4, field=False)
    found = ill.prepare([torus(64, 32).mesh()], options)
    lines = ill.DrawOptions(hatching=False)
    with pytest.raises(ill.Cancelled):
        ill.draw(found, look_at(), lines, progress=lambda _, stage: stage != "intersections")
    told, progress = note_down()
    ill.draw(found, look_at(), lines, progress=progress)
    assert {"surface", "intersections"} < set(told)
