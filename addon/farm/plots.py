"""Plots of the headless command: which of its files they are, and all frames in one."""

import os
from typing import Any

import bpy

from .. import native
from ..messages import IllustrateError
from ..output.files import PLOT_FORMATS, write_bytes
from ..plot.areas import check_areas
from ..plot.plots import bytes_of, check_plot, masks_of, plot_of, summary
from ..running.illustration import Illustration
from ..ui import presets
from .lines import complain, say

OWN = "scene"


def choose(scene: Any, chosen: Any) -> None:
    """Puts what the command line says of plots into the scene. Raises IllustrateError."""
    if chosen.plot and chosen.plot != OWN:
        presets.apply(chosen.plot, presets.PLOT_FOLDER)
    settings, plot = scene.illustrate_plot, native.load_part("plot")
    if chosen.page:
        try:
            paper = plot.read_paper(chosen.page)
        except plot.PlotError as error:
            raise IllustrateError(str(error)) from error
        settings.paper = paper if isinstance(paper, str) else "OWN"
        settings.size_mm = settings.size_mm if isinstance(paper, str) else paper
    if chosen.scale:
        settings.fit, settings.scale = "scale", chosen.scale
    if chosen.order:
        settings.order = chosen.order
    if chosen.masks:
        settings.masks = True
    _check(scene, chosen)


def _check(scene: Any, chosen: Any) -> None:
    """Raises IllustrateError for what cannot be written, before any frame is drawn."""
    if chosen.masks:
        check_areas()
    files = PlotFiles(chosen)
    for extension in chosen.format:
        if files.takes(extension):
            check_plot(scene, extension)
    for extension in chosen.sequence:
        check_plot(scene, extension, True)


class PlotFiles:
    """The plots that one command writes."""

    def __init__(self, chosen: Any) -> None:
        self._sequences = chosen.sequence
        is_svg = bool(chosen.plot or chosen.page or chosen.scale or chosen.order)
        self._formats = (*PLOT_FORMATS, "svg") if is_svg else PLOT_FORMATS
        self.is_any = bool(self._sequences) or any(self.takes(e) for e in chosen.format)
        self._has_masks, self._masks = chosen.masks, dict[str, bytes]()
        self._plot: Any = None
        self._plots: list[Any] = []

    def takes(self, extension: str) -> bool:
        """True where files of this format are plots."""
        return extension in self._formats

    def add(self, scene: Any, made: Illustration, name: str) -> None:
        """Puts the drawing of a frame on its page, where any file asks for it, and makes masks."""
        if self._has_masks or (self.is_any and scene.illustrate_plot.masks):
            self._masks = masks_of(scene, made, name)
        if not self.is_any:
            return
        self._plot = plot_of(scene, made)
        for warning in self._plot.warnings:
            complain(f"warning: {warning}")
        if self._sequences:
            self._plots.append(self._plot)

    def write(self, path: str, made_by: dict[str, Any]) -> None:
        """Writes the plot of the last frame."""
        write_bytes(path, bytes_of(os.path.splitext(path)[1][1:], [self._plot], made_by))
        say(summary(path, [self._plot]))

    def write_masks(self, folder: str) -> None:
        """Writes the masks of the last frame, where there are some."""
        for name, data in self._masks.items():
            path = os.path.join(folder, name)
            write_bytes(path, data)
            say(f"Saved: '{path}'")

    def write_sequences(self, folder: str, name: str) -> None:
        """Writes the files of all frames, where there are some."""
        render = bpy.context.scene.render
        for extension in self._sequences if self._plots else ():
            path = os.path.join(folder, f"{name}.{extension}")
            rate = render.fps / render.fps_base
            write_bytes(path, bytes_of(extension, self._plots, rate=rate))
            say(f"Saved: '{path}'")
