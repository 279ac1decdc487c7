"""Operators that take a while: the same task runs at once for scripts, and modal for the artist.

A task is a generator of steps (jobs.py). Its last words, the reports, are its return value. When it
is cancelled it is closed: what it must set back stands in a `finally`.
"""

import time
from collections.abc import Callable
from typing import Any

import bpy

from ..messages import IllustrateError, said
from .jobs import Steps, go_on, let_go, run

Task = Steps[list[tuple[str, str]]]

INTERVAL_S = 0.02  # between looks at the job
SHOWN_S = 0.2  # that a text stays at least
REDRAW_SHARE = 5.0  # and so many times as long as Blender takes to show it
NAVIGATION = {
    "MIDDLEMOUSE",
    "WHEELUPMOUSE",
    "WHEELDOWNMOUSE",
    "WHEELINMOUSE",
    "WHEELOUTMOUSE",
    "TRACKPADPAN",
    "TRACKPADZOOM",
    "MOUSEROTATE",
    "NDOF_MOTION",
}
STAGES = {
    "sanitize": "Mending meshes",
    "surface": "Subdividing",
    "intersections": "Finding intersections",
    "curvature": "Measuring curvature",
    "field": "Directing hatches",
    "render": "Rendering",
    "contour": "Finding silhouettes",
    "visibility": "Hiding lines",
    "tone": "Lighting",
    "hatch curves": "Tracing hatches",
    "hatch": "Hatching",
    "stroke": "Drawing strokes",
    "areas": "Filling areas",
    "order": "Ordering strokes",
    "curves": "Fitting curves",
    "file": "Writing the file",
}
"""What the artist reads for the names of stages: the native ones, and those of plots."""


_running: list["TaskOperator"] = []


def is_running() -> bool:
    """True while a modal task runs."""
    return bool(_running)


def stop_all() -> None:
    """Ends what runs, without a result: before the operators' classes go."""
    while _running:
        _running[-1].cancel(bpy.context)


def status_text(fraction: float, title: str, stage: str) -> str:
    """What the status bar says, such as 'Illustrate: 42 %  Hatching  (ESC to cancel)'."""
    name = STAGES.get(stage, stage.capitalize())
    words = "  ".join(word for word in (title, name and said(name)) if word)
    percent = f"{100 * fraction:.0f}"
    return said("Illustrate: {percent} %  {words}  (ESC to cancel)", percent=percent, words=words)


def _has_window(context: Any) -> bool:
    return not bpy.app.background and context.window is not None


class TaskOperator:
    """Mixin of operators whose job is a task."""

    report: Callable[[set[str], str], None]
    is_modal = False  # whether the task runs beside Blender

    def task(self, context: Any) -> Task:
        """The job; IllustrateError when it cannot be done."""
        raise NotImplementedError

    def execute(self, context: Any) -> set[str]:
        """Does the whole job; an error leaves the scene as it was."""
        try:
            return self._finish(run(self.task(context)))
        except IllustrateError as error:
            return self._fail(error)

    def invoke(self, context: Any, _event: Any) -> set[str]:
        """Starts the job in the background, with progress and ESC."""
        if not _has_window(context):
            return self.execute(context)
        self.is_modal = True
        self._task = self.task(context)
        try:
            self._step = next(self._task)
        except StopIteration as end:
            return self._finish(end.value)
        except IllustrateError as error:
            return self._fail(error)
        self._shown, self._shown_at = "", -SHOWN_S
        self._pause_s, self._is_redrawing = SHOWN_S, False
        manager = context.window_manager
        self._timer = manager.event_timer_add(INTERVAL_S, window=context.window)
        manager.progress_begin(0, 100)
        manager.modal_handler_add(self)
        _running.append(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        """Shows progress, hands results on, and stops on ESC; the view may be moved meanwhile."""
        if event.type == "ESC":
            self.cancel(context)
            self.report({"INFO"}, said("Illustrate: cancelled, nothing was changed"))
            return {"CANCELLED", "PASS_THROUGH"} if self._step.shares_esc else {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH" if event.type in NAVIGATION else "RUNNING_MODAL"}
        self._show_progress(context)
        if not self._step.job.is_done:
            return {"RUNNING_MODAL"}
        try:
            return self._go_on(context)
        except BaseException:
            self.cancel(context)
            raise

    def cancel(self, context: Any) -> None:
        """Ends without a result; Blender calls it too, when a file is loaded or the window goes.

        And when a file browser is closed, after which there is nothing to end.
        """
        if self not in _running:
            return
        let_go(self._step.job)
        self._task.close()
        self._clean_up(context)

    def _go_on(self, context: Any) -> set[str]:
        """Hands the result of a step to the task and takes the next."""
        try:
            self._step = go_on(self._task, self._step.job)
        except StopIteration as end:
            self._clean_up(context)
            return self._finish(end.value)
        except IllustrateError as error:
            self._clean_up(context)
            return self._fail(error)
        return {"RUNNING_MODAL"}

    def _show_progress(self, context: Any) -> None:
        """Only what has changed: every text makes Blender redraw, and keys wait meanwhile."""
        fraction, stage = self._step.state()
        text = status_text(fraction, self._step.title, stage)
        now = time.monotonic()
        if self._is_redrawing:  # the first event since: so long it took
            self._is_redrawing = False
            self._pause_s = max(SHOWN_S, REDRAW_SHARE * (now - self._shown_at))
        if text != self._shown and now - self._shown_at >= self._pause_s:
            self._shown, self._shown_at, self._is_redrawing = text, now, True
            context.window_manager.progress_update(int(100 * fraction))
            context.workspace.status_text_set(text)

    def _clean_up(self, context: Any) -> None:
        if self not in _running:
            return
        _running.remove(self)
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)

    def _finish(self, reports: list[tuple[str, str]]) -> set[str]:
        for kind, text in reports:
            self.report({kind}, text)
        return {"FINISHED"}

    def _fail(self, error: IllustrateError) -> set[str]:
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}
