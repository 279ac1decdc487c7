"""The strokes of the live drawing, as the graphics card gets them, and what may hide them."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from .. import native
from ..output.pens import PENS
from ..output.strokes import pen_of
from .ribbons import ribbons_of
from .views import FOREMOST, View, depths_of

SOLID = ("MESH", "CURVE", "SURFACE", "FONT", "META", "VOLUME", "CURVES")


def strokes_as_ribbons(
    drawing: Any,
    view: View,
    inks: dict[str, Any],
    hatches: bool,
    hiding: Any = None,
    without: Sequence[int] = (),
) -> Any:
    """Ribbons of the hatches of a drawing, or of all else, the lowest first.

    hiding: the data of a region whose depth hides them; None: they are before everything, since the
    drawing's own surfaces hide nothing that it shows. without: numbers of strokes to leave out.
    """
    parts = native.load_part("line_groups")
    groups = [g for g in parts.line_groups(drawing) if g.is_hatching == hatches]
    strokes = np.concatenate([g.strokes for g in groups]) if groups else np.zeros(0, np.intp)
    colours = np.array([inks[pen_of(g)] for g in groups for _ in g.strokes], np.float32)
    is_kept = ~np.isin(strokes, without)
    strokes, colours = strokes[is_kept], colours.reshape(-1, 4)[is_kept]
    chosen, sizes = parts.points_of(drawing, strokes)
    return ribbons_of(
        view.to_region(np.asarray(drawing.image)[chosen]),
        np.asarray(drawing.widths)[chosen] * view.zoom,
        np.concatenate([[0], np.cumsum(sizes)]),
        np.asarray(drawing.closed)[strokes],
        colours,
        FOREMOST if hiding is None else _depths(drawing, hiding)[chosen],
    )


def _depths(drawing: Any, region_data: Any) -> Any:
    """(p,) depths of the points of a drawing; hidden lines are seen through everything."""
    depths = depths_of(drawing.points, region_data.window_matrix, region_data.view_matrix)
    is_hidden = np.repeat(np.asarray(drawing.invisibility) > 0, np.diff(drawing.offsets))
    depths[is_hidden] = FOREMOST
    return depths


def has_others(scene: Any, names: set[str]) -> bool:
    """True where solid things are shown besides those of the names: these may hide strokes."""
    return any(
        thing.type in SOLID and thing.name not in names and thing.visible_get()
        for thing in scene.objects
    )


def inks_of(chosen: Any) -> dict[str, Any]:
    """(4,) colours of the pens."""
    return {pen: tuple(getattr(chosen, name)) for pen, name in PENS.items()}
