"""What drawings of a few shapes measure, as JSON: how tools/sensitivity.py judges a constant.

Of lines: repairs of views on coarse meshes, where there is most to repair, loops that do not
balance, and the share of visible line that another module draws elsewhere. Of hatches: how many,
how long, how even, and how much of them is steady while the camera turns. Same module, same
numbers.
"""

from __future__ import annotations

import argparse
import itertools
import json
from collections.abc import Callable
from pathlib import Path

import illustrate_native as ill
import numpy as np
from bench_motion import HATCHES, dented, orbit
from bench_silhouettes import blob, cameras
from motion import Doubles, Eye, Samples, compare, samples_of, strokes_of
from scipy.spatial import cKDTree  # type: ignore[import-untyped]

Cells = set[tuple[int, int, int]]  # view, column, row
PARALLEL = np.sqrt(0.5)  # cosine
NEAR = 0.7  # spacings: a parallel hatch so near stands out as a dark spot
SIZE_PX = 1024


def grid(
    point: Callable[[Doubles, Doubles], list[Doubles]], rows: int, columns: int, name: str
) -> ill.PolygonMesh:
    """A surface round and round: points of u, v in [0, 1), quads of both closed directions."""
    u, v = np.meshgrid(np.arange(columns) / columns, np.arange(rows) / rows)
    points = np.stack(point(2 * np.pi * u, 2 * np.pi * v), axis=-1).reshape(-1, 3)
    row, column = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    right, above = (column + 1) % columns, (row + 1) % rows
    quads = np.stack([row * columns + column, row * columns + right, above * columns + right,
                      above * columns + column], axis=-1)  # fmt: skip
    return ill.PolygonMesh(points, np.full(quads.size // 4, 4), quads.ravel(), name=name)


def knot(u: Doubles, v: Doubles) -> list[Doubles]:
    """A tube that follows a trefoil."""
    centre = np.stack([np.sin(u) + 2 * np.sin(2 * u), np.cos(u) - 2 * np.cos(2 * u),
                       -np.sin(3 * u)])  # fmt: skip
    along = np.stack([np.cos(u) + 4 * np.cos(2 * u), -np.sin(u) + 4 * np.sin(2 * u),
                      -3 * np.cos(3 * u)])  # fmt: skip
    aside = np.stack([-along[1], along[0], 0 * u])
    aside /= np.linalg.norm(aside, axis=0)
    up = np.cross(along, aside, axis=0)
    up /= np.linalg.norm(up, axis=0)
    return list((centre + 0.6 * (np.cos(v) * aside + np.sin(v) * up)) / 3)


def self_crossing(u: Doubles, v: Doubles) -> list[Doubles]:
    """A tube in a figure of eight that turns half round: it passes through itself."""
    eight, twist = np.sin(v), np.sin(2 * v) / 2
    radius = 1 + 0.4 * (np.cos(u / 2) * eight - np.sin(u / 2) * twist)
    height = 0.4 * (np.sin(u / 2) * eight + np.cos(u / 2) * twist)
    return [radius * np.cos(u), radius * np.sin(u), height]


def line_scenes() -> list[ill.Prepared]:
    """Coarse ones: the interpolated contour has most to answer for."""
    meshes = [
        [blob(3)],
        [grid(knot, 8, 60, "knot")],
        [grid(self_crossing, 24, 36, "eight")],
        [grid(knot, 6, 30, "knot"), blob(2)],
    ]
    options = ill.PrepareOptions(level=1, field=False)
    return [ill.prepare(of_scene, options) for of_scene in meshes]


def cells_of(graph: ill.Graph, view: int) -> Cells:
    """The pixels that visible arcs pass."""
    found: Cells = set()
    for arc in np.flatnonzero(np.asarray(graph.arc_layers_over) == 0):
        if graph.arc_kind[arc] == int(ill.Kind.SEAM):
            continue
        line = np.asarray(graph.arc_image[graph.arc_offsets[arc] : graph.arc_offsets[arc + 1]])
        if graph.arc_nodes[arc, 0] < 0:
            line = np.r_[line, line[:1]]
        for a, b in itertools.pairwise(line):
            steps = int(np.ceil(2 * np.abs(b - a).max())) + 1
            for x, y in np.floor(a + np.linspace(0, 1, steps)[:, None] * (b - a)).astype(int):
                found.add((view, int(x), int(y)))
    return found


def wider(cells: Cells) -> Cells:
    """With the pixels around."""
    near = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    return {(view, x + i, y + j) for view, x, y in cells for i, j in near}


def lines() -> tuple[dict[str, float], Cells]:
    """Counts of all views together, and what they draw."""
    options = ill.DrawOptions(hatching=False)
    totals = {"repairs": 0.0, "unbalanced": 0.0}
    cells: Cells = set()
    views = [(scene, view) for scene in line_scenes() for view in cameras()]
    for number, (scene, view) in enumerate(views):
        drawing = ill.draw(scene, view, options)
        totals["repairs"] += drawing.counts["repairs"]
        totals["unbalanced"] += drawing.counts["unbalanced_loops"]
        cells |= cells_of(drawing.graph, number)
    return totals, cells


def changed(one: Cells, other: Cells) -> float:
    """Pixels of line that only one of two has, for each 1000 of both, a pixel's move aside."""
    only = len(one - wider(other)) + len(other - wider(one))
    return 1000 * only / max((len(one) + len(other)) / 2, 1)


def gaps(samples: Samples, spacing_px: float) -> Doubles:
    """Of each sample, in spacings: how far the nearest parallel hatch is; at most 3."""
    distance, index = cKDTree(samples.image).query(
        samples.image, k=64, distance_upper_bound=3 * spacing_px
    )
    there = np.isfinite(distance)
    index = np.where(there, index, 0)
    cosine = np.abs(np.einsum("nkd,nd->nk", samples.tangent[index], samples.tangent))
    is_other = there & (samples.stroke[index] != samples.stroke[:, None]) & (cosine > PARALLEL)
    nearest = np.where(is_other, distance, np.inf).min(axis=1) / spacing_px
    return np.asarray(nearest[np.isfinite(nearest)])


def hatches() -> dict[str, float]:
    """Of a dented ball: one drawing, and two that follow each other by a degree."""
    points, quads = dented()
    mesh = ill.PolygonMesh(points, np.full(len(quads), 4), quads.ravel())
    prepared = ill.prepare([mesh], ill.PrepareOptions(level=2))
    views, options = orbit(2, 1.0), ill.DrawOptions()
    first = ill.draw(prepared, views[0], options)
    second = ill.draw(prepared, views[1], options, previous=first)
    surface = prepared.surface
    eyes = [Eye(view, surface.positions, surface.triangles) for view in views]
    strokes = [strokes_of(drawing, HATCHES) for drawing in (first, second)]
    samples = [samples_of(s, eye) for s, eye in zip(strokes, eyes, strict=True)]
    spacing = options.spacing_px
    apart = gaps(samples[0], spacing)
    return {
        "hatches": len(strokes[0]),
        "length": len(samples[0].image) / max(len(strokes[0]), 1) / spacing,
        "uneven": float(np.subtract(*np.percentile(apart, [90, 10]))),
        "near": 1000 * float(np.mean(apart < NEAR)),
        "steady": 1000 * compare(samples[0], samples[1], eyes[0], eyes[1], spacing)["steady"],
    }


def main() -> None:
    """Prints one JSON object."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("what", choices=("lines", "hatches"))
    parser.add_argument("--base", type=Path, help="lines to compare with; written if not there")
    chosen = parser.parse_args()
    if chosen.what == "hatches":
        print(json.dumps(hatches()))
        return
    found, cells = lines()
    if chosen.base and chosen.base.exists():
        base = {tuple(cell) for cell in np.load(chosen.base).tolist()}
        found["changed"] = changed(base, cells)
    elif chosen.base:
        np.save(chosen.base, np.array(sorted(cells), np.int32))
    print(json.dumps(found))


if __name__ == "__main__":
    main()
