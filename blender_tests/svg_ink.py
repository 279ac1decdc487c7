"""What an SVG of filled outlines covers, by a rasteriser that shares no code with the project."""

import re
from collections.abc import Iterator
from typing import Any

import numpy as np

SAMPLES = 4  # along each side of a pixel
ARC_STEPS = 12


def coverage(text: str, width: int, height: int) -> Any:
    """(height, width): which share of each pixel is covered by the paths, filled by 'nonzero'."""
    covered = np.zeros((height * SAMPLES, width * SAMPLES), bool)
    for data in re.findall(r'<path d="([^"]+)"', text):
        _fill(covered, [np.array(loop) * SAMPLES for loop in _loops(data)])
    return covered.reshape(height, SAMPLES, width, SAMPLES).mean(axis=(1, 3))


def _loops(data: str) -> Iterator[list[Any]]:
    """The closed polygons of a path of M, L, Z and arcs that are half circles."""
    loop: list[Any] = []
    for command, words in re.findall(r"([MLAZ])([^MLAZ]*)", data):
        numbers = [float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", words)]
        if command == "Z":
            yield loop
            loop = []
        elif command == "A":
            loop += _half_circle(np.array(loop[-1]), np.array(numbers[5:7]))
        else:
            loop += list(zip(numbers[::2], numbers[1::2], strict=True))


def _half_circle(start: Any, end: Any) -> list[Any]:
    middle, turn = (start + end) / 2, np.linspace(0, np.pi, ARC_STEPS + 1)[1:]
    x, y = start - middle
    around = np.stack([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y], 1)
    return list(map(tuple, middle + around))


def _fill(covered: Any, loops: list[Any]) -> None:
    """Marks the samples that the loops wind around; a sample is at the middle of its cell."""
    starts = np.concatenate(loops)
    ends = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    winding = np.zeros((covered.shape[0], covered.shape[1] + 1), np.int32)
    low = np.ceil(np.minimum(starts[:, 1], ends[:, 1]) - 0.5).astype(int).clip(0)
    high = np.ceil(np.maximum(starts[:, 1], ends[:, 1]) - 0.5).astype(int).clip(0, len(covered))
    for a, b, first, last in zip(starts, ends, low, high, strict=True):
        rows = np.arange(first, last)
        x = a[0] + (rows + 0.5 - a[1]) * (b[0] - a[0]) / ((b[1] - a[1]) or 1.0)
        columns = np.ceil(x - 0.5).astype(int).clip(0, covered.shape[1])
        winding[rows, columns] += 1 if b[1] > a[1] else -1
    top, bottom = int(low.min()), int(high.max())
    covered[top:bottom] |= np.cumsum(winding[top:bottom, :-1], axis=1) != 0
