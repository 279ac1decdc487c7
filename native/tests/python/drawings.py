"""Drawings whose strokes are known."""

from __future__ import annotations

import illustrate_native as ill
import numpy as np
from illustrate_native.drawing_json import StoredDrawing

Stroke = tuple[ill.Kind, list[tuple[float, float]], list[float], bool, int]


def drawing_of(strokes: list[Stroke]) -> StoredDrawing:
    """Strokes (kind, image points, widths, closed, invisibility) on the plane z = 0."""
    image = np.array([p for s in strokes for p in s[1]], float).reshape(-1, 2)
    return StoredDrawing(
        400,
        300,
        ["Thing"],
        points=np.c_[image, np.zeros(len(image))],
        image=image,
        widths=np.array([w for s in strokes for w in s[2]], np.float32),
        offsets=np.cumsum([0, *(len(s[1]) for s in strokes)]).astype(np.int32),
        kinds=np.array([int(s[0]) for s in strokes], np.uint8),
        closed=np.array([s[3] for s in strokes], bool),
        objects=np.zeros(len(strokes), np.int32),
        invisibility=np.array([s[4] for s in strokes], np.int32),
    )
