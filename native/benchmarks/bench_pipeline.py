"""Counts and times of the whole pipeline on surfaces given by a formula.

One JSON line for each mesh and level: the exact work (`counts`), which is the same on every
machine, and the seconds of each stage, which are not.
"""

from __future__ import annotations

import argparse
import json
import time

import illustrate_native as ill
import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
Indices = NDArray[np.int32]


def torus(rows: int, columns: int) -> tuple[Points, Indices]:
    """Vertices (n,3) and quads (f,4) of a torus with radii 1 and 0.4."""
    u, v = np.meshgrid(2 * np.pi * np.arange(columns) / columns, 2 * np.pi * np.arange(rows) / rows)
    radius = 1 + 0.4 * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), 0.4 * np.sin(v)], axis=-1)
    row, column = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    right, above = (column + 1) % columns, (row + 1) % rows
    quads = np.stack(
        [row * columns + column, row * columns + right, above * columns + right,
         above * columns + column],
        axis=-1,
    )  # fmt: skip
    return points.reshape(-1, 3), quads.reshape(-1, 4).astype(np.int32)


def sphere(rows: int) -> tuple[Points, Indices]:
    """Vertices (n,3) and quads (f,4) of a unit cube's grid, pushed out to the unit sphere."""
    line = np.linspace(-1, 1, rows + 1)
    a, b = (grid.ravel() for grid in np.meshgrid(line, line, indexing="ij"))
    one = np.ones_like(a)
    sides = [(a, b, one), (b, a, -one), (one, a, b), (-one, b, a), (b, one, a), (a, -one, b)]
    points = np.concatenate([np.stack(side, axis=-1) for side in sides])
    row, column = (g.ravel() for g in np.meshgrid(range(rows), range(rows), indexing="ij"))
    corner = row * (rows + 1) + column
    side_quads = np.stack([corner, corner + rows + 1, corner + rows + 2, corner + 1], axis=-1)
    quads = np.concatenate([side_quads + k * (rows + 1) ** 2 for k in range(len(sides))])
    _, first, merged = np.unique(
        np.round(points, 9), axis=0, return_index=True, return_inverse=True
    )
    points = points[first] / np.linalg.norm(points[first], axis=1, keepdims=True)
    return points, merged.reshape(-1)[quads].astype(np.int32)


def camera(width_px: int, height_px: int) -> ill.Camera:
    """Perspective, 40 degrees high, five units away, looking down at the origin by 30 degrees."""
    near, far, focal = 0.1, 100.0, 1 / np.tan(np.radians(20.0))
    projection = np.zeros((4, 4))
    projection[0, 0] = focal * height_px / width_px
    projection[1, 1] = focal
    projection[2, 2:] = (far + near) / (near - far), 2 * far * near / (near - far)
    projection[3, 2] = -1
    tilt = np.radians(-60.0)
    view = np.eye(4)
    view[1:3, 1:3] = [[np.cos(tilt), -np.sin(tilt)], [np.sin(tilt), np.cos(tilt)]]
    view[2, 3] = -5.0
    return ill.Camera(projection, view, width_px, height_px)


def measure(
    name: str, shape: tuple[Points, Indices], level: int, threads: int
) -> dict[str, object]:
    """Prepares and draws one mesh at one subdivision level."""
    points, quads = shape
    mesh = ill.PolygonMesh(points, np.full(len(quads), 4), quads.ravel(), name=name)
    prepare_options, draw_options = ill.PrepareOptions(), ill.DrawOptions()
    prepare_options.level = level
    prepare_options.threads = draw_options.threads = threads
    start = time.perf_counter()
    prepared = ill.prepare([mesh], prepare_options)
    middle = time.perf_counter()
    drawing = ill.draw(prepared, camera(1000, 800), draw_options)
    end = time.perf_counter()
    return {
        "mesh": name,
        "level": level,
        "triangles": len(prepared.surface.triangles),
        "strokes": len(drawing.kinds),
        "counts": dict(drawing.counts),
        "prepare_s": round(middle - start, 4),
        "draw_s": round(end - middle, 4),
        "stages_s": {
            stage: round(seconds, 4)
            for stage, seconds in {**prepared.timings, **drawing.timings}.items()
        },
    }


def main() -> None:
    """Prints one line for each shape and level."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--levels", type=int, nargs="+", default=[1, 2, 3, 4])
    parser.add_argument("--threads", type=int, default=0, help="0: all")
    arguments = parser.parse_args()
    for name, shape in {"torus": torus(16, 32), "sphere": sphere(10)}.items():
        for level in arguments.levels:
            result = measure(name, shape, level, arguments.threads)
            print(json.dumps(result), flush=True)


if __name__ == "__main__":
    main()
