"""Modal tasks, worked by hand: there is no window here."""

import threading
import time
from types import SimpleNamespace
from typing import Any

import pytest
from illustrate import tasks, worker
from illustrate.messages import IllustrateError
from illustrate.tasks import Step, TaskOperator

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


class Operator(TaskOperator):
    """Two steps; `gate` holds the second one up."""

    def __init__(self, fail: str = "") -> None:
        self.reports: list[Any] = []
        self.gate = threading.Event()
        self.stopped = threading.Event()
        self.undone = False
        self.fail = fail

    def report(self, kind: set[str], text: str) -> None:
        self.reports.append((kind, text))

    def task(self, _context: Any) -> tasks.Task:
        if self.fail == "start":
            raise IllustrateError("no camera")
        try:
            first = yield Step(lambda _: 20, 0, 0.5, "Frame 1")
            second = yield Step(self.slow, 0.5, 1, "Frame 2")
        finally:
            self.undone = True
        if self.fail == "end":
            raise IllustrateError("too late")
        return [("INFO", f"{first + second}")]

    def slow(self, progress: Any) -> int:
        if self.fail == "work":
            raise IllustrateError("bad mesh")
        if self.fail == "bug":
            raise ZeroDivisionError
        while not self.gate.is_set():
            if not progress(0.5, "hatch"):
                self.stopped.set()
                raise RuntimeError("cancelled")
            time.sleep(0.001)
        return 3


@pytest.fixture(autouse=True)
def _window(monkeypatch: Any) -> None:
    monkeypatch.setattr(tasks, "_has_window", lambda _: True)
    monkeypatch.setattr(tasks, "SHOWN_S", 0.0)


def run(operator: Operator, context: Any, until: Any = lambda: False) -> set[str]:
    """Timer events until the operator ends."""
    status: set[str] = operator.invoke(context, None)
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
    operator.gate.set()
    assert run(operator, context) == {"FINISHED"}
    assert operator.reports == [({"INFO"}, "23")]
    assert context.is_clean()
    assert Operator.execute(operator, context) == {"FINISHED"}
    assert len(operator.reports) == 2


def test_progress_is_shown_and_the_view_may_be_moved() -> None:
    context, operator = Context(), Operator()
    text = "Illustrate: 75 %  Frame 2  Hatching  (ESC to cancel)"
    assert run(operator, context, lambda: text in context.texts) == {"RUNNING_MODAL"}
    assert tasks.is_running()
    assert operator.modal(context, ORBIT) == {"PASS_THROUGH"}
    assert operator.modal(context, CLICK) == {"RUNNING_MODAL"}
    operator.gate.set()
    operator.cancel(context)


def test_escape_ends_at_once_and_stops_the_work() -> None:
    context, operator = Context(), Operator()
    run(operator, context, lambda: any("Frame 2" in (t or "") for t in context.texts))
    assert not is_undone(operator)
    assert operator.modal(context, ESC) == {"CANCELLED"}
    assert is_undone(operator) and context.is_clean()
    assert operator.stopped.wait(10)
    assert "cancelled" in operator.reports[-1][1]


@pytest.mark.parametrize(
    ("fail", "words"), [("start", "no camera"), ("work", "bad mesh"), ("end", "too late")]
)
def test_errors_are_reported_and_leave_nothing(fail: str, words: str) -> None:
    context, operator = Context(), Operator(fail)
    operator.gate.set()
    assert run(operator, context) == {"CANCELLED"}
    assert operator.reports == [({"ERROR"}, words)]
    assert not tasks.is_running() and (fail == "start" or context.is_clean())
    assert Operator(fail).execute(context) == {"CANCELLED"} if fail != "end" else True


def test_a_bug_is_not_swallowed_and_leaves_nothing() -> None:
    context, operator = Context(), Operator("bug")
    with pytest.raises(ZeroDivisionError):
        run(operator, context)
    assert context.is_clean()


def test_work_that_still_runs_is_stopped_and_waited_for() -> None:
    operator = Operator()
    work = worker.Worker(operator.slow)
    assert not work.is_done
    worker.stop_all()
    assert work.is_done and isinstance(work.error, RuntimeError)
