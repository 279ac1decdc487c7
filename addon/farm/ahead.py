"""The next frame of a sequence, read and being prepared while the frame before it is drawn.

Blender is at the next frame from then on: what is made of the frame before must not ask it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..running import jobs
from ..running.illustration import PREPARING, Illustration, Request, computing, preparing


@dataclass
class Begun:
    """A frame that has been read, or that could not be."""

    frame: int
    request: Request | None = None
    steps: jobs.Steps[Any] | None = None  # that prepare it
    step: jobs.Step | None = None  # None: it is prepared
    error: Exception | None = None

    def let_go(self) -> None:
        """Stops what is being prepared."""
        if self.steps is not None:
            self.steps.close()
        if self.step is not None:
            jobs.let_go(self.step.job)


def begin(frame: int, read: Callable[[int], Request]) -> Begun:
    """Reads a frame and starts to prepare it. What goes wrong is raised once it is its turn."""
    begun = Begun(frame)
    try:
        begun.request = read(frame)
        begun.steps = preparing(begun.request, (0.0, PREPARING))
        begun.step = next(begun.steps, None)
    except Exception as error:
        begun.error = error
    return begun


def drawn(
    begun: Begun, progress: jobs.Progress, meanwhile: Callable[[], None] | None
) -> Illustration:
    """The illustration of a frame. meanwhile: called once it is being drawn."""
    if begun.error is not None:
        raise begun.error
    assert begun.request is not None and begun.steps is not None
    if begun.step is not None:
        jobs.run(begun.steps, progress, begun.step)
    steps = computing(begun.request, (PREPARING, 1.0))
    try:
        step = next(steps)
    except StopIteration as end:  # the very drawing is there
        made: Illustration = end.value
        return made
    try:
        if meanwhile is not None:
            meanwhile()
    except BaseException:
        jobs.let_go(step.job)
        raise
    return jobs.run(steps, progress, step)
