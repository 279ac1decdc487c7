"""The dual search for silhouettes against the scan of all triangles.

Blob 4 (a bumpy sphere of 5,120 triangles) is the control mesh of a Loop surface; a few views are
fixed. One JSON line for each level: the exact work of all views together (`counts`), which is the
same on every machine, and median milliseconds of a view, which are not. Then a table of the same.
The counts of the first levels stand in counts.json, and the tests compare them.
"""

from __future__ import annotations

import argparse
import itertools
import json
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
Indices = NDArray[np.int32]

COUNTS_FILE = Path(__file__).with_name("counts.json")
COUNTED = ("triangles_visited", "silhouette_triangles", "cusps", "strands")
EYES = ((4, 1, 0.5), (-1, 4, 1), (0.5, -2, 3.5), (-2, -2, -3))
REPEATS = 7


def icosahedron() -> tuple[Points, Indices]:
    """Vertices (12,3) on the unit sphere and outward triangles (20,3)."""
    golden = (1 + 5**0.5) / 2
    rows = np.array([[0, a, b * golden] for a in (-1, 1) for b in (-1, 1)], float)
    points = np.concatenate([np.roll(rows, k, axis=1) for k in range(3)])
    near = np.linalg.norm(points[:, None] - points, axis=2) < 2.1
    triangles = [
        (a, b, c) if np.linalg.det(points[[a, b, c]]) > 0 else (a, c, b)
        for a, b, c in itertools.combinations(range(12), 3)
        if near[a, b] and near[b, c] and near[c, a]
    ]
    return points / np.linalg.norm(points[0]), np.array(triangles, np.int32)


def split(points: Points, triangles: Indices) -> tuple[Points, Indices]:
    """Every triangle in four, the new vertices on the unit sphere."""
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    pairs, which = np.unique(edges, axis=0, return_inverse=True)
    middles = points[pairs].sum(1)
    middles /= np.linalg.norm(middles, axis=1, keepdims=True)
    ab, bc, ca = (which.reshape(-1, 3) + len(points)).T
    a, b, c = triangles.T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    fine = np.concatenate([np.stack(part, axis=1) for part in parts])
    return np.concatenate([points, middles]), fine.astype(np.int32)


def blob(splits: int) -> ill.PolygonMesh:
    """An icosahedron split so many times, with three waves of bumps."""
    points, triangles = icosahedron()
    for _ in range(splits):
        points, triangles = split(points, triangles)
    x, y, z = points.T
    scale = 1 + 0.15 * np.sin(5 * x + 1) * np.sin(4 * y + 2) * np.sin(6 * z + 3)
    scale += 0.06 * np.sin(11 * x) * np.sin(9 * y + 1) + 0.05 * np.sin(13 * z + x)
    return ill.PolygonMesh(
        points * scale[:, None], np.full(len(triangles), 3), triangles.ravel(),
        scheme="loop", name=f"blob_{splits}",
    )  # fmt: skip


def camera(eye: tuple[float, float, float], perspective: bool) -> ill.Camera:
    """From `eye` at the origin, 1000 px square."""
    back = np.array(eye) / np.linalg.norm(eye)
    right = np.cross([0, 0, 1], back)
    right /= np.linalg.norm(right)
    view = np.eye(4)
    view[:3, :3] = right, np.cross(back, right), back
    view[:3, 3] = -view[:3, :3] @ eye
    near, far, zoom = 0.1, 100.0, 2.5
    projection = np.diag([zoom, zoom, 0.0, 0.0])
    if perspective:
        projection[2, 2:] = (far + near) / (near - far), 2 * far * near / (near - far)
        projection[3, 2] = -1
    else:
        projection[:2] /= np.linalg.norm(eye)
        projection[2, 2:] = -2 / (far - near), (far + near) / (near - far)
        projection[3, 3] = 1
    return ill.Camera(projection, view, 1000, 1000)


def cameras() -> list[ill.Camera]:
    """The views of the benchmark."""
    return [camera(eye, perspective) for eye in EYES for perspective in (True, False)]


def prepared_blob(level: int, threads: int = 0) -> ill.Prepared:
    """Blob 4 at a subdivision level, for lines only."""
    return ill.prepare([blob(4)], ill.PrepareOptions(level=level, field=False, threads=threads))


def counts_of(prepared: ill.Prepared) -> dict[str, int]:
    """The exact work of all views together."""
    options = ill.DrawOptions(hatching=False)
    drawings = [ill.draw(prepared, view, options) for view in cameras()]
    counts = {name: sum(drawing.counts[name] for drawing in drawings) for name in COUNTED}
    return {"triangles": len(prepared.surface.triangles), **counts}


def median_ms(call: Callable[[ill.Camera], float]) -> float:
    """Median over the views of the best of some repeats."""
    best = [min(call(view) for _ in range(REPEATS)) for view in cameras()]
    return round(1e3 * statistics.median(best), 3)


def times_of(prepared: ill.Prepared, threads: int) -> dict[str, float]:
    """Milliseconds: `tree` is made once, the rest in every view."""
    ill.silhouettes(prepared, cameras()[0])  # the first view makes the tree of a large mesh
    tree_ms = round(1e3 * prepared.timings["dual_surface"], 1)

    def find(brute_force: bool) -> Callable[[ill.Camera], float]:
        def call(view: ill.Camera) -> float:
            start = time.perf_counter()
            ill.silhouettes(prepared, view, brute_force)
            return time.perf_counter() - start

        return call

    def contour(scan: bool) -> Callable[[ill.Camera], float]:
        options = ill.DrawOptions(hatching=False, scan_silhouettes=scan, threads=threads)
        return lambda view: ill.draw(prepared, view, options).timings["contour"]

    return {
        "tree_ms": tree_ms,
        "search_ms": median_ms(find(False)),
        "scan_ms": median_ms(find(True)),
        "contour_ms": median_ms(contour(False)),
        "contour_by_scan_ms": median_ms(contour(True)),
    }


def measure(level: int, threads: int) -> dict[str, Any]:
    """Times and counts of one level."""
    prepared = prepared_blob(level, threads)
    times, counts = times_of(prepared, threads), counts_of(prepared)
    return {
        "mesh": "blob_4",
        "level": level,
        "views": len(cameras()),
        "counts": counts,
        "visited_ratio": round(counts["triangles_visited"] / counts["silhouette_triangles"], 3),
        **times,
        "scan_over_search": round(times["scan_ms"] / times["search_ms"], 1),
    }


def print_table(results: list[dict[str, Any]]) -> None:
    """A row for each level: counts, then what is timed."""
    rows = [{"level": r["level"], **r["counts"], **r} for r in results]
    skipped = {"mesh", "views", "counts"}
    names = [name for name in rows[0] if name not in skipped]
    widths = [max(len(name), 9) for name in names]
    print("  ".join(name.rjust(width) for name, width in zip(names, widths, strict=True)))
    for row in rows:
        cells = zip(names, widths, strict=True)
        print("  ".join(str(row[name]).rjust(width) for name, width in cells))


def main() -> None:
    """Prints a line for each level, then the table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--levels", type=int, nargs="+", default=[2, 3, 4])
    parser.add_argument("--threads", type=int, default=1, help="0: all")
    parser.add_argument("--write-counts", action="store_true", help="into counts.json")
    arguments = parser.parse_args()
    results = []
    for level in arguments.levels:
        results.append(measure(level, arguments.threads))
        print(json.dumps(results[-1]), flush=True)
    print_table(results)
    if arguments.write_counts:
        counts = {f"blob_4 level {r['level']}": r["counts"] for r in results}
        COUNTS_FILE.write_text(json.dumps(counts, indent=2) + "\n")


if __name__ == "__main__":
    main()
