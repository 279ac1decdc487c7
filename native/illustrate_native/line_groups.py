"""What the lines of a drawing are called, and how they lie on each other. Needs numpy only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

KIND_NAMES = (
    "SILHOUETTE",
    "BOUNDARY",
    "CREASE",
    "INTERSECTION",
    "HATCH",
    "CROSS_HATCH",
    "UNDERCUT",
    "MARK",
    "MATERIAL",
    "FLAT_OUTLINE",
    "SEAM",
    "SUGGESTIVE",
    "RIDGE",
    "VALLEY",
    "LOOSE",
    "TERMINATOR",
    "SHADOW_OUTLINE",
)
"""Names of `illustrate_native.Kind`, by number; seams are never drawn."""

HIDDEN = "Hidden"
"""Title of the group of lines that have layers in front of them, whatever their kind."""

_BOTTOM_TO_TOP = (
    "UNDERCUT",
    "CROSS_HATCH",
    "HATCH",
    "SHADOW_OUTLINE",
    "TERMINATOR",
    "VALLEY",
    "RIDGE",
    "SUGGESTIVE",
    "LOOSE",
    "FLAT_OUTLINE",
    "MATERIAL",
    "MARK",
    "INTERSECTION",
    "CREASE",
    "BOUNDARY",
    "SILHOUETTE",
)
_HATCHES = ("HATCH", "CROSS_HATCH", "UNDERCUT")
_TITLES = {
    "CROSS_HATCH": "Cross-hatch",
    "FLAT_OUTLINE": "Flat Outline",
    "SUGGESTIVE": "Suggestive Contour",
    "LOOSE": "Loose Edge",
    "SHADOW_OUTLINE": "Shadow Outline",
}


class DrawingArrays(Protocol):
    """The arrays of `illustrate_native.Drawing` about its strokes: p points in s strokes."""

    @property
    def points(self) -> NDArray[np.float64]:
        """(p, 3) world."""

    @property
    def image(self) -> NDArray[np.float64]:
        """(p, 2) pixels, origin top left, y down."""

    @property
    def widths(self) -> NDArray[np.float32]:
        """(p,) pixels."""

    @property
    def offsets(self) -> NDArray[np.int32]:
        """(s + 1,): stroke i is points[offsets[i]:offsets[i + 1]]."""

    @property
    def kinds(self) -> NDArray[np.uint8]:
        """(s,) `illustrate_native.Kind`."""

    @property
    def closed(self) -> NDArray[np.bool_]:
        """(s,) True: the last point is joined to the first."""

    @property
    def objects(self) -> NDArray[np.int32]:
        """(s,) index of the mesh."""

    @property
    def invisibility(self) -> NDArray[np.int32]:
        """(s,) layers in front, 0 = visible."""

    @property
    def stroke_ids(self) -> NDArray[np.int32]:
        """(s,) number through the frames of a sequence."""

    @property
    def stroke_starts(self) -> NDArray[np.float64]:
        """(s,) px along the stroke that its first point counts as."""


@dataclass(frozen=True)
class LineGroup:
    """Strokes that lie on one layer."""

    title: str
    is_hatching: bool
    strokes: NDArray[np.intp]  # indices, ascending


def points_of(
    drawing: DrawingArrays, strokes: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Indices of the points of some strokes, one stroke after another, and how many each has."""
    offsets = np.asarray(drawing.offsets).astype(np.intp)
    first, sizes = offsets[strokes], np.diff(offsets)[strokes]
    starts = np.cumsum(sizes) - sizes
    return np.arange(sizes.sum()) + np.repeat(first - starts, sizes), sizes


def line_groups(drawing: DrawingArrays) -> list[LineGroup]:
    """Groups of strokes, lowest first: hidden lines, hatching, lines. None is empty."""
    kinds = np.asarray(drawing.kinds).astype(int)
    is_visible = np.asarray(drawing.invisibility) == 0
    groups = [LineGroup(HIDDEN, False, np.flatnonzero(~is_visible))]
    for name in _BOTTOM_TO_TOP:
        strokes = np.flatnonzero(is_visible & (kinds == KIND_NAMES.index(name)))
        title = _TITLES.get(name, name.capitalize())
        groups.append(LineGroup(title, name in _HATCHES, strokes))
    return [group for group in groups if len(group.strokes)]
