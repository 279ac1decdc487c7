"""The live drawing: what Illustrate would draw, in the viewports themselves, while one works.

`LiveDrawing` knows what is stale and goes, one job at a time, through reading, preparing and
drawing; `live_view.py` shows what is there. While a view moves its rough lines are shown; when it
rests its exact lines are drawn, then its hatches; both at once where that is soon. Until the next
is whole the last one stays. What changes faster than it can be drawn is skipped, never queued;
shapes that never rest have the lines of each that was prepared, and hatches once they rest.
"""

import time
from dataclasses import dataclass, field, replace
from typing import Any

from .. import native
from ..messages import IllustrateError, said
from ..preferences import preference
from ..reading.kept_images import IMAGES
from ..reading.scene import SceneArrays, put_into_world
from ..running.illustration import (
    Illustration,
    lights_of,
    native_meshes,
    read_arrays,
    request_of,
    start_drawing,
)
from ..running.jobs import let_go
from ..settings import scene_settings as settings
from .views import View

TICK_S = 0.02  # between looks
POLL_S = 0.005  # the same while a job runs
REST_S = 0.05  # that a view must rest before it is drawn
SOON_S = 0.25  # the last whole drawing took: the next is not kept waiting by one of lines alone
READING_SHARE = 2.0  # of the time that reading took until it is read again
PREPARE, LINES, WHOLE = "prepare", "lines", "whole"


@dataclass
class Seen:
    """What is known of one viewport."""

    view: View
    moved_at: float
    lines: Illustration | None = None  # exact, without hatches
    whole: Illustration | None = None
    lines_of: Any = None  # version and view that they were begun for
    whole_of: Any = None

    @property
    def key(self) -> bytes:
        """Of the view."""
        return self.view.key

    def drawing_of(self, part: str) -> Illustration | None:
        """Lines or whole where they are of this view, however old the scene."""
        made, of = (self.lines, self.lines_of) if part == LINES else (self.whole, self.whole_of)
        return made if of is not None and of[1] == self.key else None


@dataclass
class Running:
    """The job that runs."""

    job: Any
    part: str
    version: int
    arrays: SceneArrays
    seen: Seen | None = None
    key: bytes = b""
    request: Any = None
    begun_at: float = field(default_factory=time.monotonic)

    @property
    def has_hatches(self) -> bool:
        """It draws hatches, which take long."""
        return self.request is not None and bool(self.request.draw["hatching"])


class LiveDrawing:
    """What has been read, prepared and drawn, and what is stale of it."""

    def __init__(self) -> None:
        self.running: Running | None = None
        self.forget()

    def forget(self) -> None:
        """Lets go of everything, and of the job."""
        self._drop_job()
        IMAGES.forget()
        self.views: dict[int, Seen] = {}
        self.prepared: Any = None
        self.features: Any = None
        self.arrays: SceneArrays | None = None  # what was prepared
        self.read: SceneArrays | None = None  # what is to be prepared next
        self.problem = ""
        self.version = 0  # of the scene: shapes, lights, settings
        self.shapes_are_stale = True
        self.look_is_stale = True
        self.chosen: Any = None  # values of the settings
        self.reading_s = 0.0
        self.read_at = float("-inf")
        self.whole_s = float("inf")  # that the last whole drawing took

    def _drop_job(self) -> None:
        if self.running is not None:
            let_go(self.running.job)
        self.running = None

    def look(self, pointer: int, view: View) -> Seen:
        """A viewport shows this view now; what is known of it."""
        now, seen = time.monotonic(), self.views.get(pointer)
        if seen is None:
            seen = self.views[pointer] = Seen(view, now - REST_S)
        elif seen.key != view.key:
            seen.moved_at = now
            running = self.running
            if running is not None and running.seen is seen:
                self._drop_job()
        seen.view = view
        return seen

    def is_idle(self) -> bool:
        """True when everything is drawn as the scene and the views are."""
        return (
            self.running is None
            and self.read is None
            and not (self.shapes_are_stale or self.look_is_stale)
            and self._next_part(time.monotonic() + REST_S) is None
        )

    def wholes(self) -> list[Illustration]:
        """What is drawn whole of the views."""
        found = [seen.drawing_of(WHOLE) for seen in self.views.values()]
        return [made for made in found if made is not None]

    def next_look_s(self) -> float:
        """Until there may be something to do: a job ends, or a view comes to rest."""
        if self.running is not None or self.read is not None:
            return POLL_S
        now = time.monotonic()
        waits = [seen.moved_at + REST_S - now for seen in self.views.values()]
        return min([TICK_S, *(wait for wait in waits if wait > 0)])

    def tick(self, context: Any) -> bool:
        """Takes what a job has made and starts the next; True when there is something to show."""
        self._notice_settings(context.scene)
        is_new = self._take()
        if self.running is not None and self.running.has_hatches and self.shapes_are_stale:
            self._drop_job()
        if self.running is None:
            try:
                self._start_next(context)
            except IllustrateError as error:
                is_new = is_new or str(error) != self.problem
                self.prepared, self.problem = None, str(error)
        return is_new

    def _notice_settings(self, scene: Any) -> None:
        """Settings that changed, whoever changed them."""
        values = settings.live_values(scene.illustrate)
        if values == self.chosen:
            return
        before, self.chosen = self.chosen, values
        shaping = before is None or before[0] != values[0]
        self.shapes_are_stale = self.shapes_are_stale or shaping
        self.look_is_stale = True

    def _take(self) -> bool:
        """Takes over what the job has made."""
        running = self.running
        if running is None or not running.job.is_done:
            return False
        self.running = None
        try:
            made = running.job.result()
        except Exception as error:  # the drawing before stays
            self._give_up(running, str(error))
            return True
        self.problem = ""
        if running.part == PREPARE:
            if not len(made.surface.triangles):
                no_area = said("Nothing can be drawn: no face of the meshes has an area")
                self._give_up(running, no_area)
                return True
            self.prepared, self.arrays = made, running.arrays
            self.features = native.load().rough_features(made)
            self.version += 1
        else:
            self._keep(running, made)
        return True

    def _give_up(self, running: Running, problem: str) -> None:
        """What went wrong is not tried again before something changes."""
        self.problem = problem
        if running.seen is not None:
            of = (running.version, running.key)
            running.seen.lines_of = of
            running.seen.whole_of = of if running.part == WHOLE else running.seen.whole_of

    def _keep(self, running: Running, drawing: Any) -> None:
        seen, of = running.seen, (running.version, running.key)
        assert seen is not None
        made = Illustration(drawing, self.prepared, running.arrays, running.request.warnings)
        if running.part == WHOLE:
            seen.whole, seen.whole_of = made, of
            self.whole_s = time.monotonic() - running.begun_at
        seen.lines, seen.lines_of = made, of

    def _start_next(self, context: Any) -> None:
        now = time.monotonic()
        if self.read is not None:
            self._prepare(context.scene)
            return
        if self.shapes_are_stale:
            seen = self._without_lines(now)
            if seen is not None:
                self._draw(context.scene, seen, LINES)
            elif now >= self.read_at + READING_SHARE * self.reading_s:
                self._read(context)
            return
        if self.look_is_stale and self.arrays is not None:
            self.look_is_stale = False
            depsgraph = context.evaluated_depsgraph_get()
            self.arrays = replace(self.arrays, lights=lights_of(context.scene, depsgraph))
            self.version += 1
        wanted = self._next_part(now)
        if wanted is not None:
            self._draw(context.scene, *wanted)

    def _read(self, context: Any) -> None:
        """Reads the scene, in a look of its own: Blender draws before the next."""
        start = time.perf_counter()
        self.shapes_are_stale = self.look_is_stale = False
        camera = next((seen.view.camera for seen in self.views.values()), None)
        if camera is None:
            self.shapes_are_stale = True  # nothing looks at it yet
            return
        try:
            depsgraph = context.evaluated_depsgraph_get()
            with IMAGES.asked():
                self.read = read_arrays(context.scene, depsgraph, camera, in_world=False)
        finally:
            self.reading_s, self.read_at = time.perf_counter() - start, time.monotonic()

    def _prepare(self, scene: Any) -> None:
        """Starts to prepare what has been read."""
        arrays, self.read = self.read, None
        assert arrays is not None
        put_into_world(arrays)
        job = _start_preparing(scene, arrays, self.prepared)
        self.running = Running(job, PREPARE, self.version, arrays)

    def _next_part(self, now: float) -> tuple[Seen, str] | None:
        """What is to be drawn next: lines of all views before hatches of any that take long."""
        if self.prepared is None:
            return None
        for part in (WHOLE,) if self.whole_s < SOON_S else (LINES, WHOLE):
            for seen in self._resting(now):
                of = seen.lines_of if part == LINES else seen.whole_of
                if of != (self.version, seen.key):
                    return seen, part
        return None

    def _without_lines(self, now: float) -> Seen | None:
        """A resting view that has not even lines of the shapes that were prepared last."""
        if self.prepared is None:
            return None
        return next((s for s in self._resting(now) if s.lines_of != (self.version, s.key)), None)

    def _resting(self, now: float) -> list[Seen]:
        return [seen for seen in self.views.values() if now - seen.moved_at >= REST_S]

    def _draw(self, scene: Any, seen: Seen, part: str) -> None:
        assert self.arrays is not None
        arrays = replace(self.arrays, camera=seen.view.camera)
        with IMAGES.asked():
            request = request_of(scene, arrays)
        if part == LINES and request.draw["hatching"]:
            request.draw |= {"hatching": False, "tone_image": None}
        elif part == LINES:
            part = WHOLE
        job = start_drawing(request, self.prepared)
        self.running = Running(job, part, self.version, arrays, seen, seen.key, request)


def _start_preparing(scene: Any, arrays: SceneArrays, previous: Any) -> Any:
    """As fine as the view needs, within the budget of live drawings; hatches' field for later."""
    ill, values = native.load(), settings.prepare_values(scene.illustrate)
    values["level"] = -1
    values["triangle_budget"] = min(values["triangle_budget"], preference("live_triangles"))
    options = settings.prepare_options(values, arrays.guides, scene.illustrate.guide_weight)
    options.field = False
    return ill.start_prepare(native_meshes(ill, arrays), options, previous=previous)


LIVE = LiveDrawing()
"""The live drawing of this Blender."""
