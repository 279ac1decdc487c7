"""Regions as masks: images of how much of each pixel an area covers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..png import image_file
from .regions import Region, turn
from .strokes import Floats, Indices


def coverage(region: Region, width_px: int, height_px: int) -> Floats:
    """(height_px, width_px) in [0, 1], exact. The region lies within the frame, in pixels.

    Each edge adds the signed area to its right; a running sum along rows makes it a cover.
    """
    total = np.zeros((height_px, width_px + 2))
    for polygon in region.polygons:
        for i, ring in enumerate(polygon):
            sign = np.sign(turn(ring)) * (1 if i == 0 else -1)
            _add_edges(ring, sign, total)
    cover = np.cumsum(total, axis=1)[:, :width_px]
    return np.asarray(cover.clip(0.0, 1.0))


def _add_edges(ring: Floats, sign: float, total: Floats) -> None:
    starts, ends = ring, np.roll(ring, -1, axis=0)
    for axis in (1, 0):  # cut at rows, then at columns: each piece lies in a pixel
        starts, ends = _cut(starts, ends, axis)
    middle = (starts + ends) / 2
    column, row = np.floor(middle).astype(np.intp).T
    row, column = row.clip(0, len(total) - 1), column.clip(0, total.shape[1] - 2)
    height = sign * (starts[:, 1] - ends[:, 1])
    right = 1 - (middle[:, 0] - column)
    np.add.at(total, (row, column), height * right)
    np.add.at(total, (row, column + 1), height * (1 - right))


def _cut(starts: Floats, ends: Floats, axis: int) -> tuple[Floats, Floats]:
    """Segments cut where a coordinate is a whole number."""
    low = np.minimum(starts[:, axis], ends[:, axis])
    high = np.maximum(starts[:, axis], ends[:, axis])
    first = np.floor(low).astype(np.intp) + 1
    counts = np.maximum(np.ceil(high).astype(np.intp) - first, 0) + 1
    owner = np.repeat(np.arange(len(starts)), counts)
    number = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    begin, way, inner = starts[owner], (ends - starts)[owner], counts[owner] - 1
    length = np.where(way[:, axis] == 0, 1.0, way[:, axis])

    def at(cut: Indices) -> Floats:
        """Points at cuts counted from the start on; -1 is the start itself."""
        line = first[owner] + np.where(length < 0, inner - 1 - cut, cut)
        share = ((line - begin[:, axis]) / length).clip(0, 1)
        share = np.where(cut < 0, 0.0, np.where(cut == inner, 1.0, share))
        return np.asarray(begin + share[:, None] * way)

    return at(number - 1), at(number)


def mask_of(region: Region, width_px: int, height_px: int) -> bytes:
    """A PNG, white where the region is and black elsewhere."""
    cover = coverage(region, width_px, height_px)
    return image_file(np.rint(255 * cover).astype(np.uint8)[..., None])


def mask_names(regions: Sequence[Region], stem: str) -> Iterator[str]:
    """The name of a file for each region, such as 'torus_mask_Cup.png'; no two are the same."""
    taken: set[str] = set()
    for region in regions:
        plain = "".join(c if c.isalnum() or c in "-_ ." else "_" for c in region.name)
        name, number = plain, 2
        while name.casefold() in taken:
            name, number = f"{plain}_{number}", number + 1
        taken.add(name.casefold())
        yield f"{stem}_mask_{name}.png"
