"""From a drawing and the scene's settings to a plot (illustrate_native.plot)."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

from .. import native
from ..messages import IllustrateError, amount, said
from ..output.png import hex_of
from ..reading.scene import collections_of
from ..settings.scene_settings import draw_values
from .areas import areas_of, materials_of_strokes

LENGTHS_OFF = 0.02  # share by which the drawing's page may be off the plot's before it is said


def plot_of(scene: Any, made: Any) -> Any:
    """`illustrate_native.plot.Plot` of an Illustration of the scene.

    Raises IllustrateError for settings that cannot be plotted with.
    """
    plot, camera = native.load_part("plot"), made.arrays.camera
    size = camera.width_px, camera.height_px
    with _explained():
        strokes = _strokes(plot, scene, made)
        options = _options(plot, scene, camera)
        _, placing = plot.placing_of(strokes, *size, options)
        pens = _pens(plot, scene, camera.width_px, placing.scale)
        areas = areas_of(scene, made) if scene.illustrate_plot.fill_regions else []
        options = replace(options, pens=tuple(pens))
        laid = plot.plot_of(strokes, *size, options, [area.region for area in areas])
    warnings = (*laid.warnings, *_off(scene.illustrate, placing.scale * camera.width_px))
    return replace(laid, warnings=warnings)


def _strokes(plot: Any, scene: Any, made: Any) -> Any:
    """What pens choose from; materials where one asks for them."""
    things = [plot.Thing(name, collections_of(scene, name)) for name in made.names]
    chosen = scene.illustrate_plot
    by_material = chosen.pens_by == "OWN" and any(pen.material for pen in chosen.pens)
    materials = materials_of_strokes(scene, made) if by_material else None
    return plot.strokes_of(made.drawing, things, materials)


def masks_of(scene: Any, made: Any, stem: str) -> dict[str, bytes]:
    """Images of where each object and material is seen, by the names of their files."""
    plot, camera = native.load_part("plot"), made.arrays.camera
    regions = [area.region for area in areas_of(scene, made)]
    return {
        name: plot.mask_of(region, camera.width_px, camera.height_px)
        for name, region in zip(plot.mask_names(regions, stem), regions, strict=True)
    }


def page_of(scene: Any, camera: Any) -> tuple[Any, Any] | None:
    """The page and the placing of the frame on it before anything is drawn; None where unknown.

    Raises IllustrateError as `plot_of` does.
    """
    plot = native.load_part("plot")
    with _explained():
        options = _options(plot, scene, camera)
        if options.fit == "lines":
            return None
        size = camera.width_px, camera.height_px
        found: tuple[Any, Any] = plot.placing_of(plot.make_strokes([]), *size, options)
    return found


@contextmanager
def _explained() -> Iterator[None]:
    """What cannot be plotted, in words for the artist."""
    try:
        yield
    except native.load_part("plot").PlotError as error:
        raise IllustrateError(said("Nothing is plotted: {error}", error=error)) from error


def _options(plot: Any, scene: Any, camera: Any) -> Any:
    """PlotOptions but the pens."""
    chosen = scene.illustrate_plot
    return plot.PlotOptions(
        *_page(chosen),
        fit=chosen.fit,
        scale=_mm_per_px(scene, camera) if chosen.fit == "scale" else 0.0,
        order=chosen.order,
        wet_mm=chosen.wet_mm,
        wet_passes=chosen.wet_passes,
        tolerance_mm=chosen.tolerance_mm,
        machine=plot.Machine(chosen.down_mm_s, chosen.up_mm_s, chosen.lift_s),
    )


def _mm_per_px(scene: Any, camera: Any) -> float:
    """Of the scale of the scene's units. Raises IllustrateError for a perspective camera."""
    if camera.projection[3][2] != 0:
        raise IllustrateError(
            said(
                "A camera with perspective has no scale: make it orthographic, or choose another "
                "Fit"
            )
        )
    metres = float(camera.pixel_size(np.zeros((1, 3)))[0]) * scene.unit_settings.scale_length
    return float(1000 * metres / scene.illustrate_plot.scale)


def _pens(plot: Any, scene: Any, width_px: int, mm_per_px: float) -> list[Any]:
    """The pens that the settings ask for."""
    chosen = scene.illustrate_plot
    if chosen.pens_by == "ONE":
        return list(plot.one_pen(chosen.pen_width_mm))
    if chosen.pens_by == "OWN":
        return [_own(plot, pen) for pen in chosen.pens]
    values = draw_values(scene.illustrate, width_px)
    widths = [values[f"{name}_width_px"] * mm_per_px for name in ("line", "feature", "hatch")]
    inks = {
        "Outline": "line_color",
        "Features": "feature_color",
        "Hatching": "hatch_color",
        "Hidden": "hidden_color",
    }
    pens = [
        replace(pen, colour=hex_of(getattr(scene.illustrate, inks[pen.name])))
        for pen in plot.pens_by_line(*widths)
    ]
    hidden = _dashes(chosen.hidden_dash_mm, chosen.hidden_gap_mm)
    return [replace(pens[0], dashes_mm=hidden), *pens[1:]]


def _own(plot: Any, pen: Any) -> Any:
    return plot.Pen(
        pen.name,
        pen.width_mm,
        _hex(pen.colour),
        pauses=pen.pauses,
        is_plotted=pen.is_plotted,
        is_tapered=pen.is_tapered,
        dashes_mm=_dashes(pen.dash_mm, pen.gap_mm),
        kinds=tuple(sorted(pen.kinds)),
        objects=(pen.target.name,) if pen.target else (),
        collections=(pen.collection.name,) if pen.collection else (),
        materials=(pen.material.name,) if pen.material else (),
    )


def _dashes(dash_mm: float, gap_mm: float) -> tuple[float, ...]:
    return (dash_mm, gap_mm) if dash_mm > 0 and gap_mm > 0 else ()


def _hex(colour: Any) -> str:
    """Such as '#1a2b3c', of a colour as it is shown."""
    return "#" + "".join(f"{round(255 * value):02x}" for value in colour)


def _off(settings: Any, width_mm: float) -> Iterator[str]:
    """That millimetres of the drawing's settings are others on this page."""
    if settings.unit == "MILLIMETRE" and (abs(settings.page_width_mm / width_mm - 1) > LENGTHS_OFF):
        yield said(
            "The picture is {width:.1f} mm wide on the page and was drawn for {drawn:.1f} mm: set "
            "Page Width, under Output, to {width:.1f} for distances in true millimetres",
            width=width_mm,
            drawn=settings.page_width_mm,
        )


def check_plot(scene: Any, extension: str, is_sequence: bool = False) -> None:
    """Raises IllustrateError for what a scene cannot be plotted with, before it is drawn.

    That is a format or library that is not there, a page without room, and pens that draw nothing.
    """
    plot, chosen = native.load_part("plot"), scene.illustrate_plot
    with _explained():
        plot.check(extension, is_sequence, chosen.fill_regions or chosen.masks)
        plot.make_page(*_page(chosen))
        if chosen.pens_by != "LINES":
            plot.check_pens(_pens(plot, scene, 1, 1.0))


def _page(chosen: Any) -> tuple[Any, ...]:
    """Paper, orientation, margins, bleed."""
    is_own = chosen.paper == "OWN"
    paper = tuple(chosen.size_mm) if is_own else chosen.paper
    orientation = "auto" if is_own else chosen.orientation
    return paper, orientation, tuple(chosen.margins_mm), chosen.bleed_mm


def bytes_of(
    extension: str, plots: list[Any], made_by: dict[str, Any] | None = None, rate: float = 24.0
) -> bytes:
    """The file of plots. Raises IllustrateError for a format or library that is not there."""
    with _explained():
        data: bytes = native.load_part("plot").file_of(extension, plots, made_by, rate)
    return data


def summary(path: str, plots: list[Any]) -> str:
    """What a plot takes, in a line."""
    costs = sum((plot.costs for plot in plots[1:]), plots[0].costs)
    layers = amount(len(plots[0].layers), "layer")
    pages = f"{amount(len(plots), 'page')}, " if len(plots) > 1 else ""
    return said(
        "{name}: {parts}, {down:.1f} m drawn, {up:.1f} m with the pen up, about {time}",
        name=os.path.basename(path),
        parts=f"{pages}{layers}, {amount(costs.strokes, 'stroke')}",
        down=costs.down_mm / 1000,
        up=costs.up_mm / 1000,
        time=minutes(costs.seconds),
    )


def minutes(seconds: float) -> str:
    """Such as '3 min 20 s'."""
    whole, rest = divmod(round(seconds), 60)
    return f"{whole} min {rest} s" if whole else f"{rest} s"


class Planned:
    """The plot that was made last, to be looked at in the viewport."""

    def __init__(self) -> None:
        self.scene_name = ""
        self.plot: Any = None

    def remember(self, scene_name: str, plot: Any) -> None:
        """From now on it is this one."""
        self.scene_name, self.plot = scene_name, plot


PLANNED = Planned()
"""The last plot of this Blender."""
