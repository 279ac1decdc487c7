"""Modal tasks, worked by hand: there is no window here."""

import time
from types import SimpleNamespace
from typing import Any

import formulas
import numpy as np
import pytest
from illustrate import native
from illustrate.messages import IllustrateError
from illustrate.running import jobs, tasks
from illustrate.running.jobs import Step
from illustrate.running.tasks import TaskOperator

TIMER, ESC, ORBIT, CLICK = (SimpleNamespace(type=t)
                            for t in ("TIMER", "ESC", "MIDDLEMOUSE", "LEFTMOUSE"))  # fmt: skip


class Context:
    """Records what a modal operator asks of the window."""

    def __init__(self) -> None:
        self.log: list[str] = []
        self.texts: list[Any] = []
        self.window = object()
        self.workspace = SimpleNamespace(status_text_set=self.texts.append)
        self.window_manager = SimpleNamespace(
            event_timer_add=lambda *_, **__: self.log.append("timer"),
            event_timer_remove=lambda _: self.log.append("no timer"),
            progress_begin=lambda *_: self.log.append("begin"),
            progress_update=lambda _: None,
            progress_end=lambda: self.log.append("end"),
            modal_handler_add=lambda _: self.log.append("modal"),
        )

    def is_clean(self) -> bool:
        asked = ["timer", "begin", "modal", "no timer", "end"]
        return self.log == asked and self.texts[-1] is None and not tasks.is_running()


class Job:
    """A job by hand: done when it is told to be."""

    def __init__(self, made: Any, is_done: bool = True) -> None:
        self.made, self.is_done, self.was_cancelled = made, is_done, False

    def poll(self) -> tuple[float, str]:
        return 0.5, "hatch"

    def cancel(self) -> None:
        self.was_cancelled = True

    def wait(self, _seconds: float) -> bool:
        return self.is_done

    def result(self) -> Any:
        assert self.is_done
        if isinstance(self.made, Exception):
            raise self.made
        return self.made


class Operator(TaskOperator):
    """Two steps; the second one is done when the test says so."""

    def __init__(self, fail: str = "", is_done: bool = True) -> None:
        self.reports: list[Any] = []
        made = {"work": IllustrateError("bad mesh"), "bug": ZeroDivisionError()}.get(fail, 3)
        self.slow = Job(made, is_done)
        self.undone = False
        self.fail = fail

    def report(self, kind: set[str], text: str) -> None:
        self.reports.append((kind, text))

    def task(self, _context: Any) -> tasks.Task:
        if self.fail == "start":
            raise IllustrateError("no camera")
        try:
            first = yield Step(Job(20), 0, 0.5, "Frame 1")
            second = yield Step(self.slow, 0.5, 1, "Frame 2")
        finally:
            self.undone = True
        if self.fail == "end":
            raise IllustrateError("too late")
        return [("INFO", f"{first + second}")]


@pytest.fixture(autouse=True)
def _window(monkeypatch: Any) -> None:
    monkeypatch.setattr(tasks, "_has_window", lambda _: True)
    monkeypatch.setattr(tasks, "SHOWN_S", 0.0)


def run(operator: Operator, context: Any, until: Any = lambda: False) -> set[str]:
    """Starts the operator; then timer events until it ends."""
    return run_on(operator, context, until, operator.invoke(context, None))


def run_on(
    operator: Operator,
    context: Any,
    until: Any = lambda: False,
    status: set[str] | None = None,
) -> set[str]:
    """Timer events until the operator ends."""
    status = status or {"RUNNING_MODAL"}
    for _ in range(2000):
        if status != {"RUNNING_MODAL"} or until():
            break
        time.sleep(0.001)
        status = operator.modal(context, TIMER)
    return status


def is_undone(operator: Operator) -> bool:
    return operator.undone


def test_a_task_runs_to_its_end() -> None:
    context, operator = Context(), Operator()
    assert run(operator, context) == {"FINISHED"}
    assert operator.reports == [({"INFO"}, "23")]
    assert context.is_clean()
    assert Operator.execute(operator, context) == {"FINISHED"}
    assert len(operator.reports) == 2


def test_progress_is_shown_and_the_view_may_be_moved() -> None:
    context, operator = Context(), Operator(is_done=False)
    text = "Illustrate: 75 %  Frame 2  Hatching  (ESC to cancel)"
    assert run(operator, context, lambda: text in context.texts) == {"RUNNING_MODAL"}
    assert tasks.is_running()
    assert operator.modal(context, ORBIT) == {"PASS_THROUGH"}
    assert operator.modal(context, CLICK) == {"RUNNING_MODAL"}
    operator.slow.is_done = True
    assert run_on(operator, context) == {"FINISHED"}


def test_escape_ends_at_once_and_stops_the_work() -> None:
    context, operator = Context(), Operator(is_done=False)
    run(operator, context, lambda: any("Frame 2" in (t or "") for t in context.texts))
    assert not is_undone(operator)
    assert operator.modal(context, ESC) == {"CANCELLED"}
    assert is_undone(operator) and context.is_clean()
    assert operator.slow.was_cancelled and jobs.are_leaving()
    assert "cancelled" in operator.reports[-1][1]
    operator.slow.is_done = True
    assert not jobs.are_leaving()


def test_tasks_end_with_the_addon(monkeypatch: Any) -> None:
    context, operator = Context(), Operator(is_done=False)
    run(operator, context, lambda: any("Frame 2" in (t or "") for t in context.texts))
    monkeypatch.setattr(tasks.bpy, "context", context)
    tasks.stop_all()
    assert is_undone(operator) and context.is_clean() and operator.slow.was_cancelled


@pytest.mark.parametrize(
    ("fail", "words"), [("start", "no camera"), ("work", "bad mesh"), ("end", "too late")]
)
def test_errors_are_reported_and_leave_nothing(fail: str, words: str) -> None:
    context, operator = Context(), Operator(fail)
    assert run(operator, context) == {"CANCELLED"}
    assert operator.reports == [({"ERROR"}, words)]
    assert not tasks.is_running() and (fail == "start" or context.is_clean())
    assert Operator(fail).execute(context) == {"CANCELLED"}


def test_a_bug_is_not_swallowed_and_leaves_nothing() -> None:
    context, operator = Context(), Operator("bug")
    with pytest.raises(ZeroDivisionError):
        run(operator, context)
    assert context.is_clean()


def test_steps_that_are_waited_for_tell_their_progress_and_can_be_stopped() -> None:
    told: list[tuple[float, str]] = []

    def steps() -> jobs.Steps[int]:
        return (yield Step(Job(20), 0, 0.5)) + (yield Step(Job(3), 0.5, 1))

    def progress(fraction: float, stage: str) -> bool:
        told.append((fraction, stage))
        return False

    assert jobs.run(steps(), progress) == 23
    assert told == [(0.25, "hatch"), (0.75, "hatch")]


def test_native_jobs_end_with_the_addon() -> None:
    ill = native.load()
    positions, faces = formulas.torus(1, 0.4, 32, 16)
    mesh = ill.PolygonMesh(positions, [4] * len(faces), np.concatenate(faces))
    job = ill.start_prepare([mesh], ill.PrepareOptions(level=5, triangle_budget=10**8))
    jobs.let_go(job)
    jobs.stop_all()
    assert job.is_done and not jobs.are_leaving()
    with pytest.raises(ill.Cancelled):
        job.result()
