"""Drawings for plots: of every kind of line, and of a real mesh."""

from __future__ import annotations

from functools import cache
from typing import Any

import illustrate_native as ill
import numpy as np
from drawings import drawing_of
from illustrate_native.drawing_json import StoredDrawing

WIDTH_PX, HEIGHT_PX = 1024, 768
PAPERS: list[dict[str, Any]] = [
    {},
    {"fit": "fill", "margin_mm": 0.0, "bleed_mm": 3.0},
    {"paper": "A6", "margin_mm": (5.0, 5.0, 20.0, 5.0), "fit": "scale", "scale": 0.3},
    {"paper": (100.0, 300.0), "fit": "lines", "order": "wet"},
]
"""Options of plots: a page as it comes, with bleed, at scale with much cut off, and upright."""


def drawing_of_every_kind() -> StoredDrawing:
    """One straight stroke of each kind that is drawn, and a hidden one."""
    kinds = [kind for kind in ill.Kind if kind != ill.Kind.SEAM]
    rows = enumerate([*((kind, 0) for kind in kinds), (ill.Kind.SILHOUETTE, 1)], start=1)
    return drawing_of(
        [
            (kind, [(10.0, 10.0 * row), (210.0, 10.0 * row)], [1.0, 1.0], False, invisibility)
            for row, (kind, invisibility) in rows
        ]
    )


def torus_mesh(turn: Any = None, place: Any = (0.0, 0.0, 0.0)) -> ill.PolygonMesh:
    """A ring of 16 x 16 quads; turn: (3, 3), place: (3,)."""
    u, v = (a.ravel() for a in np.meshgrid(*[np.arange(16)] * 2, indexing="ij"))
    au, av = u * np.pi / 8, v * np.pi / 8
    ring = 1 + 0.4 * np.cos(av)
    positions = np.c_[ring * np.cos(au), ring * np.sin(au), 0.4 * np.sin(av)]
    positions = positions @ (np.eye(3) if turn is None else turn).T + place
    corners = [((u + i) % 16) * 16 + (v + j) % 16 for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return ill.PolygonMesh(positions, np.full(256, 4), np.stack(corners, axis=1).ravel())


@cache
def torus_drawing() -> Any:
    """A hatched torus at WIDTH_PX x HEIGHT_PX."""
    return ill.draw(ill.prepare([torus_mesh()]), camera(), ill.DrawOptions(hidden_lines=(1, 3)))


def camera() -> ill.Camera:
    """It looks down at the origin, at WIDTH_PX x HEIGHT_PX."""
    eye = np.array([0.0, -4.0, 3.0])
    back = eye / np.linalg.norm(eye)
    right = np.array([1.0, 0.0, 0.0])
    view = np.eye(4)
    view[:3, :3] = [right, np.cross(back, right), back]
    view[:3, 3] = -view[:3, :3] @ eye
    near, far, zoom = 0.1, 100.0, 3.2
    projection = np.zeros((4, 4))
    projection[0, 0], projection[1, 1] = zoom * HEIGHT_PX / WIDTH_PX, zoom
    projection[2, 2:] = -(far + near) / (far - near), -2 * far * near / (far - near)
    projection[3, 2] = -1.0
    return ill.Camera(projection, view, WIDTH_PX, HEIGHT_PX)
