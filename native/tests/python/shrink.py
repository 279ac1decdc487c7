"""The smallest part of a mesh that still shows a bug, to be kept with its test.

    shrink.smallest(shape, lambda part: "nan" in svg_of(part))

What ends the process is asked for in another one (subprocess), whose exit code is looked at.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from shapes import Shape

Fails = Callable[[Shape], bool]
MOST_DECIMALS = 6


def smallest(shape: Shape, fails: Fails) -> Shape:
    """A part of the shape that fails and does not without any one of its faces.

    Coordinates are as round as they can be. Raises ValueError where the shape itself does not fail.
    """
    if not fails(shape):
        raise ValueError("the whole shape does not fail: there is nothing to shrink")
    kept = np.arange(len(shape.face_sizes))
    chunk = len(kept)
    while chunk:
        before = len(kept)
        kept = _without_chunks(shape, kept, chunk, fails)
        # What one face was needed for may be gone with another: single faces until all are needed.
        if chunk > 1 or len(kept) == before:
            chunk //= 2
    return _rounded(part(shape, kept), fails)


def _without_chunks(shape: Shape, kept: np.ndarray, chunk: int, fails: Fails) -> np.ndarray:
    begin = 0
    while begin < len(kept):
        fewer = np.delete(kept, np.s_[begin : begin + chunk])
        if len(fewer) and fails(part(shape, fewer)):
            kept = fewer
        else:
            begin += chunk
    return kept


def part(shape: Shape, faces: np.ndarray) -> Shape:
    """Some faces of a shape, with their vertices and no others."""
    begins = np.cumsum(shape.face_sizes) - shape.face_sizes
    corners = [np.arange(begins[f], begins[f] + shape.face_sizes[f]) for f in faces]
    used, vertices = np.unique(shape.corner_vertices[np.concatenate(corners)], return_inverse=True)
    return Shape(
        shape.positions[used], shape.face_sizes[faces], vertices.reshape(-1).astype(np.int32)
    )


def _rounded(shape: Shape, fails: Fails) -> Shape:
    for decimals in range(MOST_DECIMALS):
        rounded = replace(shape, positions=np.round(shape.positions, decimals))
        if fails(rounded):
            return rounded
    return shape
