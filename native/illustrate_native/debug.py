"""What each stage made of a view, as pictures: for whoever asks why a line is there.

    pictures = debug.pictures(prepared, drawing, camera)   # {"surface": "<svg ...", ...}
    debug.write_pictures("out", prepared, drawing, camera)

Needs numpy only. The same drawing gives the same bytes. docs/ shows these pictures of each stage.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

import numpy as np
from numpy.typing import NDArray

from ._core import Camera, Drawing, Kind, Node, Prepared
from .field_svg import field_to_svg, project
from .svg import number, polyline

Doubles = NDArray[np.float64]

# Okabe and Ito's colours, which the colour-blind tell apart.
BLACK, ORANGE, SKY, GREEN, BLUE, RED, PINK, GREY = (
    "#1c1c1c", "#e69f00", "#56b4e9", "#009e73", "#0072b2", "#d55e00", "#cc79a7", "#9aa0a6",
)  # fmt: skip
_CYCLE = (BLACK, ORANGE, SKY, GREEN, BLUE, RED, PINK)

_OF_KIND = {
    Kind.SILHOUETTE: BLACK,
    Kind.BOUNDARY: BLUE,
    Kind.CREASE: GREEN,
    Kind.INTERSECTION: RED,
    Kind.SUGGESTIVE: SKY,
    Kind.RIDGE: ORANGE,
    Kind.VALLEY: PINK,
}
_OF_LAYERS = (BLACK, ORANGE, SKY, PINK)  # the last: more
_OF_NODE = {Node.CUSP: RED, Node.CROSSING: BLUE, Node.JOINT: GREEN, Node.END: GREY}
_OF_TONE = {0: "#ffffff", 1: "#c4c4c4", 2: "#808080"}
_OF_BAND = {1: "#ffe9b8", 2: "#8fb8de"}
_OF_RANK = {0.1: SKY, 0.03: ORANGE, 0.01: RED}
_TONES, _BANDS = ("highlight", "midtone", "shadow"), ("", "Mach band", "undercut")
_HATCHES = {Kind.HATCH: BLACK, Kind.CROSS_HATCH: ORANGE, Kind.UNDERCUT: BLUE}

_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{width_mm}mm" height="{height_mm}mm"
     viewBox="0 0 {width} {height}" fill="none" stroke-linejoin="round" stroke-linecap="round">
<rect width="100%" height="100%" fill="#fff"/>"""

Index = int | np.integer[Any]
Lines = Iterator[str]
Told = tuple[str, str]
"""A colour and what it stands for."""


def pictures(
    prepared: Prepared,
    drawing: Drawing,
    camera: Camera,
    stages: Iterable[str] | None = None,
    width_mm: float = 120.0,
) -> dict[str, str]:
    """SVG text for each stage, in the order of the pipeline.

    Args:
        prepared: what `drawing` was drawn of.
        drawing: a view of it.
        camera: the camera of that view.
        stages: some of `STAGES`; None: all of them.
        width_mm: of each picture.

    Raises:
        ValueError: a stage that is not in `STAGES`.
    """
    chosen = tuple(STAGES) if stages is None else tuple(stages)
    for stage in chosen:
        if stage not in STAGES:
            raise ValueError(f"stage is {stage!r}, not one of {', '.join(STAGES)}")
    view = _View(prepared, drawing, camera, width_mm)
    return {stage: STAGES[stage](view) for stage in STAGES if stage in chosen}


def write_pictures(
    folder: str | Path,
    prepared: Prepared,
    drawing: Drawing,
    camera: Camera,
    stages: Iterable[str] | None = None,
    width_mm: float = 120.0,
) -> list[Path]:
    """Writes what `pictures` makes to folder/STAGE.svg; the files. Makes the folder."""
    made = pictures(prepared, drawing, camera, stages, width_mm)
    Path(folder).mkdir(parents=True, exist_ok=True)
    files = []
    for stage, text in made.items():
        files.append(Path(folder) / f"{stage}.svg")
        files[-1].write_text(text, encoding="utf-8")
    return files


class _View:
    """A drawing with what it was drawn of, and the frame of its pictures."""

    def __init__(
        self, prepared: Prepared, drawing: Drawing, camera: Camera, width_mm: float
    ) -> None:
        self.prepared, self.drawing, self.camera = prepared, drawing, camera
        self.width_mm = width_mm

    def page(self, lines: Iterable[str], legend: Iterable[Told] = ()) -> str:
        """A whole picture with its legend."""
        width, height = self.camera.width_px, self.camera.height_px
        head = _HEAD.format(
            width_mm=number(self.width_mm),
            height_mm=number(self.width_mm * height / width),
            width=width,
            height=height,
        )
        told = _legend(legend, self.unit)
        return "\n".join([head, *lines, *told, "</svg>", ""])

    @property
    def unit(self) -> float:
        """Pixels of a hairline: a four-hundredth of the picture's larger side."""
        return max(self.camera.width_px, self.camera.height_px) / 400

    def stroke(self, stroke: Index) -> Doubles:
        """(m, 2) px, of one stroke."""
        span = slice(self.drawing.offsets[stroke], self.drawing.offsets[stroke + 1])
        return np.asarray(self.drawing.image[span])

    def arc(self, arc: Index) -> str:
        """Path data of an arc of the graph."""
        graph = self.drawing.graph
        points = graph.arc_image[graph.arc_offsets[arc] : graph.arc_offsets[arc + 1]]
        return _data(points, bool(graph.arc_nodes[arc, 0] < 0))


def _data(points: Doubles, closed: bool) -> str:
    return f"M{polyline(points)}{'Z' if closed else ''}" if len(points) else ""


def _path(data: Iterable[str], colour: str, width: float, more: str = "") -> str:
    return f'<path stroke="{colour}" stroke-width="{number(width)}" {more}d="{"".join(data)}"/>'


def _legend(told: Iterable[Told], unit: float) -> Lines:
    """A line of text for each colour, in the upper left corner."""
    size = 11 * unit
    for row, (colour, meaning) in enumerate(told):
        y = (row + 1.2) * size
        yield (
            f'<rect x="{number(size / 2)}" y="{number(y - 0.7 * size)}" width="{number(size)}" '
            f'height="{number(0.7 * size)}" fill="{colour}" stroke="#777" '
            f'stroke-width="{number(unit / 3)}"/>'
            f'<text x="{number(2 * size)}" y="{number(y)}" font-family="sans-serif" '
            f'font-size="{number(size)}" fill="#333">{escape(meaning)}</text>'
        )


def _surface(view: _View) -> str:
    """The triangles, far ones first; feature edges last."""
    surface = view.prepared.surface
    image, depth = project(view.camera, surface.positions)
    corners = image[surface.triangles]
    order = np.argsort(-depth[surface.triangles, 0].mean(axis=1), kind="stable")
    shown = order[np.isfinite(corners[order]).all(axis=(1, 2))]
    lines = [
        f'<g fill="#fff" stroke="{GREY}" stroke-width="{number(view.unit / 2)}">',
        *(f'<path d="{_data(corners[t], True)}"/>' for t in shown),
        "</g>",
    ]
    return view.page(lines, [("#fff", f"{len(surface.triangles):,} triangles")])


def _field(view: _View) -> str:
    """Crosses of the field on what is seen, and its singularities."""
    return field_to_svg(
        view.prepared.surface, view.prepared.field, view.camera, 9 * view.unit, view.width_mm
    )


def _curves(view: _View) -> str:
    """The first curves on the surface, as far as they face the eye; the very first on top."""
    curves, surface = view.prepared.hatch_curves, view.prepared.surface
    corners = project(view.camera, surface.positions)[0][surface.triangles]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    faces_eye = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] < 0  # y runs down
    image = project(view.camera, curves.points)[0]
    count = len(curves.offsets) - 1
    lines, told = [], []
    for share, colour in _OF_RANK.items():
        last = int(np.ceil(share * count))
        parts: list[str] = []
        for rank in range(last):
            span = slice(curves.offsets[rank], curves.offsets[rank + 1])
            seen = faces_eye[curves.triangles[span]] & np.isfinite(image[span]).all(axis=1)
            parts += [
                _data(_thinned(part, 4 * view.unit), False) for part in _runs(image[span], seen)
            ]
        lines.append(_path(parts, colour, view.unit))
        told.append((colour, f"first {last:,} of {count:,} curves"))
    return view.page(lines, told)


def _thinned(points: Doubles, step: float) -> Doubles:
    """Points of a polyline about `step` apart, with its ends."""
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).cumsum()
    kept = np.flatnonzero(np.diff(length // step, prepend=-1.0, append=np.inf))
    thinned: Doubles = points[np.union1d(kept, [0])]
    return thinned


def _runs(points: Doubles, chosen: NDArray[np.bool_]) -> Iterator[Doubles]:
    """The parts of a polyline whose points are all chosen."""
    ends = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(np.int8)))
    for start, end in ends.reshape(-1, 2):
        if end - start > 1:
            yield points[start:end]


def _contour(view: _View) -> str:
    """All curves of the view, seen or not, by their kind."""
    kinds = view.drawing.graph.arc_kind
    shown = [Kind(kind) for kind in np.unique(kinds)]
    lines = [
        _path(
            map(view.arc, np.flatnonzero(kinds == kind)), _OF_KIND.get(kind, GREY), 1.3 * view.unit
        )
        for kind in shown
    ]
    return view.page(lines, [(_OF_KIND.get(kind, GREY), _words(kind.name)) for kind in shown])


def _visibility(view: _View) -> str:
    """Arcs by the number of layers that hide them; nodes by their kind."""
    graph = view.drawing.graph
    layers = np.minimum(graph.arc_layers_over, len(_OF_LAYERS) - 1)
    shown = np.unique(layers)
    lines = [
        _path(
            map(view.arc, np.flatnonzero(layers == count)),
            _OF_LAYERS[count],
            (1.8 if count == 0 else 1.0) * view.unit,
        )
        for count in shown[::-1]
    ]
    nodes = [Node(kind) for kind in np.unique(graph.node_kind)]
    lines += list(_discs(graph.node_image, graph.node_kind, 2.2 * view.unit))
    told = [(_OF_LAYERS[count], _layers_in_words(int(count))) for count in shown]
    return view.page(lines, [*told, *((_OF_NODE[node], _words(node.name)) for node in nodes)])


def _layers_in_words(count: int) -> str:
    if count == 0:
        return "visible"
    more = " or more" if count == len(_OF_LAYERS) - 1 else ""
    return f"{count}{more} in front"


def _discs(image: Doubles, kinds: NDArray[np.uint8], radius: float) -> Lines:
    for (x, y), kind in zip(image.tolist(), kinds.tolist(), strict=True):
        yield (
            f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" '
            f'fill="{_OF_NODE[Node(kind)]}"/>'
        )


def _tone(view: _View) -> str:
    """Cells of the tone map: tones in grey, bands beside folds in colour."""
    tone = view.drawing.tone
    level, band = np.asarray(tone.level), np.asarray(tone.band)
    lines = [
        f'<path fill="{colour}" d="{"".join(_cells(chosen, tone.cell_px))}"/>'
        for colours, chosen_in in ((_OF_TONE, level), (_OF_BAND, band))
        for value, colour in colours.items()
        if (chosen := chosen_in == value).any()
    ]
    lines.append(_outline(view))
    told = [(colour, _TONES[value]) for value, colour in _OF_TONE.items() if (level == value).any()]
    told += [(colour, _BANDS[value]) for value, colour in _OF_BAND.items() if (band == value).any()]
    return view.page(lines, told)


def _cells(chosen: NDArray[np.bool_], side: float) -> Iterator[str]:
    """Path data of the chosen cells (h, w), run by run."""
    padded = np.pad(chosen, ((0, 0), (1, 1))).astype(np.int8)
    rows, columns = np.nonzero(np.diff(padded, axis=1))
    for row, (start, end) in zip(rows[::2], columns.reshape(-1, 2), strict=True):
        x, y, width = number(start * side), number(row * side), number((end - start) * side)
        yield f"M{x},{y}h{width}v{number(side)}h-{width}z"


def _outline(view: _View) -> str:
    """The visible curves, thin."""
    visible = np.flatnonzero(view.drawing.graph.arc_layers_over == 0)
    return _path(map(view.arc, visible), BLACK, 0.6 * view.unit)


def _hatch(view: _View) -> str:
    """Hatches by their kind, on the visible curves."""
    kinds = view.drawing.kinds
    lines, told = [_outline(view)], []
    for kind, colour in _HATCHES.items():
        strokes = np.flatnonzero(kinds == kind)
        if len(strokes):
            data = [_data(view.stroke(s), bool(view.drawing.closed[s])) for s in strokes]
            lines.append(_path(data, colour, 0.8 * view.unit))
            told.append((colour, f"{len(strokes)} {_words(kind.name)}"))
    return view.page(lines, told)


def _stroke(view: _View) -> str:
    """Each stroke in a colour of its own, with a dot where it starts."""
    lines, starts = [], []
    for stroke in range(len(view.drawing.kinds)):
        points, closed = view.stroke(stroke), bool(view.drawing.closed[stroke])
        width = float(view.drawing.widths[view.drawing.offsets[stroke]])
        colour = _CYCLE[stroke % len(_CYCLE)]
        lines.append(_path([_data(points, closed)], colour, max(width, 0.5 * view.unit)))
        if len(points):
            starts.append(f"M{polyline(points[:1])}h0")
    lines.append(_path(starts, BLACK, 3 * view.unit))
    return view.page(lines, [(BLACK, f"{len(view.drawing.kinds)} strokes; dots: starts")])


def _words(name: str) -> str:
    return name.lower().replace("_", " ")


STAGES: dict[str, Callable[[_View], str]] = {
    "surface": _surface,
    "field": _field,
    "curves": _curves,
    "contour": _contour,
    "visibility": _visibility,
    "tone": _tone,
    "hatch": _hatch,
    "stroke": _stroke,
}
"""What there are pictures of."""
