"""The whole of a plot: from strokes of a picture to layers of pens on a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..line_groups import DrawingArrays, line_groups
from .curves import Curves, fitted
from .dashes import dashed
from .errors import PlotError
from .order import Cost, Machine, cost, ordered, pen_up_segments
from .pages import Box, Page, Placing, box_of, cropped, make_page, place, placed
from .pens import Layer, Pen, layers_of, one_pen
from .regions import Region, placed_regions
from .strokes import Floats, Strokes, Subject, chosen, without_repeats

ROUNDED_MM = 0.0071  # the farthest that rounding to hundredths moves a point
DOT_MM = 0.015  # strokes within a square of this size cannot be drawn


@dataclass(frozen=True)
class Thing:
    """An object of a drawing, as pens choose it."""

    name: str
    collections: tuple[str, ...] = ()


@dataclass(frozen=True)
class PlotOptions:
    """How a drawing is put on paper; docs/plot.md."""

    paper: str | tuple[float, float] = "A4"
    orientation: str = "auto"
    margin_mm: float | Box = 10.0
    bleed_mm: float = 0.0
    fit: str = "frame"
    scale: float = 0.0  # of fit 'scale': millimetres for a pixel
    pens: tuple[Pen, ...] = tuple(one_pen())
    order: str = "shortest"
    wet_mm: float = 2.0
    wet_passes: int = 4
    tolerance_mm: float = 0.02  # that curves may be off the strokes; 0: straight lines
    machine: Machine = field(default_factory=Machine)


@dataclass(frozen=True)
class Plot:
    """What is drawn, on which page."""

    page: Page
    placing: Placing
    layers: tuple[Layer, ...]  # in drawing order; none is empty
    tolerance_mm: float
    costs: Cost
    warnings: tuple[str, ...] = ()
    regions: tuple[Region, ...] = ()  # areas to be filled, below all layers
    _fitted: list[tuple[Layer, Curves]] = field(default_factory=list, repr=False, compare=False)

    def travel(self) -> list[Floats]:
        """(n, 2, 2) the ways with the pen up of each layer that is plotted, millimetres."""
        return [pen_up_segments(layer.strokes) for layer in self.layers if layer.pen.is_plotted]

    def curves(self, layer: Layer) -> Curves:
        """The strokes of a layer as curves within the tolerance, after they are rounded; kept."""
        for known, curves in self._fitted:
            if known is layer:
                return curves
        curves = fitted(layer.strokes, max(self.tolerance_mm - ROUNDED_MM, 0.0))
        self._fitted.append((layer, curves))
        return curves


def strokes_of(
    drawing: DrawingArrays,
    things: Sequence[Thing] = (),
    materials: NDArray[np.str_] | None = None,
) -> Strokes:
    """The strokes of a drawing in pixels, lowest group of lines first.

    things: what drawing.objects number; materials: (s,) the name of each stroke's material.
    """
    groups = line_groups(drawing)
    kinds = np.zeros(len(drawing.kinds), np.intp)
    for i, group in enumerate(groups):
        kinds[group.strokes] = i
    objects = np.asarray(drawing.objects, np.intp)
    names = np.full(len(kinds), "") if materials is None else np.asarray(materials)
    material_names, material = np.unique(names, return_inverse=True)
    keys = np.c_[kinds, objects, material].reshape(-1, 3)
    rows, labels = np.unique(keys, axis=0, return_inverse=True)
    subjects = tuple(
        _subject(groups[kind].title, things, thing, str(material_names[name]))
        for kind, thing, name in rows.tolist()
    )
    strokes = Strokes(
        np.asarray(drawing.image, float).reshape(-1, 2),
        np.asarray(drawing.widths, float),
        np.asarray(drawing.offsets).astype(np.intp),
        np.asarray(drawing.closed, bool),
        labels.reshape(-1).astype(np.intp),
        subjects,
    )
    return chosen(strokes, np.argsort(kinds, kind="stable"))


def _subject(kind: str, things: Sequence[Thing], index: int, material: str) -> Subject:
    thing = things[index] if 0 <= index < len(things) else Thing("")
    return Subject(kind, thing.name, thing.collections, material)


def placing_of(
    strokes: Strokes, width_px: float, height_px: float, options: PlotOptions
) -> tuple[Page, Placing]:
    """The page, and where a picture of width_px by height_px lies on it. Raises PlotError."""
    frame = (0.0, 0.0, float(width_px), float(height_px))
    page = make_page(
        options.paper,
        options.orientation,
        options.margin_mm,
        options.bleed_mm,
        is_wide=width_px > height_px,
    )
    return page, place(page, frame, options.fit, box_of(strokes), options.scale)


def plot_of(
    strokes: Strokes,
    width_px: float,
    height_px: float,
    options: PlotOptions,
    regions: Sequence[Region] = (),
) -> Plot:
    """Strokes and areas of a picture, in pixels, as a plot.

    Raises PlotError naming what cannot be done.
    """
    _check(options)
    page, placing = placing_of(strokes, width_px, height_px, options)
    laid = without_repeats(placed(without_repeats(strokes), placing))
    laid = _without_dots(without_repeats(cropped(laid, page.printed)))
    layers, warnings = layers_of(laid, list(options.pens))
    if not layers:
        raise PlotError(
            "there is nothing to plot: no pen takes any line inside the margins; check what the "
            "pens draw, and the fit"
        )
    done = tuple(_finished(layer, options) for layer in layers)
    costs = [cost(layer.strokes, options.machine) for layer in done if layer.pen.is_plotted]
    whole = sum(costs, Cost())
    areas = placed_regions(regions, placing, page.printed)
    return Plot(page, placing, done, options.tolerance_mm, whole, tuple(warnings), areas)


def _without_dots(strokes: Strokes) -> Strokes:
    """Without strokes that rounding makes one point of."""
    if not len(strokes):
        return strokes
    starts = strokes.offsets[:-1]
    low = np.minimum.reduceat(strokes.points, starts)
    high = np.maximum.reduceat(strokes.points, starts)
    return chosen(strokes, (high - low).max(axis=1) > DOT_MM)


def _check(options: PlotOptions) -> None:
    options.machine.check()
    if not 0 <= options.tolerance_mm < np.inf:
        raise PlotError(f"curves cannot be within {options.tolerance_mm:g} mm: at least 0")


def _finished(layer: Layer, options: PlotOptions) -> Layer:
    """A layer cut into dashes and put in order."""
    strokes = _without_dots(dashed(layer.strokes, layer.pen.dashes_mm))
    strokes = ordered(strokes, options.order, options.wet_mm, options.wet_passes)
    return replace(layer, strokes=strokes)
