"""Keyframes of the JSON files of frames that were drawn apart."""

import gc
import os
import pathlib
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import bpy
import numpy as np

from .. import native, output
from ..messages import IllustrateError, counted, quoted, said
from ..output.files import not_written, write_blend
from ..output.saving import only_saved
from ..output.strokes import Sheet
from ..reading.scene import CameraArrays
from .lines import complain, say

MOST_NAMED = 20
Made = tuple[str, str]  # version and digest of the settings


@dataclass
class Found:
    """The frames of a folder, and what is wrong with the folder."""

    sheets: list[Sheet] = field(default_factory=list)  # whole, of the same settings, by frame
    missing: list[int] = field(default_factory=list)
    damaged: list[str] = field(default_factory=list)  # names of files
    foreign: list[str] = field(default_factory=list)

    @property
    def problems(self) -> list[str]:
        """One line for each kind of problem."""
        told = []
        if self.missing:
            told.append(said("Missing frames: {frames}", frames=", ".join(map(str, self.missing))))
        if self.damaged:
            told.append(said("Damaged files: {names}", names=quoted(self.damaged, MOST_NAMED)))
        if self.foreign:
            told.append(
                said(
                    "Files of other settings, of another version, of a frame that is there already "
                    "or not of Illustrate: {names}",
                    names=quoted(self.foreign, MOST_NAMED),
                )
            )
        return told


def find_frames(folder: str, wanted: list[int] | None = None) -> Found:
    """Reads the JSON files of a folder.

    wanted: the frames that must be there, others are left out; without it those from the first
    to the last, in the smallest step between any two. Of files of several settings or versions the
    most frequent count, in a tie those of the first file. Raises IllustrateError where the folder
    cannot be read.
    """
    found, read = Found(), []
    with _no_garbage_collection():
        for path in _json_files(folder):
            try:
                read.append((path.name, _read(path)))
            except (OSError, ValueError) as error:
                kind = found.foreign if isinstance(error, _Foreign) else found.damaged
                kind.append(path.name)
    made = Counter(stamp for _, (stamp, _) in read).most_common(1)
    sheets: dict[int, Sheet] = {}
    for name, (stamp, sheet) in read:
        if wanted is not None and sheet.frame not in wanted:
            continue
        if stamp != made[0][0] or sheet.frame in sheets:
            found.foreign.append(name)
        else:
            sheets[sheet.frame] = sheet
    found.sheets = [sheets[frame] for frame in sorted(sheets)]
    expected = _expected(sorted(sheets)) if wanted is None else wanted
    found.missing = [frame for frame in expected if frame not in sheets]
    return found


def merge(scene: Any, found: Found, partial: bool) -> list[str]:
    """Writes the frames as a bake does; warnings. Raises IllustrateError where something is wrong.

    partial: what is whole and of the same settings is written all the same.
    """
    _check(scene, found, partial)
    return [*found.problems, *output.bake_drawings(scene, found.sheets)]


def merge_into(path: str, folder: str, wanted: list[int] | None, partial: bool) -> None:
    """Writes the open file to `path` with what is merged into it. Raises IllustrateError.

    The open file is left without an illustration.
    """
    scene, found = bpy.context.scene, find_frames(folder, wanted)
    warnings: list[str] = []
    _check(scene, found, partial)
    saving = only_saved(
        write=lambda: warnings.extend(merge(scene, found, partial)),
        remove=lambda: output.clear(scene),
    )
    try:
        write_blend(os.path.abspath(path), saving=saving)
    except (OSError, RuntimeError) as error:
        raise not_written(path, error) from error
    for warning in warnings:
        complain(f"warning: {warning}")
    say(f"Saved: '{path}'")
    say(f"merged {counted(len(found.sheets), 'frame')}")


def _check(scene: Any, found: Found, partial: bool) -> None:
    """Raises IllustrateError where nothing is to be merged."""
    output.check_can_bake(scene.illustrate.output)
    if not found.sheets or (found.problems and not partial):
        if not found.problems:
            raise IllustrateError(said("Nothing was merged: there are no frames"))
        raise IllustrateError(". ".join([said("Nothing was merged"), *found.problems]))


@contextmanager
def _no_garbage_collection() -> Iterator[None]:
    """A JSON file is ten thousands of lists: looking for circles among them takes a third more."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


class _Foreign(ValueError):
    """A whole file that is none of ours."""


def _json_files(folder: str) -> list[pathlib.Path]:
    try:
        names = sorted(os.listdir(folder))
    except OSError as error:
        told = said('"{folder}" cannot be read ({why})', folder=folder, why=error.strerror)
        raise IllustrateError(told) from error
    return [pathlib.Path(folder, n) for n in names if n.endswith(".json") and n[0] != "."]


def _read(path: pathlib.Path) -> tuple[Made, Sheet]:
    """Raises ValueError for damaged files, its _Foreign for others, OSError."""
    text = path.read_text(encoding="utf-8")
    drawing = native.load_part("drawing_json").from_json(text)
    made_by = drawing.made_by
    try:
        projection, view = (np.array(made_by["camera"][n], float) for n in ("projection", "view"))
        stamp, frame = (made_by["version"], made_by["settings"]), int(made_by["frame"])
    except (KeyError, TypeError) as error:
        raise _Foreign(f"{path} does not say how it was made") from error
    camera = CameraArrays(projection, view, drawing.width_px, drawing.height_px)
    return stamp, output.sheet_of(drawing, camera, frame, drawing.object_names)


def _expected(frames: list[int]) -> list[int]:
    """From the first to the last, in the smallest step between two."""
    if len(frames) < 2:
        return frames
    step = min(b - a for a, b in pairwise(frames))
    return list(range(frames[0], frames[-1] + 1, step))
