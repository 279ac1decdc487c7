"""Files of an illustration: each appears whole or not at all."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import bpy

from .. import native
from ..messages import IllustrateError
from .png import png_of

FORMATS = ("svg", "png", "json", "blend")


@dataclass(frozen=True)
class Page:
    """What a file is made from."""

    scene: Any
    drawing: Any  # illustrate_native.Drawing
    camera: Any  # CameraArrays
    names: list[str]  # of the meshes
    strokes: list[Any]  # the objects that hold the strokes
    width_mm: float = 200.0
    svg_style: str = "centerline"


def prepare_folder(folder: str) -> None:
    """Makes the folder where it is missing. Raises IllustrateError where nothing can be written."""
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise IllustrateError(
            f'Nothing can be written to the folder "{folder}" '
            f"({error.strerror}): choose another one"
        ) from error


def write_file(path: str, page: Page) -> None:
    """Writes the format that the name of `path` ends with, one of FORMATS.

    Raises IllustrateError when the file cannot be written; then there is none.
    """
    file_format = os.path.splitext(path)[1][1:]
    write = {"svg": _svg, "png": _png, "json": _json, "blend": _blend}[file_format]
    try:
        with _whole(path) as unfinished:
            write(unfinished, page)
    except (OSError, RuntimeError) as error:
        raise IllustrateError(f'"{path}" cannot be written: {error}') from error


@contextmanager
def _whole(path: str) -> Iterator[str]:
    """A name beside `path` to write to, which becomes `path` at the end when all went well."""
    folder, name = os.path.split(os.path.abspath(path))
    stem, extension = os.path.splitext(name)
    unfinished = os.path.join(folder, f".{stem}.{os.getpid()}.unfinished{extension}")
    try:
        yield unfinished
        os.replace(unfinished, path)
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)


def _svg(path: str, page: Page) -> None:
    text = native.load_part("svg").to_svg(
        page.drawing, page.camera.width_px, page.camera.height_px, page.width_mm, page.svg_style
    )
    _text(path, text)


def _json(path: str, page: Page) -> None:
    text = native.load_part("drawing_json").to_json(
        page.drawing, page.camera.width_px, page.camera.height_px, page.names
    )
    _text(path, text)


def _text(path: str, text: str) -> None:
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def _png(path: str, page: Page) -> None:
    with open(path, "wb") as file:
        file.write(png_of(page))


def _blend(path: str, _page: Page) -> None:
    """A copy of the open file as it is, illustration and all; the open file stays the open file."""
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True, check_existing=False)
