"""Paper: its formats, how a picture lies on it, and what is cut off at its margins."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from .errors import PlotError
from .strokes import Flags, Floats, Indices, Strokes, chosen, concatenated, opened, rolled

FORMATS = {
    "A0": (841.0, 1189.0),
    "A1": (594.0, 841.0),
    "A2": (420.0, 594.0),
    "A3": (297.0, 420.0),
    "A4": (210.0, 297.0),
    "A5": (148.0, 210.0),
    "A6": (105.0, 148.0),
    "Letter": (215.9, 279.4),
    "Legal": (215.9, 355.6),
    "Tabloid": (279.4, 431.8),
}
"""Width and height upright, millimetres (ISO 216, ANSI)."""

ORIENTATIONS = ("portrait", "landscape", "auto")
FITS = ("frame", "fill", "lines", "scale")

Box = tuple[float, float, float, float]
"""left, top, right, bottom."""


@dataclass(frozen=True)
class Page:
    """A sheet of paper, millimetres."""

    width_mm: float
    height_mm: float
    margins_mm: Box = (0.0, 0.0, 0.0, 0.0)
    bleed_mm: float = 0.0  # of print beyond the edge, to be trimmed

    @property
    def inner(self) -> Box:
        """Within the margins."""
        left, top, right, bottom = self.margins_mm
        return left, top, self.width_mm - right, self.height_mm - bottom

    @property
    def outer(self) -> Box:
        """With the bleed."""
        bleed = self.bleed_mm
        return -bleed, -bleed, self.width_mm + bleed, self.height_mm + bleed

    @property
    def printed(self) -> Box:
        """What is not cut off: up to the margin, or on sides without one up to the bleed."""
        sides = zip(self.margins_mm, self.inner, self.outer, strict=True)
        left, top, right, bottom = (inn if margin > 0 else out for margin, inn, out in sides)
        return left, top, right, bottom


@dataclass(frozen=True)
class Placing:
    """Where a picture lies: a point (x, y) of it in pixels is at scale * (x, y) + shift."""

    scale: float  # millimetres per pixel
    shift_mm: tuple[float, float]


def make_page(
    paper: str | tuple[float, float],
    orientation: str = "auto",
    margin_mm: float | Box = 10.0,
    bleed_mm: float = 0.0,
    is_wide: bool = False,
) -> Page:
    """A page that can be drawn on.

    paper: a key of FORMATS, or width and height in millimetres, which 'auto' leaves as they are.
    orientation: 'auto' lays a format as the picture is: is_wide. margin_mm: of all sides, or left,
    top, right, bottom. Raises PlotError for a page without room between its margins.
    """
    width, height = _size(paper)
    if orientation not in ORIENTATIONS:
        raise PlotError(f"orientation is {orientation!r}, not one of {', '.join(ORIENTATIONS)}")
    lies = is_wide if orientation == "auto" else orientation == "landscape"
    if not (orientation == "auto" and not isinstance(paper, str)) and lies != (width > height):
        width, height = height, width
    margins = _sides(margin_mm)
    if not (all(math.isfinite(m) and m >= 0 for m in (*margins, bleed_mm))):
        raise PlotError("margins and bleed must be finite and at least 0 mm")
    page = Page(width, height, margins, bleed_mm)
    left, top, right, bottom = page.inner
    if right <= left or bottom <= top:
        raise PlotError(
            f"a page of {width:g} x {height:g} mm has no room between its margins of "
            f"{', '.join(f'{m:g}' for m in margins)} mm (left, top, right, bottom): make them "
            "smaller, or the page larger"
        )
    return page


def _size(paper: str | tuple[float, float]) -> tuple[float, float]:
    if isinstance(paper, str):
        if paper not in FORMATS:
            raise PlotError(f"paper is {paper!r}, not one of {', '.join(FORMATS)}")
        return FORMATS[paper]
    width, height = paper
    if not (0 < width < math.inf and 0 < height < math.inf):
        raise PlotError(f"a page of {width:g} x {height:g} mm: both must be positive and finite")
    return float(width), float(height)


def _sides(margin_mm: float | Box) -> Box:
    if isinstance(margin_mm, tuple):
        return margin_mm
    return (float(margin_mm),) * 4


def read_paper(text: str) -> str | tuple[float, float]:
    """'A4' or '150x100' (millimetres) as `make_page` takes it. Raises PlotError."""
    for name in FORMATS:
        if text.casefold() == name.casefold():
            return name
    try:
        width, height = (float(side) for side in text.lower().split("x"))
    except ValueError as error:
        formats = ", ".join(FORMATS)
        raise PlotError(f"{text!r} is no paper: one of {formats}, or such as 150x100") from error
    return _size((width, height))


def place(
    page: Page, frame: Box, fit: str = "frame", lines: Box | None = None, scale: float = 0.0
) -> Placing:
    """Where the picture lies, in the middle between the margins.

    fit: 'frame', the whole picture inside the margins; 'fill', the picture covers all that is
    printed; 'lines', what is drawn (`lines`, a box like `frame`, pixels) inside the margins;
    'scale', `scale` millimetres for a pixel, whatever the size. Raises PlotError.
    """
    if fit not in FITS:
        raise PlotError(f"fit is {fit!r}, not one of {', '.join(FITS)}")
    source = lines if fit == "lines" and lines is not None else frame
    target = page.printed if fit == "fill" else page.inner
    wide, high = source[2] - source[0], source[3] - source[1]
    ratios = [(target[i + 2] - target[i]) / side for i, side in enumerate((wide, high)) if side > 0]
    if fit == "scale":
        if not 0 < scale < math.inf:
            raise PlotError(f"the scale is {scale:g} mm for a pixel: it must be positive")
        factor = scale
    else:
        factor = (max if fit == "fill" else min)(ratios, default=1.0)
    middle = [
        (target[i] + target[i + 2] - factor * (source[i] + source[i + 2])) / 2 for i in (0, 1)
    ]
    return Placing(factor, (middle[0], middle[1]))


def placed(strokes: Strokes, placing: Placing) -> Strokes:
    """Strokes in pixels as strokes in millimetres, widths too."""
    points = strokes.points * placing.scale + placing.shift_mm
    return replace(strokes, points=points, widths=strokes.widths * placing.scale)


def box_of(strokes: Strokes) -> Box | None:
    """The box of all points; None where there are none."""
    if not len(strokes.points):
        return None
    (left, top), (right, bottom) = strokes.points.min(axis=0), strokes.points.max(axis=0)
    return float(left), float(top), float(right), float(bottom)


def cropped(strokes: Strokes, box: Box) -> Strokes:
    """What lies in the box: strokes are cut where they leave it, a closed one that does is opened.

    Cut ends lie on the box; strokes keep their order.
    """
    outside = ~_inside(strokes.points, box)
    leaves = np.bincount(strokes.owners[outside], minlength=len(strokes)) > 0
    if not leaves.any():
        return strokes
    whole, cut = np.flatnonzero(~leaves), np.flatnonzero(leaves)
    pieces, sources = _pieces(opened(_begun_outside(strokes, cut, outside)), box)
    together = concatenated([chosen(strokes, whole), pieces])
    return chosen(together, np.argsort(np.concatenate([whole, cut[sources]]), kind="stable"))


def _inside(points: Floats, box: Box) -> Flags:
    return np.asarray(((points >= box[:2]) & (points <= box[2:])).all(axis=1))


def _begun_outside(strokes: Strokes, which: Indices, outside: Flags) -> Strokes:
    """Strokes that leave the box, the closed ones begun at a point outside of it."""
    first = np.full(len(strokes), len(strokes.points), np.intp)
    np.minimum.at(first, strokes.owners[outside], np.flatnonzero(outside))
    turn = np.where(strokes.closed, first - strokes.offsets[:-1], 0)
    return chosen(rolled(strokes, np.where(first < len(strokes.points), turn, 0)), which)


def _pieces(runs: Strokes, box: Box) -> tuple[Strokes, Indices]:
    """The parts of open polylines that lie in the box, and the stroke each is of."""
    start, end, segments = _shares_inside(runs, box)
    goes_on = (np.diff(segments) == 1) & (end[:-1] >= 1) & (start[1:] <= 0)
    goes_on &= runs.owners[segments[1:]] == runs.owners[segments[:-1]]
    begins = np.append(True, ~goes_on)[: len(segments)]
    sizes = np.bincount(np.cumsum(begins) - 1, minlength=int(begins.sum())) + 1
    sources = runs.owners[segments[begins]]
    both = np.stack([begins, np.ones(len(segments), bool)], axis=1).ravel()
    at = np.stack([start, end], axis=1).ravel()[both]
    of = np.repeat(segments, 2)[both]
    return Strokes(
        _between(runs.points, of, at[:, None]).clip(box[:2], box[2:]),
        _between(runs.widths, of, at),
        np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        np.zeros(len(sources), bool),
        runs.labels[sources],
        runs.subjects,
    ), sources


def _between(values: Floats, segments: Indices, shares: Floats) -> Floats:
    """Values on segments, at shares of their lengths."""
    mixed: Floats = (1 - shares) * values[segments] + shares * values[segments + 1]
    return mixed


def _shares_inside(runs: Strokes, box: Box) -> tuple[Floats, Floats, Indices]:
    """Where segments enter and leave the box, as shares of their lengths, and which ones do.

    By Liang and Barsky: the latest entry and the earliest leaving over the four sides.
    """
    segments = np.flatnonzero(np.diff(runs.owners) == 0)
    origin, way = runs.points[segments], runs.points[segments + 1] - runs.points[segments]
    with np.errstate(divide="ignore", invalid="ignore"):
        to_low, to_high = (box[:2] - origin) / way, (box[2:] - origin) / way
    within = (origin >= box[:2]) & (origin <= box[2:])
    entry = np.where(way == 0, np.where(within, -np.inf, np.inf), np.minimum(to_low, to_high))
    leave = np.where(way == 0, np.where(within, np.inf, -np.inf), np.maximum(to_low, to_high))
    start, end = entry.max(axis=1).clip(0, None), leave.min(axis=1).clip(None, 1)
    seen = start < end
    return start[seen], end[seen], segments[seen]
