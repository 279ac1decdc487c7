"""What the headless command does with its arguments."""

import os
from typing import Any

import bpy

from ..messages import IllustrateError
from ..output.files import prepare_folder
from ..plot.areas import check_fills
from ..reading.tone_images import choose_file
from ..ui import presets
from .arguments import MERGE, parse, parse_merge
from .frames import Sequence
from .lines import complain
from .merge import merge_into
from .plots import choose as choose_plot


def main(arguments: list[str], summaries: list[str] | None = None) -> int:
    """Draws or merges; the exit code. `summaries` gets a line for each frame drawn.

    Raises SystemExit for a wrong command line.
    """
    try:
        if arguments[:1] == [MERGE]:
            return _merge(parse_merge(arguments[1:]))
        return _draw(parse(arguments), [] if summaries is None else summaries)
    except IllustrateError as error:
        complain(f"error: {error}")
        return 1


def _draw(chosen: Any, summaries: list[str]) -> int:
    if chosen.blend:
        _open(chosen.blend)
    if chosen.preset:
        presets.apply(chosen.preset)
    if chosen.tone_from:
        bpy.context.scene.illustrate.tone_source = chosen.tone_from.upper()
    if chosen.tone_image:
        choose_file(bpy.context.scene, chosen.tone_image)
    choose_plot(bpy.context.scene, chosen)
    check_fills(bpy.context.scene)
    prepare_folder(chosen.out)
    return 1 if Sequence(chosen, summaries).draw() else 0


def _merge(chosen: Any) -> int:
    begins = chosen.begun_from if chosen.begun_from and not os.path.exists(chosen.into) else None
    _open(begins or chosen.into)
    merge_into(chosen.into, chosen.out, chosen.frames, chosen.partial)
    return 0


def _open(path: str) -> None:
    try:
        bpy.ops.wm.open_mainfile(filepath=os.path.abspath(path))
    except RuntimeError as error:
        raise IllustrateError(f'"{path}" cannot be opened: {error}') from error
