"""The next frame of a sequence, begun while the frame before it is hatched.

It is read and prepared, and its lines and tones are found: all that does not depend on the strokes
of the frame before. Blender is at the next frame from then on: what is made of the frame before
must not ask it.
"""

from collections.abc import Callable
from dataclasses import dataclass

from ..running import jobs
from ..running.illustration import VIEWED, Illustration, Request, computing, viewing


@dataclass
class Begun:
    """A frame that has been read, or that could not be."""

    frame: int
    request: Request | None = None
    steps: jobs.Steps[None] | None = None  # up to its view
    step: jobs.Step | None = None  # None: its view is there
    error: Exception | None = None

    @property
    def exposure(self) -> float | None:
        """That of its view, or None where there is none."""
        view = None if self.request is None else self.request.view
        return None if view is None else float(view.exposure)

    def go_on(self) -> None:
        """Takes the next step once the job before it is done."""
        if self.step is None or not self.step.job.is_done:
            return
        assert self.steps is not None
        done, self.step = self.step, None
        try:
            self.step = jobs.go_on(self.steps, done.job)
        except StopIteration:
            pass
        except Exception as error:
            self.error = error

    def let_go(self) -> None:
        """Stops what is being made."""
        if self.steps is not None:
            self.steps.close()
        if self.step is not None:
            jobs.let_go(self.step.job)


def begin(frame: int, read: Callable[[int], Request]) -> Begun:
    """Reads a frame and starts its view. What goes wrong is raised once it is its turn."""
    begun = Begun(frame)
    try:
        begun.request = read(frame)
        begun.steps = viewing(begun.request, (0.0, VIEWED))
        begun.step = next(begun.steps, None)
    except Exception as error:
        begun.error = error
    return begun


def view(begun: Begun, progress: jobs.Progress) -> Request:
    """Waits for the view of a frame; what the frame was begun from."""
    if begun.error is None and begun.step is not None:
        assert begun.steps is not None
        step, begun.step = begun.step, None
        jobs.run(begun.steps, progress, step)
    if begun.error is not None:
        raise begun.error
    assert begun.request is not None
    return begun.request


def drawn(
    request: Request, progress: jobs.Progress, begin_next: Callable[[], Begun | None]
) -> Illustration:
    """The illustration of a frame. begin_next: called once it is being drawn."""
    steps = computing(request, (VIEWED, 1.0))
    try:
        step = next(steps)
    except StopIteration as end:  # the very drawing is there
        made: Illustration = end.value
        return made
    try:
        following = begin_next()
    except BaseException:
        jobs.let_go(step.job)
        raise

    def report(fraction: float, stage: str) -> bool:
        if following is not None:
            following.go_on()
        return progress(fraction, stage)

    return jobs.run(steps, report, step)
