"""Draws frames of the open file and writes them, one after the other.

A frame that cannot be drawn is named and gone past. All frames of a command have the exposure of
the first one; where the scene keeps strokes, each starts from the strokes of the one before. While
one is hatched, the one before is written, and the next begun (ahead.py), unless what is written
asks Blender.
"""

import os
import pathlib
import re
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import bpy

from .. import native, output
from ..messages import IllustrateError, counted
from ..output import files, stamps
from ..plot.areas import fills_of
from ..reading.tone_images import tone_of
from ..running.illustration import (
    Illustration,
    Request,
    hatches_render,
    read_request,
    shares_exposure,
)
from ..running.rendering import render_now
from . import ahead
from .lines import Progress, complain, say, time_text
from .plots import PlotFiles


def file_name(pattern: str, frame: int) -> str:
    """The pattern with the open file's name for FILE and the frame's number, padded, for ####."""
    name = pattern.replace("FILE", pathlib.Path(bpy.data.filepath).stem or "untitled")
    return re.sub("#+", lambda marks: f"{frame:0{len(marks[0])}}", name)


def sequence_name(pattern: str) -> str:
    """The name of a file of all frames: the pattern without the frame's number."""
    return file_name(re.sub("[._-]?#+", "", pattern), 0) or "sequence"


@dataclass
class Unwritten:
    """A frame that is drawn."""

    frame: int
    name: str
    made: Illustration
    seconds: float  # that it has taken so far


class Sequence:
    """The frames that one command draws."""

    def __init__(self, chosen: Any, summaries: list[str]) -> None:
        self._scene, self._chosen, self._summaries = bpy.context.scene, chosen, summaries
        self._frames = chosen.frames or [self._scene.frame_current]
        self._width_mm = chosen.width_mm or self._scene.illustrate.page_width_mm
        self._plots = PlotFiles(chosen)
        self._stamp = stamps.stamp_of(
            self._scene, self._width_mm, chosen.svg_style, self._plots.is_any
        )
        self._progress = Progress(chosen.progress, len(self._frames))
        self._follows = self._scene.illustrate.keep_strokes and native.can_seed()
        self._last: Any = None  # the drawing that the next one starts from
        self._exposure: float | None = None
        self._begun: ahead.Begun | None = None  # the next frame
        self._unwritten: Unwritten | None = None  # the one before
        self._writing_s = 0.0  # all that writing has taken
        self._failed: list[int] = []
        self._looks_ahead = not (
            "blend" in chosen.format
            or self._plots.is_any
            or chosen.masks
            or chosen.skip_existing
            or hatches_render(self._scene.illustrate)
        )

    def draw(self) -> list[int]:
        """Draws and writes all frames; those that failed."""
        try:
            for frame, following in zip(self._frames, [*self._frames[1:], None], strict=True):
                self._try(frame, partial(self._frame, frame, following))
                self._progress.end()
        finally:
            self._write_last()
            if self._begun is not None:
                self._begun.let_go()
        failed = sorted(self._failed, key=self._frames.index)
        self._plots.write_sequences(self._chosen.out, sequence_name(self._chosen.name))
        if failed:
            numbers = ", ".join(map(str, failed))
            of_all = f"of {counted(len(self._frames), 'frame')}"
            self._progress.fail(f"failed frames: {numbers} ({len(failed)} {of_all})")
        return failed

    def _try(self, frame: int, work: Callable[[], None]) -> None:
        """Does work on a frame, which is named where it fails."""
        try:
            work()
        except IllustrateError as error:
            complain(f"error: frame {frame}: {error}")
            self._failed.append(frame)
        except Exception:
            complain(f"error: frame {frame}:")
            traceback.print_exc()
            self._failed.append(frame)

    def _write_last(self) -> None:
        """Writes the frame that is drawn and not written."""
        last, self._unwritten = self._unwritten, None
        if last is not None:
            self._try(last.frame, partial(self._finish, last))

    def _frame(self, frame: int, following: int | None) -> None:
        if self._chosen.skip_existing and self._existing(frame):
            # Its strokes are in files, not at hand: the next frame cannot start from them.
            say(f"skipping existing frame {frame}")
            self._last = None
            return
        start, written_s = time.perf_counter(), self._writing_s
        self._find_exposure(frame)
        self._warm_up(frame)
        name = file_name(self._chosen.name, frame)
        made = self._drawn(frame, name, following if self._looks_ahead else None)
        seconds = time.perf_counter() - start - (self._writing_s - written_s)
        self._write_last()  # where nothing was left to draw of this one
        self._unwritten = Unwritten(frame, name, made, seconds)
        if self._begun is None:  # nothing will be drawn meanwhile
            self._write_last()

    def _finish(self, drawn: Unwritten) -> None:
        start = time.perf_counter()
        for warning in drawn.made.warnings:
            complain(f"warning: {warning}")
        self._write(drawn.made, drawn.name, drawn.frame)
        writing_s = time.perf_counter() - start
        self._writing_s += writing_s
        seconds = drawn.seconds + writing_s
        say(f"Time: {time_text(seconds)}")
        self._summaries.append(summary(drawn.name, drawn.made, seconds))
        say(self._summaries[-1])

    def _drawn(self, frame: int, name: str, following: int | None = None) -> Illustration:
        """The illustration of a frame, exposed and begun as the frames before it ask for.

        following: the frame that is begun meanwhile.
        """
        self._progress.begin(name)
        begun, self._begun = self._begun, None
        if begun is None or begun.frame != frame:
            begun = ahead.begin(frame, self._read)
        request = ahead.view(begun, self._progress)
        request.previous = self._last
        if self._exposure is None:
            self._exposure = begun.exposure

        def begin_next() -> ahead.Begun | None:
            self._write_last()
            if following is not None:
                self._begun = ahead.begin(following, self._read_following)
            return self._begun

        made = ahead.drawn(request, self._progress, begin_next)
        if self._exposure is None:
            self._exposure = made.drawing.tone.exposure
        self._last = made.drawing if self._follows else None
        return made

    def _read(self, frame: int) -> Request:
        self._scene.frame_set(frame)
        rendered = None
        if hatches_render(self._scene.illustrate):
            self._progress(0.0, "render")
            rendered = render_now(self._scene, tone_of)
        request = read_request(self._scene, bpy.context.evaluated_depsgraph_get(), rendered)
        request.follows = self._last is not None
        request.expose(self._exposure)
        return request

    def _read_following(self, frame: int) -> Request:
        request = self._read(frame)
        request.follows = self._follows
        return request

    def _warm_up(self, frame: int) -> None:
        """Draws the frames before one whose predecessor was not drawn by this command."""
        if not self._follows or self._last is not None:
            return
        begin = min(self._scene.frame_start, frame)  # before it nothing has been animated
        for earlier in frames_before(self._frames, frame, self._chosen.warm_up):
            if earlier < begin:
                continue
            try:
                self._drawn(earlier, f"warming up on frame {earlier}")
            except IllustrateError as error:
                complain(f"warning: no warming up on frame {earlier}: {error}")

    def _find_exposure(self, frame: int) -> None:
        """That of --expose-as, or of files that are there, where it is not known yet."""
        asked, settings = self._chosen.expose_as, self._scene.illustrate
        if self._exposure is not None or not shares_exposure(settings):
            return
        if asked is not None:
            try:
                self._drawn(asked, f"exposing as frame {asked}")
            except IllustrateError as error:
                raise IllustrateError(f"frame {asked}, of --expose-as: {error}") from error
            # Drawn for its light alone: it may lie anywhere in the sequence.
            self._last = None
        elif self._chosen.skip_existing:
            others = (self._existing(other) for other in self._frames if other != frame)
            stamp = next(filter(None, others), None)
            self._exposure = None if stamp is None else stamp["exposure"]

    def _existing(self, frame: int) -> dict[str, Any] | None:
        """The stamp of a frame whose files are all there, whole and made as this command would."""
        wanted = {**self._stamp, "frame": frame}
        name, stamp = file_name(self._chosen.name, frame), None
        for extension in self._chosen.format:
            stamp = stamps.read_if_same(self._path(name, extension), wanted)
            if stamp is None:
                return None
        return stamp

    def _write(self, made: Illustration, name: str, frame: int) -> None:
        scene, begun = self._scene, time.perf_counter()
        camera, areas = made.arrays.camera, fills_of(scene, made)
        strokes = []
        if files.READS_STROKES.intersection(self._chosen.format):
            strokes = output.write_drawing(
                scene, made.drawing, camera, scene.illustrate.output, made.names, areas, frame
            )
            made.seconds["strokes"] = time.perf_counter() - begun
        exposure = float(made.drawing.tone.exposure)
        page = files.Page(
            scene,
            made.drawing,
            camera,
            made.names,
            strokes,
            self._width_mm,
            self._chosen.svg_style,
            {**self._stamp, "frame": frame, "exposure": exposure},
            areas,
            self._follows,
        )
        self._plots.add(scene, made, name)
        for extension in self._chosen.format:
            begun, path = time.perf_counter(), self._path(name, extension)
            if self._plots.takes(extension):
                self._plots.write(path, page.made_by or {})
            else:
                files.write_file(path, page)
            made.seconds[extension] = time.perf_counter() - begun
            say(f"Saved: '{path}'")
        self._plots.write_masks(self._chosen.out)

    def _path(self, name: str, extension: str) -> str:
        return os.path.join(self._chosen.out, f"{name}.{extension}")


def frames_before(frames: list[int], frame: int, count: int) -> list[int]:
    """The last `count` frames before one of `frames`; before the first, in their first step.

    [5, 7, 9], 7, 3 gives [1, 3, 5].
    """
    step = frames[1] - frames[0] if len(frames) > 1 else 1
    earlier = [frames[0] - step * i for i in range(count, 0, -1)]
    sequence = [*earlier, *frames]
    place = len(earlier) + frames.index(frame)
    return sequence[place - count : place]


def summary(name: str, made: Illustration, seconds: float) -> str:
    """One line: strokes by kind, seconds per stage."""
    groups = native.load_part("line_groups").line_groups(made.drawing)
    strokes = ", ".join(f"{len(group.strokes)} {group.title}" for group in reversed(groups))
    stages = ", ".join(f"{stage} {spent:.2f}" for stage, spent in made.seconds.items())
    return (
        f"{name}: {len(made.drawing.kinds)} strokes ({strokes or 'none'}) "
        f"in {seconds:.2f} s ({stages})"
    )
