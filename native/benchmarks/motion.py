"""How much of a drawing holds still from frame to frame, whoever drew it.

Strokes are taken along with the surface and the camera into the next frame; what is still seen
there is compared with what that frame drew. All distances are in spacings.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import illustrate_native as ill
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree  # type: ignore[import-untyped]

Doubles = NDArray[np.float64]

PARALLEL = np.sqrt(0.5)  # cosine
STEADY, TURNED = 0.25, 0.75  # spacings
BORN_LENGTH = 2.0  # spacings: shorter strokes may come and go
BORN_SHARE = 0.25  # of a stroke that must have been there
FARTHEST = 4.0  # spacings: what has nothing near it is so far away


class Eye:
    """What a camera sees of a surface, and how deep."""

    def __init__(
        self, camera: ill.Camera, positions: Doubles, triangles: NDArray[np.int32]
    ) -> None:
        self._clip = np.asarray(camera.projection) @ np.asarray(camera.view)
        self._view = np.asarray(camera.view)
        self._size = np.array([camera.width_px, camera.height_px])
        self._nearest = self._depth_map(positions, triangles)

    def image(self, world: Doubles) -> tuple[Doubles, Doubles]:
        """(n, 2) pixels and (n,) depth."""
        clip = np.c_[world, np.ones(len(world))] @ self._clip.T
        xy = (clip[:, :2] / clip[:, 3:] * [1, -1] + 1) / 2 * self._size
        return xy, -(world @ self._view[2, :3] + self._view[2, 3])

    def pixel_size(self, depth: Doubles) -> Doubles:
        """World length of a pixel at a depth."""
        inverse = np.linalg.inv(self._clip)
        ends = np.array([[0, 0, 0, 1], [2 / self._size[0], 0, 0, 1]]) @ inverse.T
        at_end = ends[:, :3] / ends[:, 3:]
        reference = -(at_end[0] @ self._view[2, :3] + self._view[2, 3])
        is_perspective = abs(self._clip[3, :3]).max() > 0
        size = np.linalg.norm(at_end[1] - at_end[0])
        return size * depth / reference if is_perspective else np.full(len(depth), size)

    def sees(self, image: Doubles, depth: Doubles, slack_px: float) -> NDArray[np.bool_]:
        """Whether nothing is before points by more than so many pixels."""
        cell = np.floor(image).astype(int)
        inside = np.all((cell >= 0) & (cell < self._size), axis=1)
        column, row = np.where(inside[:, None], cell, 0).T
        hidden = depth > self._nearest[row, column] + slack_px * self.pixel_size(depth)
        seen: NDArray[np.bool_] = np.logical_and(inside, ~hidden)
        return seen

    def _depth_map(self, positions: Doubles, triangles: NDArray[np.int32]) -> Doubles:
        nearest = np.full(self._size[::-1], np.inf)
        corners = positions[triangles]
        image = self.image(positions)[0][triangles]
        edges = np.linalg.norm(image - np.roll(image, 1, axis=1), axis=2).max(axis=1)
        for parts in np.unique(np.ceil(edges).astype(int).clip(1, 64)):
            chosen = corners[np.ceil(edges).astype(int).clip(1, 64) == parts]
            for i in range(parts + 1):
                for j in range(parts + 1 - i):
                    weights = np.array([parts - i - j, i, j]) / parts
                    self._enter(np.einsum("k,nkd->nd", weights, chosen), nearest)
        return nearest

    def _enter(self, points: Doubles, nearest: Doubles) -> None:
        image, depth = self.image(points)
        cell = np.floor(image).astype(int)
        inside = np.flatnonzero(np.all((cell >= 0) & (cell < self._size), axis=1))
        np.minimum.at(nearest, (cell[inside, 1], cell[inside, 0]), depth[inside])


@dataclass(frozen=True)
class Samples:
    """Places along strokes, a pixel apart."""

    world: Doubles  # (n, 3)
    tangent: Doubles  # (n, 3) unit
    stroke: NDArray[np.intp]  # (n,)
    image: Doubles  # (n, 2)
    depth: Doubles  # (n,)

    def part(self, chosen: NDArray[np.bool_]) -> Samples:
        """Those that are chosen."""
        return Samples(*(values[chosen] for values in vars(self).values()))


def samples_of(strokes: Sequence[Doubles], eye: Eye) -> Samples:
    """strokes: (k, 3) world points of each."""
    world, tangent, owner = [np.zeros((0, 3))], [np.zeros((0, 3))], [np.zeros(0, np.intp)]
    for number, line in enumerate(strokes):
        image = eye.image(line)[0]
        steps = np.linalg.norm(np.diff(image, axis=0), axis=1)
        arc = np.r_[0, np.cumsum(steps)]
        if not arc[-1] > 0:
            continue
        at = np.arange(0.5, max(arc[-1], 1.0))[: max(int(arc[-1]), 1)]
        i = np.clip(np.searchsorted(arc, at, "right") - 1, 0, len(steps) - 1)
        share = ((at - arc[i]) / np.maximum(steps[i], 1e-12))[:, None]
        way = np.diff(line, axis=0)[i]
        world.append(line[i] + share * way)
        tangent.append(way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-300))
        owner.append(np.full(len(at), number, np.intp))
    points = np.concatenate(world)
    return Samples(points, np.concatenate(tangent), np.concatenate(owner), *eye.image(points))


def strokes_of(drawing: ill.Drawing, kinds: Sequence[ill.Kind]) -> list[Doubles]:
    """World points of a drawing's strokes of some kinds."""
    chosen = np.isin(drawing.kinds, [int(kind) for kind in kinds])
    lines = [
        np.asarray(drawing.points[start:end])
        for start, end in zip(drawing.offsets, drawing.offsets[1:], strict=False)
    ]
    return [
        np.r_[line, line[:1]] if closed else line
        for line, closed, is_chosen in zip(lines, drawing.closed, chosen, strict=True)
        if is_chosen
    ]


def moved(samples: Samples, eye: Eye, spacing_px: float) -> Samples:
    """What a resting surface carries of them into the view of another eye, and that sees."""
    image, depth = eye.image(samples.world)
    there = Samples(samples.world, samples.tangent, samples.stroke, image, depth)
    return there.part(eye.sees(image, depth, spacing_px / 2))


def compare(
    last: Samples, now: Samples, last_eye: Eye, eye: Eye, spacing_px: float
) -> dict[str, float]:
    """steady, turned, births, deaths and the weighted Chamfer distance between two frames."""
    there, back = moved(last, eye, spacing_px), moved(now, last_eye, spacing_px)
    near, alike, across = _nearest(there, now, eye, spacing_px)
    near_back, _, _ = _nearest(back, last, last_eye, spacing_px)
    return {
        "steady": float(np.mean(alike < STEADY)) if len(alike) else np.nan,
        "turned": float(np.mean((across < TURNED) & (alike >= TURNED))) if len(alike) else np.nan,
        "births": _sudden(now, near_back, back, spacing_px),
        "deaths": _sudden(last, near, there, spacing_px),
        "chamfer": weighted_chamfer(near, near_back),
    }


def weighted_chamfer(one: Doubles, other: Doubles) -> float:
    """Of the distances from each drawing to the other (arXiv 2408.09131).

    Both means together, times a weight: 1/2 for drawings of as much, 1 where one has far more.
    """
    if not (len(one) and len(other)):
        return float("nan")
    excess = abs(len(one) - len(other)) / min(len(one), len(other))
    return float((one.mean() + other.mean()) / (1 + np.exp(-excess)))


def _nearest(
    samples: Samples, others: Samples, eye: Eye, spacing_px: float
) -> tuple[Doubles, Doubles, Doubles]:
    """Of each sample, in spacings: how far the nearest others of its depth are.

    Of any direction, of those that run parallel, and of those that run across.
    """
    found = np.full((3, len(samples.image)), FARTHEST)
    if not len(others.image):
        return found[0], found[1], found[2]
    tree, reach = cKDTree(others.image), FARTHEST * spacing_px
    distance, index = tree.query(
        samples.image, k=min(64, len(others.image)), distance_upper_bound=reach
    )
    is_there = np.isfinite(distance)
    index = np.where(is_there, index, 0)
    slack = 3 * spacing_px * eye.pixel_size(samples.depth)
    is_there &= np.abs(others.depth[index] - samples.depth[:, None]) < slack[:, None]
    cosine = np.abs(np.einsum("nkd,nd->nk", others.tangent[index], samples.tangent))
    for row, chosen in enumerate((is_there, is_there & (cosine > PARALLEL),
                                  is_there & (cosine <= PARALLEL))):  # fmt: skip
        nearest = np.where(chosen, distance, np.inf).min(axis=1) / spacing_px
        found[row] = np.minimum(nearest, FARTHEST)
    return found[0], found[1], found[2]


def _sudden(samples: Samples, near: Doubles, seen: Samples, spacing_px: float) -> float:
    """Strokes, for each 1000 spacings of all, of which nearly nothing is in the other frame.

    Of those that have some length and are seen in both.
    """
    count = int(samples.stroke.max(initial=-1)) + 1
    length = np.bincount(samples.stroke, minlength=count)
    in_both = np.bincount(seen.stroke, minlength=count)
    there = np.bincount(seen.stroke[near < 2 * STEADY], minlength=count)
    long = (length > BORN_LENGTH * spacing_px) & (in_both > 0.5 * length)
    sudden = long & (there < BORN_SHARE * in_both)
    return float(sudden.sum() / max(length.sum() / spacing_px / 1000, 1e-9))
