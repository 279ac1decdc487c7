"""Pictures of lines as small files: sixteen greys."""

import pathlib
import struct
import zlib
from typing import Any

import numpy as np

GREYS = 16


def shrunk(grey: Any, width: int) -> Any:
    """Rows of grey in [0, 1] at that width at most: each pixel the mean of what it covers."""
    if grey.shape[1] <= width:
        return grey
    for axis in (0, 1):
        old = grey.shape[axis]
        new = round(old * width / grey.shape[1]) if axis == 0 else width
        edges = np.linspace(0, old, new + 1)
        total = np.insert(np.cumsum(grey, axis=axis), 0, 0.0, axis=axis)
        whole = np.minimum(edges.astype(int), old - 1)
        part = (edges - whole).reshape((-1, 1) if axis == 0 else (1, -1))
        at_edges = np.take(total, whole, axis) + part * np.take(grey, whole, axis)
        grey = np.diff(at_edges, axis=axis) * new / old
    return grey


def write(path: pathlib.Path, grey: Any) -> None:
    """Writes rows of grey in [0, 1], the top one first, as a PNG."""
    levels = np.clip(np.rint(grey * (GREYS - 1)), 0, GREYS - 1).astype(np.uint8)
    height, width = levels.shape
    levels = np.pad(levels, ((0, 0), (0, width % 2)))
    rows = levels[:, ::2] << 4 | levels[:, 1::2]
    data = zlib.compress(np.pad(rows, ((0, 0), (1, 0))).tobytes(), 9)
    header = struct.pack(">2I5B", width, height, 4, 0, 0, 0, 0)
    chunks = (b"IHDR" + header, b"IDAT" + data, b"IEND")
    parts = [struct.pack(">I", len(c) - 4) + c + struct.pack(">I", zlib.crc32(c)) for c in chunks]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))
