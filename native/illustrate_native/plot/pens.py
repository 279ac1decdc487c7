"""Pens, and which strokes each of them draws."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np

from .errors import PlotError
from .strokes import Strokes, Subject, chosen

OUTLINES = ("Silhouette", "Boundary")
FEATURES = (
    "Crease",
    "Intersection",
    "Mark",
    "Material",
    "Flat Outline",
    "Suggestive Contour",
    "Ridge",
    "Valley",
    "Loose Edge",
    "Terminator",
    "Shadow Outline",
)
HATCHES = ("Hatch", "Cross-hatch", "Undercut")
HIDDEN = ("Hidden",)
_COLOUR = re.compile("#[0-9a-f]{6}")
_HIGHEST_NUMBER = 1000  # that AxiDraw reads in the name of a layer


@dataclass(frozen=True)
class Pen:
    """What draws a layer. An empty choice takes all: of kinds, objects, and so on."""

    name: str
    width_mm: float
    colour: str = "#000000"
    number: int | None = None  # in the layer's name; its place among the pens where None
    pauses: bool = False  # AxiDraw stops before it, for the pen to be changed
    is_plotted: bool = True  # False: AxiDraw shows it and leaves it out
    is_tapered: bool = False  # filled outlines, as wide as the strokes are, instead of lines
    dashes_mm: tuple[float, ...] = ()  # drawn, left out, drawn ...; empty: whole
    kinds: tuple[str, ...] = ()  # titles of groups of lines
    objects: tuple[str, ...] = ()
    collections: tuple[str, ...] = ()
    materials: tuple[str, ...] = ()

    def takes(self, subject: Subject) -> bool:
        """True where strokes of this subject are drawn with it."""
        return (
            _is_among(self.kinds, (subject.kind,))
            and _is_among(self.objects, (subject.object,))
            and _is_among(self.collections, subject.collections)
            and _is_among(self.materials, (subject.material,))
        )


@dataclass(frozen=True)
class Layer:
    """The strokes of one pen, in the order in which they are drawn."""

    pen: Pen
    number: int
    strokes: Strokes

    @property
    def label(self) -> str:
        """Such as '1 Outline', with the marks that AxiDraw reads: ! pauses, % is not plotted."""
        marks = ("!" if self.pen.pauses else "") + ("" if self.pen.is_plotted else "%")
        return f"{marks}{self.number} {self.pen.name}"


def _is_among(wanted: tuple[str, ...], names: tuple[str, ...]) -> bool:
    return not wanted or any(name in wanted for name in names)


def check_pens(pens: list[Pen]) -> None:
    """Raises PlotError for what cannot be drawn with."""
    if not pens:
        raise PlotError("there are no pens: add one")
    for pen in pens:
        named = f"pen {pen.name!r}"
        if not pen.name.strip():
            raise PlotError("a pen has no name: give it one")
        if not 0 < pen.width_mm < math.inf:
            raise PlotError(f"{named} has no width ({pen.width_mm:g} mm): give it one")
        if not _COLOUR.fullmatch(pen.colour):
            raise PlotError(f"{named} has the colour {pen.colour!r}, not one such as #1a2b3c")
        if pen.number is not None and not 0 <= pen.number <= _HIGHEST_NUMBER:
            raise PlotError(f"{named} has the number {pen.number}, not one of 0-{_HIGHEST_NUMBER}")
        _check_dashes(named, pen.dashes_mm)


def _check_dashes(named: str, dashes_mm: tuple[float, ...]) -> None:
    if len(dashes_mm) % 2:
        raise PlotError(f"{named} has an odd number of dashes and gaps: name both in turn")
    if dashes_mm and not (all(0 <= d < math.inf for d in dashes_mm) and min(dashes_mm[::2]) > 0):
        raise PlotError(f"{named} has dashes of no length: each must be positive")


def layers_of(strokes: Strokes, pens: list[Pen]) -> tuple[list[Layer], list[str]]:
    """Layers in the order of the pens, and warnings: what has no pen, and pens without strokes.

    A stroke is drawn by the first pen that takes it. Raises PlotError as `check_pens` does.
    """
    check_pens(pens)
    takers = [next((i for i, pen in enumerate(pens) if pen.takes(s)), -1) for s in strokes.subjects]
    pen_of = np.array([*takers, -1], np.intp)[strokes.labels]
    layers, warnings = [], _left_out(strokes, np.array(takers))
    for i, pen in enumerate(pens):
        taken = np.flatnonzero(pen_of == i)
        if len(taken):
            number = i + 1 if pen.number is None else pen.number
            layers.append(Layer(pen, number, chosen(strokes, taken)))
        else:
            warnings.append(f"pen {pen.name!r} has nothing to draw: there is no layer of it")
    return layers, warnings


def _left_out(strokes: Strokes, takers: np.ndarray) -> list[str]:
    counts: dict[str, int] = {}
    for label, count in enumerate(np.bincount(strokes.labels, minlength=len(takers))):
        if takers[label] < 0 and count:
            kind = strokes.subjects[label].kind
            counts[kind] = counts.get(kind, 0) + int(count)
    return [f"no pen takes {kind}: {count} strokes are not drawn" for kind, count in counts.items()]


def one_pen(width_mm: float = 0.3) -> list[Pen]:
    """A pen for everything."""
    return [Pen("All", width_mm)]


def pens_by_line(outline_mm: float, feature_mm: float, hatch_mm: float) -> list[Pen]:
    """A pen for each sort of line, lowest first; hidden lines are dashed."""
    return [
        Pen("Hidden", feature_mm, "#4d4d4d", kinds=HIDDEN, dashes_mm=(2.0, 1.0)),
        Pen("Hatching", hatch_mm, kinds=HATCHES),
        Pen("Features", feature_mm, kinds=FEATURES),
        Pen("Outline", outline_mm, kinds=OUTLINES),
    ]
