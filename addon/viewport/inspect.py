"""Overlays to inspect the last illustration with: what the drawing was decided by.

Each kind is a function of an Illustration to Marks, without Blender; one draw handler shows them.
"""

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .shown import Shown

CELLS = 70  # along the diagonal of everything: one cross or pair of curvature lines in each
ARM = 0.42  # half the length of a cross, in cells
RED, BLUE = (0.85, 0.1, 0.1, 1.0), (0.1, 0.3, 0.95, 1.0)
GREEN, GREY = (0.1, 0.65, 0.2, 1.0), (0.25, 0.25, 0.25, 1.0)
TONES = {0: (1.0, 0.95, 0.6, 0.5), 1: (0.5, 0.6, 0.75, 0.5), 2: (0.15, 0.15, 0.4, 0.5)}
BANDS = {1: (1.0, 1.0, 1.0, 0.8), 2: (0.6, 0.1, 0.1, 0.6)}


def cross_field(made: Any) -> list[Any]:
    """Crosses of the field, one in each cell."""
    surface = made.prepared.surface
    chosen, cell = _one_in_each_cell(surface)
    along = np.asarray(made.prepared.field.directions)[chosen]
    across = np.cross(np.asarray(surface.normals)[chosen], along)
    at = np.asarray(surface.positions)[chosen]
    return [_marks("LINES", _sticks(at, ARM * cell * d), GREY) for d in (along, across)]


def singularities(made: Any) -> list[Any]:
    """Where the field turns round a point: red forward, blue backward."""
    field = made.prepared.field
    corners = np.asarray(made.prepared.surface.triangles)[np.asarray(field.singular_triangles)]
    points = np.asarray(made.prepared.surface.positions)[corners].mean(axis=1)
    turns = np.asarray(field.singular_indices)
    return [
        _marks("POINTS", points[turns > 0], RED, 9.0),
        _marks("POINTS", points[turns < 0], BLUE, 9.0),
    ]


def curvature(made: Any) -> list[Any]:
    """Directions of the larger curvature, red where the surface bends towards its front."""
    surface = made.prepared.surface
    chosen, cell = _one_in_each_cell(surface)
    k1 = np.asarray(surface.hatch_k1)[chosen]
    strength = np.abs(k1) / max(float(np.quantile(np.abs(k1), 0.9)), 1e-300)
    arms = (ARM * cell * strength.clip(0, 1.5))[:, None] * np.asarray(surface.hatch_w1)[chosen]
    sticks = _sticks(np.asarray(surface.positions)[chosen], arms).reshape(-1, 2, 3)
    return [
        _marks("LINES", sticks[k1 > 0].reshape(-1, 3), RED),
        _marks("LINES", sticks[k1 <= 0].reshape(-1, 3), BLUE),
    ]


def cusps(made: Any) -> list[Any]:
    """Where a contour turns out of sight without anything before it."""
    graph = made.drawing.graph
    offsets, nodes = np.asarray(graph.arc_offsets), np.asarray(graph.arc_nodes)
    places = np.full((len(graph.node_kind), 3), np.nan)
    is_open = nodes[:, 0] >= 0
    points = np.asarray(graph.arc_points)
    places[nodes[is_open, 0]] = points[offsets[:-1][is_open]]
    places[nodes[is_open, 1]] = points[offsets[1:][is_open] - 1]
    found = places[np.asarray(graph.node_kind) == 0]
    return [_marks("POINTS", found[np.isfinite(found).all(axis=1)], GREEN, 8.0)]


def tone_regions(made: Any) -> list[Any]:
    """Triangles in the colours of light, shadow and bands, where the camera sees their fronts."""
    tone, camera = made.drawing.tone, made.arrays.camera
    level, band = np.asarray(tone.level), np.asarray(tone.band)
    if not level.size:
        return []
    corners = np.asarray(made.prepared.surface.positions)[made.prepared.surface.triangles]
    column, row, inside = _cells(corners.mean(axis=1), camera, tone)
    inside &= _is_front(corners, camera)
    values = np.where(inside, level[row, column], 255)
    bands = np.where(inside & (values != 255), band[row, column], 0)
    marks = [(values == v) & (bands == 0) for v in TONES] + [bands == b for b in BANDS]
    colours = [*TONES.values(), *BANDS.values()]
    return [
        _marks("TRIS", corners[chosen].reshape(-1, 3), colour)
        for chosen, colour in zip(marks, colours, strict=True)
    ]


KINDS: dict[str, tuple[str, str, Callable[[Any], list[Any]]]] = {
    "FIELD": ("Cross Field", "Directions that hatches follow", cross_field),
    "SINGULARITIES": ("Singularities", "Where the field turns round a point", singularities),
    "CURVATURE": ("Curvature", "Directions of the larger curvature", curvature),
    "CUSPS": ("Cusps", "Where contours turn out of sight", cusps),
    "TONE": ("Tone Regions", "Highlights, midtones, shadows and bands", tone_regions),
}
ITEMS = [
    ("NONE", "Nothing", "Show no overlay", 0),
    *((key, name, text, i + 1) for i, (key, (name, text, _)) in enumerate(KINDS.items())),
]


def _marks(shape: str, points: Any, colour: Any, size: float = 1.5) -> Any:
    from .overlay import Marks

    return Marks(shape, np.ascontiguousarray(points, np.float32), colour, size)


def _sticks(at: Any, arms: Any) -> Any:
    """(2 m, 3) ends of segments through `at` (m, 3), `arms` (m, 3) to both sides."""
    return np.stack([at - arms, at + arms], axis=1).reshape(-1, 3)


def _one_in_each_cell(surface: Any) -> tuple[Any, float]:
    """Vertices, one in each cell that has some, and the size of cells."""
    positions = np.asarray(surface.positions)
    cell = max(float(np.linalg.norm(np.ptp(positions, axis=0))) / CELLS, 1e-300)
    cells = np.floor(positions / cell).astype(np.int64)
    return np.sort(np.unique(cells, axis=0, return_index=True)[1]), cell


def _cells(points: Any, camera: Any, tone: Any) -> tuple[Any, Any, Any]:
    """Column, row (m,) of the tone's cells at points (m, 3); bool: they are in the picture."""
    clip = np.c_[points, np.ones(len(points))] @ (camera.projection @ camera.view).T
    w = np.where(clip[:, 3] > 0, clip[:, 3], np.inf)
    x = (clip[:, 0] / w + 1) / 2 * camera.width_px / tone.cell_px
    y = (1 - clip[:, 1] / w) / 2 * camera.height_px / tone.cell_px
    height, width = tone.level.shape
    inside = (clip[:, 3] > 0) & (x >= 0) & (x < width) & (y >= 0) & (y < height)
    return (
        np.where(inside, x, 0).astype(int),
        np.where(inside, y, 0).astype(int),
        inside,
    )


def _is_front(corners: Any, camera: Any) -> Any:
    eye = eye_of(camera.projection, camera.view)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.einsum("ij,ij->i", normals, eye[:3] - eye[3] * corners[:, 0]) > 0


def eye_of(projection: Any, view: Any) -> Any:
    """(4,) the eye in the world: a point with w = 1, or with w = 0 the direction towards it.

    projection, view: (4, 4), OpenGL's convention.
    """
    world = np.linalg.inv(np.asarray(view, float))
    if projection[3][3] == 0:
        return world[:, 3] / world[3, 3]
    return np.append(world[:3, 2] / np.linalg.norm(world[:3, 2]), 0.0)


class Inspector(Shown):
    """The overlay that is shown, and the illustration that it is of."""

    def __init__(self) -> None:
        self.made: Any = None
        self.kind = "NONE"
        self._marks: list[Any] | None = None

    def remember(self, made: Any) -> None:
        """The illustration to look into from now on."""
        self.made, self._marks = made, None

    def let_go(self) -> None:
        """Forgets the illustration unless it is looked at: another one is going to be made."""
        if self._handle is None:
            self.remember(None)

    def show(self, kind: str) -> None:
        """Shows a key of KINDS, or 'NONE'."""
        self.kind, self._marks = kind, None
        self._switch(kind != "NONE")

    def stop(self) -> None:
        """Shows nothing and forgets."""
        self.show("NONE")
        self.remember(None)

    def marks(self) -> list[Any]:
        """What is shown, computed once."""
        if self._marks is None:
            has_some = self.made is not None and self.kind != "NONE"
            self._marks = KINDS[self.kind][2](self.made) if has_some else []
        return self._marks

    def _draw(self) -> None:
        from . import overlay

        overlay.draw(self.marks(), bpy.context.region, bpy.context.region_data)


INSPECTOR = Inspector()
"""The inspector of this Blender."""


@persistent
def _before_load(*_: Any) -> None:
    INSPECTOR.stop()


def _numbers() -> dict[str, int]:
    return {key: number for key, _, _, number in ITEMS}


def register() -> None:
    """Registers the choice."""
    keys = {number: key for key, number in _numbers().items()}
    bpy.types.WindowManager.illustrate_inspect = bpy.props.EnumProperty(
        name="Inspect",
        items=ITEMS,
        description="Show what the last illustration was decided by; press Illustrate first",
        get=lambda _manager: _numbers()[INSPECTOR.kind],
        set=lambda _manager, number: INSPECTOR.show(keys[number]),
    )
    bpy.app.handlers.load_pre.append(_before_load)


def unregister() -> None:
    """Shows nothing any more and takes the choice away."""
    INSPECTOR.stop()
    bpy.app.handlers.load_pre.remove(_before_load)
    del bpy.types.WindowManager.illustrate_inspect
