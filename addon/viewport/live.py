"""The live drawing: what Illustrate would draw, in the viewports themselves, while one works.

`LiveDrawing` knows what is stale and goes, one job at a time, through reading, preparing and
drawing; `live_view.py` shows what is there. While a view moves its rough lines are shown; when it
rests its exact lines are drawn, then a draft of its hatches, then the whole; all at once where that
is soon. Until the next is whole the last one stays, and no draft takes its place. What changes
faster than it can be drawn is skipped, never queued; shapes that never rest have the lines of each
that was prepared, and hatches once they rest.
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
    start_view,
)
from ..running.jobs import let_go
from ..settings import scene_settings as settings
from .views import View

TICK_S = 0.02  # between looks
POLL_S = 0.005  # the same while a job runs
REST_S = 0.03  # that a view must rest before it is drawn
SOON_S = 0.25  # the last whole drawing took: the next is not kept waiting by its parts
TONES_SOON_S = 0.1  # its tones took: the next lines are not kept waiting by a drawing without them
READING_SHARE = 2.0  # of the time that reading took until it is read again
PREPARE, VIEW = "prepare", "view"
LINES, DRAFT, WHOLE = "lines", "draft", "whole"  # as the native module has them (View.draw)
Version = tuple[int, bytes]  # of the scene, and the key of a view


@dataclass
class Seen:
    """What is known of one viewport: what has been made of each part, and what it was begun for."""

    view: View
    moved_at: float
    made: dict[str, Illustration] = field(default_factory=dict)
    of: dict[str, Version] = field(default_factory=dict)
    ahead: Any = None  # the request whose lines and tones have been found (illustrate_native.View)

    @property
    def key(self) -> bytes:
        """Of the view."""
        return self.view.key

    def drawing_of(self, part: str) -> Illustration | None:
        """Lines, draft or whole where they are of this view, however old the scene."""
        of = self.of.get(part)
        return self.made.get(part) if of is not None and of[1] == self.key else None

    def hatched(self) -> Illustration | None:
        """The whole where there is one of this view, else a draft."""
        return self.drawing_of(WHOLE) or self.drawing_of(DRAFT)

    def wants(self, part: str, of: Version) -> bool:
        """True where it lacks a part; a draft is only for those that have no whole to show."""
        if part == DRAFT and self.drawing_of(WHOLE) is not None:
            return False
        return self.of.get(part) != of


@dataclass
class Running:
    """The job that runs."""

    job: Any
    part: str
    arrays: SceneArrays
    of: Version = (0, b"")  # that it was begun for
    seen: Seen | None = None
    request: Any = None

    @property
    def has_hatches(self) -> bool:
        """It draws hatches, or is on the way to them: that takes long."""
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
        self.whole_s = float("inf")  # that the last whole drawing took, from its lines on
        self.tones_s = float("inf")  # that its tones took of this

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
            seen.moved_at, seen.ahead = now, None
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
        elif running.part == VIEW:
            assert running.seen is not None
            running.request.view = made
            running.seen.ahead, running.seen.of[VIEW] = running.request, running.of
            return False
        else:
            self._keep(running, made)
        return True

    def _give_up(self, running: Running, problem: str) -> None:
        """What went wrong is not tried again before something changes."""
        self.problem = problem
        if running.seen is not None:
            running.seen.ahead = None
            parts = (LINES,) if running.part == LINES else (LINES, DRAFT, WHOLE)
            running.seen.of.update(dict.fromkeys(parts, running.of))

    def _keep(self, running: Running, drawing: Any) -> None:
        """Of every drawing the lines, too."""
        seen = running.seen
        assert seen is not None
        made = Illustration(drawing, self.prepared, running.arrays, running.request.warnings)
        for part in (LINES, running.part):
            seen.made[part], seen.of[part] = made, running.of
        if running.part == WHOLE:
            seen.ahead = None
            seen.made.pop(DRAFT, None)
            self.whole_s = sum(drawing.timings.values())
            self.tones_s = drawing.timings["tone"]

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
        self.running = Running(job, PREPARE, arrays)

    def _next_part(self, now: float) -> tuple[Seen, str] | None:
        """What is to be drawn next: lines of all views before hatches of any that take long."""
        if self.prepared is None:
            return None
        for part in (WHOLE,) if self.whole_s < SOON_S else (LINES, DRAFT, WHOLE):
            for seen in self._resting(now):
                if seen.wants(part, self._version_of(seen)):
                    return seen, part
        return None

    def _without_lines(self, now: float) -> Seen | None:
        """A resting view that has not even lines of the shapes that were prepared last."""
        if self.prepared is None:
            return None
        views = self._resting(now)
        return next((seen for seen in views if seen.wants(LINES, self._version_of(seen))), None)

    def _resting(self, now: float) -> list[Seen]:
        return [seen for seen in self.views.values() if now - seen.moved_at >= REST_S]

    def _version_of(self, seen: Seen) -> Version:
        return self.version, seen.key

    def _draw(self, scene: Any, seen: Seen, part: str) -> None:
        """Starts to draw a part of a view; of hatches that take long, first the view."""
        of, request = self._version_of(seen), seen.ahead
        if request is None or seen.of.get(VIEW) != of:
            seen.ahead = None
            request = self._request(scene, seen)
            part = self._first_part(request, part)
        if part == VIEW:
            job = start_view(request, self.prepared)
        else:
            job = start_drawing(request, self.prepared, part)
        self.running = Running(job, part, request.arrays, of, seen, request)

    def _first_part(self, request: Any, part: str) -> str:
        """What is made first on the way to a part; a request for lines alone asks for no tones."""
        if not request.draw["hatching"]:
            return WHOLE
        if part == LINES and (self.shapes_are_stale or self.tones_s > TONES_SOON_S):
            request.draw |= {"hatching": False, "tone_image": None}
            return LINES
        return VIEW if self.whole_s >= SOON_S else part

    def _request(self, scene: Any, seen: Seen) -> Any:
        assert self.arrays is not None
        with IMAGES.asked():
            return request_of(scene, replace(self.arrays, camera=seen.view.camera))


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
