"""Marching squares on the lattices of patches: the polygons where values are not negative.

Cells that are wholly inside join to squares as large as fit in a quadtree; every square goes
through the nodes on its rim that others use, so that neighbours have the same points. Cells that
the level crosses become the part inside of it, crossings linear between nodes, but not nearer to
either than a twentieth of a cell, so that there are no slivers.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

NEAREST = 0.05
AT_NODE, ALONG_X, ALONG_Y = 0, 1, 2
# Where the corners and sides of a cell lie, going round: node and direction of the crossing.
ROUND_X = np.array([0, 0, 1, 1, 1, 0, 0, 0])
ROUND_Y = np.array([0, 0, 0, 0, 1, 1, 1, 0])
ROUND_KIND = np.array([AT_NODE, ALONG_X, AT_NODE, ALONG_Y, AT_NODE, ALONG_X, AT_NODE, ALONG_Y])
AROUND = ((7, 0, 1), (3, 4, 5)), ((1, 2, 3), (5, 6, 7))  # of a saddle's two parts


@dataclass
class Polygons:
    """Polygons on patches, one after another."""

    sizes: Any  # (n,) corners
    patches: Any  # (sum of sizes,) of the corners
    x: Any  # (sum of sizes,) node, or the one before a crossing
    y: Any  # the same
    kinds: Any  # (sum of sizes,) AT_NODE, or a crossing ALONG_X, ALONG_Y
    shares: Any  # (sum of sizes,) how far on from the node crossings are


def count_cut(values: Any) -> int:
    """Cells of (p, m + 1, n + 1) that the level crosses."""
    inside = _corners(values >= 0)
    return int((inside.any(axis=0) & ~inside.all(axis=0)).sum())


def march(values: Any, patches: Any) -> Polygons:
    """Polygons of the values (p, m + 1, n + 1) of patches with the numbers `patches` (p,)."""
    is_inside = values >= 0
    corners = _corners(is_inside)
    full = corners.all(axis=0)
    squares = _squares(full)
    cut = np.argwhere(corners.any(axis=0) & ~full)
    used = _used_nodes(is_inside, squares, cut)
    parts = [_of_squares(used, squares), _of_cells(values, cut)]
    joined = [np.concatenate(each) for each in zip(*parts, strict=True)]
    sizes, numbers, x, y, kinds = joined
    shares = _shares(values, numbers, x, y, kinds)
    return Polygons(sizes, patches[numbers], x, y, kinds, shares)


def _corners(nodes: Any) -> Any:
    """(4, p, m, n) the nodes round each cell, going round."""
    return np.stack([nodes[:, :-1, :-1], nodes[:, 1:, :-1], nodes[:, 1:, 1:], nodes[:, :-1, 1:]])


def _squares(full: Any) -> Any:
    """(s, 4) patch, x, y and side of the largest squares that full cells join to."""
    found, side = [], 1
    while True:
        m, n = full.shape[1:]
        joined = np.zeros((len(full), m // 2, n // 2), bool)
        if m > 1 and n > 1:
            joined = full.reshape(len(full), m // 2, 2, n // 2, 2).all(axis=(2, 4))
        within = joined.repeat(2, axis=1).repeat(2, axis=2) if joined.size else False
        places = np.argwhere(full & ~within if joined.size else full) * (1, side, side)
        found.append(np.column_stack([places, np.full(len(places), side)]))
        if not joined.any():
            return np.concatenate(found)
        full, side = joined, 2 * side


def _used_nodes(is_inside: Any, squares: Any, cut: Any) -> Any:
    """(p, m + 1, n + 1) bool: nodes that are corners of any polygon."""
    used = np.zeros(is_inside.shape, bool)
    patch, x, y, side = squares.T
    for step_x, step_y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        used[patch, x + step_x * side, y + step_y * side] = True
        used[cut[:, 0], cut[:, 1] + step_x, cut[:, 2] + step_y] = True
    return used & is_inside


def _of_squares(used: Any, squares: Any) -> tuple[Any, ...]:
    """Sizes, patches, x, y and kinds of the corners of squares."""
    side = np.repeat(squares[:, 3], 4 * squares[:, 3])
    number = np.repeat(np.arange(len(squares)), 4 * squares[:, 3])
    ends = np.cumsum(4 * squares[:, 3])
    along = np.arange(len(side)) - (ends - 4 * squares[:, 3])[number]
    quarter, step = along // np.maximum(side, 1), along % np.maximum(side, 1)
    patch = squares[number, 0]
    x = squares[number, 1] + np.choose(quarter, [step, side, side - step, 0 * step])
    y = squares[number, 2] + np.choose(quarter, [0 * step, step, side, side - step])
    kept = used[patch, x, y]
    sizes = np.bincount(number[kept], minlength=len(squares))
    kinds = np.full(int(kept.sum()), AT_NODE)
    return sizes, patch[kept], x[kept], y[kept], kinds


def _of_cells(values: Any, cut: Any) -> tuple[Any, ...]:
    """The same of cells that the level crosses."""
    patch, x, y = cut.T
    steps = ROUND_X[::2], ROUND_Y[::2]
    at = np.stack([values[patch, x + i, y + j] for i, j in zip(*steps, strict=True)], axis=1)
    inside = at >= 0
    emitted = np.zeros((len(cut), 8), bool)
    emitted[:, ::2], emitted[:, 1::2] = inside, inside != np.roll(inside, -1, axis=1)
    is_saddle = (inside[:, 0] == inside[:, 2]) & emitted[:, 1::2].all(axis=1)
    is_parted = is_saddle & (at.mean(axis=1) < 0)
    rows = [(np.flatnonzero(~is_parted), emitted[~is_parted])]
    for first, slots in enumerate(AROUND):
        chosen = np.flatnonzero(is_parted & inside[:, first])
        rows += [(chosen, np.tile(np.isin(np.arange(8), part), (len(chosen), 1))) for part in slots]
    return _cell_corners(cut, *map(np.concatenate, zip(*rows, strict=True)))


def _cell_corners(cut: Any, cells: Any, emitted: Any) -> tuple[Any, ...]:
    row, slot = np.nonzero(emitted)
    patch, x, y = cut[cells[row]].T
    return emitted.sum(axis=1), patch, x + ROUND_X[slot], y + ROUND_Y[slot], ROUND_KIND[slot]


def _shares(values: Any, patch: Any, x: Any, y: Any, kinds: Any) -> Any:
    """How far on from their nodes crossings are, in cells."""
    here = values[patch, x, y]
    there = values[patch, x + (kinds == ALONG_X), y + (kinds == ALONG_Y)]
    with np.errstate(invalid="ignore", divide="ignore"):
        share = (here / (here - there)).clip(NEAREST, 1 - NEAREST)
    return np.where(kinds == AT_NODE, 0.0, share).astype(float)
