"""Jobs: long work that runs beside Blender, in threads of the native module that know no Python.

An operator or a timer starts one, looks at it now and then, and takes what it made. Nothing here
waits but `finish`, which scripts and the background use.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from .. import native

Progress = Callable[[float, str], bool]
Result = TypeVar("Result")

LOOK_S = 0.05  # between looks at a job that is waited for
LOOKS = 2  # at a moment before it has passed


class Job(Protocol):
    """What `illustrate_native.Job` does."""

    @property
    def is_done(self) -> bool:
        """True when there is a result or an error."""

    def poll(self) -> tuple[float, str]:
        """How far it is: a share, and the name of the stage."""

    def cancel(self) -> None:
        """Asks it to stop, and does not wait."""

    def wait(self, seconds: float) -> bool:
        """Waits at most so long; True when it is done."""

    def result(self) -> Any:
        """What it made; raises what went wrong."""


@dataclass(frozen=True)
class Step:
    """A job that has begun; `start` .. `end` is its share of all."""

    job: Job
    start: float = 0.0
    end: float = 1.0
    title: str = ""  # what comes before the stage
    shares_esc: bool = False  # whether a job of Blender's that it waits for is to see ESC, too

    def state(self) -> tuple[float, str]:
        """How far all is, and the name of the stage."""
        fraction, stage = self.job.poll()
        return self.start + (self.end - self.start) * fraction, stage


class Moment:
    """A job with nothing to do: at it Blender shows what comes next, and hears ESC."""

    def __init__(self, stage: str) -> None:
        self._stage, self._looks = stage, 0

    @property
    def is_done(self) -> bool:
        """True from the third look on: Blender has drawn its windows between two of them."""
        self._looks += 1
        return self._looks > LOOKS

    def poll(self) -> tuple[float, str]:
        """The name of the stage that follows."""
        return 0.0, self._stage

    def cancel(self) -> None:
        """There is nothing to be stopped."""

    def wait(self, _seconds: float) -> bool:
        """Nothing to wait for."""
        return True

    def result(self) -> None:
        """Nothing."""


Steps = Generator[Step, Any, Result]
"""Does what needs Blender itself, yields a Step for everything long, and gets its result back."""

_leaving: list[Job] = []


def let_go(job: Job) -> None:
    """Cancels a job without waiting: it is kept until it has ended."""
    job.cancel()
    _leaving[:] = [old for old in (*_leaving, job) if not old.is_done]


def are_leaving() -> bool:
    """True while a job that was let go still runs."""
    _leaving[:] = [old for old in _leaving if not old.is_done]
    return bool(_leaving)


def stop_all() -> None:
    """Cancels all jobs and waits for their ends: nothing runs on when the add-on goes."""
    if native.is_loaded():
        native.load().stop_jobs()
    _leaving.clear()


def go_on(steps: Steps[Result], job: Job) -> Step:
    """Hands what a job made, or what went wrong, to the steps; the next of them."""
    try:
        made = job.result()
    except Exception as error:
        return steps.throw(error)
    return steps.send(made)


def run(steps: Steps[Result], progress: Progress | None = None, step: Step | None = None) -> Result:
    """Goes through steps to their end, and waits for each. step: the one that they are at."""
    try:
        step = step or next(steps)
        while True:
            finish(step, progress)
            step = go_on(steps, step.job)
    except StopIteration as end:
        result: Result = end.value
        return result
    finally:
        steps.close()


def finish(step: Step, progress: Progress | None = None) -> None:
    """Waits for a step's job; cancels it when progress returns False, or is interrupted."""
    try:
        while True:
            is_done = step.job.wait(LOOK_S)
            if progress is not None and not progress(*step.state()):
                step.job.cancel()
            if is_done:
                return
    except BaseException:
        let_go(step.job)
        raise
