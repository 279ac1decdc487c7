"""Files of an illustration: each appears whole or not at all."""

import os
import signal
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import dataclass
from typing import Any
from uuid import uuid4

import bpy

from .. import native
from ..messages import IllustrateError, said
from .png import png_of
from .stamps import append_stamp

FORMATS = ("svg", "png", "json", "blend")
PLOT_FORMATS = ("pdf", "dxf")
"""Written as plots, always on the page of the scene's plot settings (plot/plots.py)."""

READS_STROKES = frozenset({"blend", "png"})
"""Written from the strokes in the scene: all of them, or the colours of their pens."""


@dataclass(frozen=True)
class Page:
    """What a file is made from."""

    scene: Any
    drawing: Any  # illustrate_native.Drawing
    camera: Any  # CameraArrays
    names: list[str]  # of the meshes
    strokes: list[Any]  # the objects that hold the strokes; none needed but by READS_STROKES
    width_mm: float = 200.0
    svg_style: str = "centerline"
    made_by: dict[str, Any] | None = None  # the stamp (stamps.py)
    areas: Sequence[Any] = ()  # Areas (plot/areas.py) to be filled in SVG and PNG
    tracks: bool = False  # SVG and JSON tell which strokes are the same in other frames


def prepare_folder(folder: str) -> None:
    """Makes the folder where it is missing. Raises IllustrateError where nothing can be written."""
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise IllustrateError(
            said(
                'Nothing can be written to the folder "{folder}" ({why}): choose another one',
                folder=folder,
                why=error.strerror,
            )
        ) from error


def not_written(path: str, error: Exception) -> IllustrateError:
    """What is said of a file that cannot be written."""
    return IllustrateError(said('"{path}" cannot be written: {error}', path=path, error=error))


def write_file(path: str, page: Page) -> None:
    """Writes the format that the name of `path` ends with, one of FORMATS.

    Raises IllustrateError when the file cannot be written; then there is none.
    """
    file_format = os.path.splitext(path)[1][1:]
    try:
        if file_format == "blend":
            write_blend(path, page.made_by)
        else:
            _write(path, {"svg": _svg, "png": png_of, "json": _json}[file_format](page))
    except (OSError, RuntimeError) as error:
        raise not_written(path, error) from error


def write_blend(
    path: str,
    made_by: dict[str, Any] | None = None,
    saving: AbstractContextManager[None] | None = None,
) -> None:
    """A copy of the open file as it is, illustration and all; the open file stays the open file.

    saving: what is entered while it is saved. Raises OSError, RuntimeError, and what `saving`
    raises; then nothing is written.
    """
    with _whole(path) as unfinished, _no_preview(), saving or nullcontext():
        bpy.ops.wm.save_as_mainfile(filepath=unfinished, copy=True, check_existing=False)
        if made_by is not None:
            append_stamp(unfinished, made_by)


@contextmanager
def _no_preview() -> Iterator[None]:
    """Meanwhile Blender puts no picture of what it saves into the user's cache of thumbnails."""
    paths = bpy.context.preferences.filepaths
    before, paths.file_preview_type = paths.file_preview_type, "NONE"
    try:
        yield
    finally:
        paths.file_preview_type = before


@contextmanager
def _whole(path: str) -> Iterator[str]:
    """A name beside `path` to write to, which becomes `path` at the end when all went well.

    No other process has that name, on whatever machine.
    """
    folder, name = os.path.split(os.path.abspath(path))
    stem, extension = os.path.splitext(name)
    unfinished = os.path.join(folder, f".{stem}.{uuid4().hex[:12]}.unfinished{extension}")
    with _removed_at_the_end(unfinished):
        yield unfinished
        os.replace(unfinished, path)


@contextmanager
def _removed_at_the_end(path: str) -> Iterator[None]:
    """Removes the file, also when SIGTERM ends the process, which it does at once elsewhere."""

    def end(number: int, _frame: Any) -> None:
        _remove(path)
        signal.signal(number, before)
        os.kill(os.getpid(), number)

    # None stands for a handler that Python has not set and cannot set again.
    before = signal.signal(signal.SIGTERM, end) or signal.SIG_DFL
    try:
        yield
    finally:
        _remove(path)
        signal.signal(signal.SIGTERM, before)


def _remove(path: str) -> None:
    with suppress(FileNotFoundError):
        os.remove(path)


def write_bytes(path: str, data: bytes) -> None:
    """Writes a file that is there already in memory. Raises IllustrateError as `write_file`."""
    try:
        _write(path, data)
    except OSError as error:
        raise not_written(path, error) from error


def _write(path: str, data: bytes) -> None:
    with _whole(path) as unfinished, open(unfinished, "wb") as file:
        file.write(data)


def _svg(page: Page) -> bytes:
    camera = page.camera
    text: str = native.load_part("svg").to_svg(
        page.drawing,
        camera.width_px,
        camera.height_px,
        page.width_mm,
        page.svg_style,
        page.made_by,
        page.tracks,
        [area.region for area in page.areas],
    )
    return text.encode()


def _json(page: Page) -> bytes:
    """With the camera, without which the width of strokes in the world is not known."""
    camera, made_by = page.camera, page.made_by
    if made_by is not None:
        matrices = {name: getattr(camera, name).tolist() for name in ("projection", "view")}
        made_by = {**made_by, "camera": matrices}
    text: str = native.load_part("drawing_json").to_json(
        page.drawing, camera.width_px, camera.height_px, page.names, made_by, page.tracks
    )
    return text.encode()
