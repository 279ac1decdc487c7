"""Reads STL files, text and binary; corners at the same place become one vertex."""

import pathlib
from typing import Any

import numpy as np

HEADER, COUNT = 80, 4  # bytes
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])


def read_stl(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    """Positions and triangles, lists of vertex numbers.

    Raises ValueError, which names the file, where it is damaged.
    """
    data = path.read_bytes()
    try:
        corners = _binary(data) if _is_binary(data) else _text(data)
    except ValueError as error:
        raise ValueError(f"{path.name} cannot be read as STL: {error}") from error
    positions, numbers = np.unique(corners, axis=0, return_inverse=True)
    return positions.tolist(), numbers.reshape(-1, 3).tolist()


def _is_binary(data: bytes) -> bool:
    """By its length: the header of a binary file may begin with 'solid' too."""
    start = HEADER + COUNT
    if len(data) < start:
        return False
    count = int(np.frombuffer(data, "<u4", 1, HEADER)[0])
    return len(data) >= start + count * TRIANGLE.itemsize and not (
        data.lstrip().startswith(b"solid") and b"facet" in data[:1000]
    )


def _binary(data: bytes) -> Any:
    count = int(np.frombuffer(data, "<u4", 1, HEADER)[0])
    triangles = np.frombuffer(data, TRIANGLE, count, HEADER + COUNT)
    return triangles["corners"].reshape(-1, 3).astype(float)


def _text(data: bytes) -> Any:
    lines = [line.split() for line in data.splitlines()]
    corners = [[float(word) for word in words[1:4]] for words in lines if words[:1] == [b"vertex"]]
    if not corners or len(corners) % 3 or any(len(corner) != 3 for corner in corners):
        raise ValueError("it holds no whole triangles")
    return np.array(corners)
