"""A drawing as SVG: sizes in millimetres, one group per line kind, for print and for plotters.

Needs numpy only. The same drawing gives the same bytes.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from xml.sax.saxutils import escape, quoteattr, unescape

import numpy as np
from numpy.typing import NDArray

from .line_groups import DrawingArrays, LineGroup, line_groups

STYLES = ("centerline", "tapered")

_MITRE_LIMIT = 2.0  # how much farther than half its width an outline may reach at a corner
_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
     version="1.1" width="{width}mm" height="{height}mm" viewBox="0 0 {width_px} {height_px}">"""
_GROUP = '<g id="{id}" inkscape:groupmode="layer" inkscape:label="{title}" {paint}>'
_METADATA = '<metadata id="illustrate">{}</metadata>'
_END = "</svg>"
_PAINT = {
    "centerline": 'fill="none" stroke="#000" stroke-linecap="round" stroke-linejoin="round"',
    "tapered": 'fill="#000" stroke="none"',
}


def to_svg(
    drawing: DrawingArrays,
    width_px: int,
    height_px: int,
    width_mm: float = 200.0,
    style: str = "centerline",
    made_by: Mapping[str, Any] | None = None,
    tracks: bool = False,
    regions: Sequence[Any] = (),
) -> str:
    """SVG text of a drawing made for an image of width_px by height_px.

    The page is width_mm wide, its height follows; user units are pixels of the image. style
    'centerline': one path per stroke along its middle, as wide as the stroke is on average, so that
    it has as much ink;
    'tapered': the filled outline of each stroke, as wide as the stroke is at every point.
    made_by: what the file is to say of its making, of JSON's types; it is in its metadata.
    tracks: paths get the attributes data-id and data-start: a stroke's number through the frames
    of a sequence, and the pixels along it that its first point counts as.
    regions: `illustrate_native.plot.Region`s in pixels, filled in a group below the lines.
    Raises ValueError naming the argument that cannot be used.
    """
    if style not in STYLES:
        raise ValueError(f"style is {style!r}, not one of {', '.join(STYLES)}")
    if not (width_px > 0 and height_px > 0):
        raise ValueError(f"the image is {width_px} x {height_px} px: both must be positive")
    if not (np.isfinite(width_mm) and width_mm > 0):
        raise ValueError(f"width_mm is {width_mm}: it must be positive")
    height_mm = width_mm * height_px / width_px
    lines = [
        _HEAD.format(
            width=number(width_mm),
            height=number(height_mm),
            width_px=width_px,
            height_px=height_px,
        )
    ]
    if made_by is not None:
        lines.append(_METADATA.format(escape(json.dumps(made_by))))
    if regions:
        lines += [_GROUP.format(id="fill", title="Fill", paint='stroke="none"')]
        lines += [*map(_region, regions), "</g>"]
    paths = _Paths(drawing, style, tracks)
    for group in line_groups(drawing):
        name = group.title.lower().replace(" ", "-")
        lines.append(_GROUP.format(id=name, title=group.title, paint=_PAINT[style]))
        lines.extend(paths.of(group))
        lines.append("</g>")
    return "\n".join([*lines, _END, ""])


def read_made_by(text: str) -> dict[str, Any]:
    """What `to_svg` was given as made_by. Raises ValueError where there is none, or no end."""
    found = re.search(_METADATA.format("(.*)"), text)
    if found is None or not text.endswith(f"{_END}\n"):
        raise ValueError("not a whole drawing that says how it was made")
    return dict(json.loads(unescape(found[1])))


class _Paths:
    """The path elements of a drawing's strokes."""

    def __init__(self, drawing: DrawingArrays, style: str, tracks: bool) -> None:
        self.drawing = drawing
        self.tracks = tracks
        self.image = np.asarray(drawing.image, float)
        self.widths = np.asarray(drawing.widths, float)
        # What takes arrays takes all strokes at once: most are short.
        self.centres = style == "centerline"
        self.texts = _pairs(self.image) if self.centres else []
        self.means = _mean_widths(drawing) if self.centres else np.empty(0)

    def of(self, group: LineGroup) -> Iterator[str]:
        """One element per stroke; strokes without a point give none."""
        for stroke in map(int, group.strokes):
            span = slice(int(self.drawing.offsets[stroke]), int(self.drawing.offsets[stroke + 1]))
            if span.start == span.stop:
                continue
            told = _track(self.drawing, stroke) if self.tracks else ""
            closed = bool(self.drawing.closed[stroke])
            if self.centres:
                width, end = number(self.means[stroke]), "Z" if closed else ""
                yield f'<path {told}stroke-width="{width}" d="M{" ".join(self.texts[span])}{end}"/>'
            else:
                outline = _outline(self.image[span], self.widths[span] / 2, closed)
                yield f'<path {told}d="{outline}"/>'


def _region(region: Any) -> str:
    """A path of all rings, whose holes stay free."""
    rings = "".join(f"M{polyline(ring)}Z" for polygon in region.polygons for ring in polygon)
    label, paint = quoteattr(region.name), f'fill="{region.colour}" fill-rule="evenodd"'
    return f'<path inkscape:label={label} {paint} d="{rings}"/>'


def _track(drawing: DrawingArrays, stroke: int) -> str:
    start = number(drawing.stroke_starts[stroke])
    return f'data-id="{int(drawing.stroke_ids[stroke])}" data-start="{start}" '


def _mean_widths(drawing: DrawingArrays) -> NDArray[np.float64]:
    """(s,) the width at which a stroke has as much ink: the mean over its length."""
    image, widths = np.asarray(drawing.image, float), np.asarray(drawing.widths, float)
    offsets = np.asarray(drawing.offsets, int)
    counts = np.diff(offsets)
    following = np.arange(1, len(image) + 1)  # the point after each; itself at an open end
    some = counts > 0
    last = offsets[1:][some] - 1
    following[last] = np.where(np.asarray(drawing.closed, bool)[some], offsets[:-1][some], last)
    lengths = np.hypot(*(image[following] - image).T)
    stroke = np.repeat(np.arange(len(counts)), counts)

    def sums(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.bincount(stroke, values, len(counts)).astype(float, copy=False)

    ink, length = sums(lengths * (widths[following] + widths) / 2), sums(lengths)
    means: NDArray[np.float64] = sums(widths) / np.maximum(counts, 1)
    np.divide(ink, length, out=means, where=length > 0)
    return means


def _outline(points: NDArray[np.float64], radii: NDArray[np.float64], closed: bool) -> str:
    """Path data of the area that a round pen of changing radius covers."""
    side = side_vectors(points, closed) * radii[:, None]
    left, right = points + side, (points - side)[::-1]
    if closed:
        return f"M{polyline(left)}ZM{polyline(right)}Z"
    return (
        f"M{polyline(left)}{_cap(radii[-1], right[0])}L{polyline(right)}{_cap(radii[0], left[0])}Z"
    )


def _cap(radius: float, end: NDArray[np.float64]) -> str:
    """Half a circle to `end`, round the outside."""
    return f"A{number(radius)},{number(radius)} 0 0 1 {polyline(end[None])}"


def side_vectors(points: NDArray[np.float64], closed: bool) -> NDArray[np.float64]:
    """(n, 2) from each point to the edge of a stroke of radius 1, mitred at corners."""
    following = np.roll(points, -1, axis=0) if closed else points[1:]
    along = following - points[: len(following)]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = np.divide(along, length, out=np.zeros_like(along), where=length > 0)
    if closed:
        before, after = np.roll(along, 1, axis=0), along
    else:
        edge = along[:1] if len(along) else np.array([[1.0, 0.0]])
        before, after = (
            np.vstack([edge, along]),
            np.vstack([along, along[-1:] if len(along) else edge]),
        )
    middle = before + after
    half = np.linalg.norm(middle, axis=1, keepdims=True) / 2  # cosine of half the turn
    middle = np.divide(middle, 2 * half, out=after.copy(), where=half > 0)
    reach = np.minimum(1 / np.maximum(half, 1e-12), _MITRE_LIMIT)
    side: NDArray[np.float64] = np.stack([middle[:, 1], -middle[:, 0]], axis=1) * reach
    return side


def number(value: float) -> str:
    """A number with at most three decimals."""
    return f"{round(float(value), 3) + 0.0:.10g}"


def polyline(points: NDArray[np.float64]) -> str:
    """Points as 'x,y x,y', to a hundredth of a pixel."""
    return " ".join(_pairs(points))


def _pairs(points: NDArray[np.float64]) -> list[str]:
    flat = (np.round(points, 2) + 0.0).ravel().tolist()
    return [f"{x:.10g},{y:.10g}" for x, y in zip(flat[::2], flat[1::2], strict=True)]
