"""A cross field as SVG: short crosses on what a camera sees, and a mark at each singularity.

Needs numpy only. The same field gives the same bytes.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
Indices = NDArray[np.int64]

_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{width}mm" height="{height}mm"
     viewBox="0 0 {width_px} {height_px}">"""
_LEAST_W = 1e-9  # of points before the eye
_CROSSES = {
    "reliable": "#1c1c1c",  # the directions of curvature, kept
    "free": "#7b8794",
}
_MARKS = {1: "#c8102e", -1: "#1450c8"}


class SurfaceArrays(Protocol):
    """What is read of an `illustrate_native.Surface`."""

    @property
    def positions(self) -> Doubles:
        """(n, 3)."""

    @property
    def normals(self) -> Doubles:
        """(n, 3)."""

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3)."""


class FieldArrays(Protocol):
    """What is read of an `illustrate_native.CrossField`."""

    @property
    def directions(self) -> Doubles:
        """(n, 3)."""

    @property
    def reliable(self) -> NDArray[np.bool_]:
        """(n,)."""

    @property
    def singular_triangles(self) -> NDArray[np.int32]:
        """(s,)."""

    @property
    def singular_indices(self) -> NDArray[np.int32]:
        """(s,)."""


class CameraArrays(Protocol):
    """What is read of an `illustrate_native.Camera`."""

    @property
    def projection(self) -> Doubles:
        """(4, 4)."""

    @property
    def view(self) -> Doubles:
        """(4, 4)."""

    @property
    def width_px(self) -> int:
        """Of the image."""

    @property
    def height_px(self) -> int:
        """Of the image."""


def field_to_svg(
    surface: SurfaceArrays,
    field: FieldArrays,
    camera: CameraArrays,
    spacing_px: float = 14.0,
    width_mm: float = 200.0,
) -> str:
    """SVG text of the field of a surface as a camera sees it.

    A cross every spacing_px, foreshortened as it lies on the surface: black where the vertex is
    reliable, grey where it was free. A disc for each singularity in sight, red for a positive
    index, blue for a negative one, as large as its index. The page is width_mm wide.
    Raises ValueError naming the argument that cannot be used.
    """
    if not (np.isfinite(spacing_px) and spacing_px >= 1):
        raise ValueError(f"spacing_px is {spacing_px}: it must be at least 1")
    if not (np.isfinite(width_mm) and width_mm > 0):
        raise ValueError(f"width_mm is {width_mm}: it must be positive")
    width, height = camera.width_px, camera.height_px
    head = _HEAD.format(
        width=f"{width_mm:.10g}",
        height=f"{width_mm * height / width:.10g}",
        width_px=width,
        height_px=height,
    )
    view = _View(camera)
    image, depth = view.project(np.asarray(surface.positions, float))
    triangles = np.asarray(surface.triangles, np.int64)
    triangles_seen = _Seen(image, depth, triangles, width, height, spacing_px)
    lines = [head, '<rect width="100%" height="100%" fill="#fff"/>']
    lines += _crosses(surface, field, view, triangles_seen, spacing_px)
    lines += _marks(field, triangles_seen, spacing_px)
    return "\n".join([*lines, "</svg>", ""])


def project(camera: CameraArrays, points: Doubles) -> tuple[Doubles, Doubles]:
    """Pixels (p, 2) and clip coordinates z, w (p, 2) of points (p, 3); NaN behind the eye."""
    matrix = np.asarray(camera.projection) @ np.asarray(camera.view)
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    w = np.where(clip[:, 3:] > _LEAST_W, clip[:, 3:], np.nan)
    image = (clip[:, :2] / w * (1, -1) + 1) / 2 * (camera.width_px, camera.height_px)
    return image, np.hstack([clip[:, 2:3] / w, w])


class _View:
    """A camera as it is needed here."""

    def __init__(self, camera: CameraArrays) -> None:
        self.camera = camera
        self.scale = float(camera.projection[0, 0]) * camera.width_px / 2

    def project(self, points: Doubles) -> tuple[Doubles, Doubles]:
        """As `project` of its camera."""
        return project(self.camera, points)

    def pixels_per_unit(self, depth: Doubles) -> Doubles:
        """Of a length across the view at points of this depth."""
        return self.scale / depth[:, 1]


class _Seen:
    """The nearest triangle at each node of a grid in the image.

    points (m, 2) px, triangles (m,), weights (m, 3) of their corners.
    """

    def __init__(
        self,
        image: Doubles,
        depth: Doubles,
        triangles: Indices,
        width: int,
        height: int,
        spacing: float,
    ) -> None:
        self._corners, self._depths = image[triangles], depth[triangles, 0]
        columns, rows = max(1, int(width / spacing)), max(1, int(height / spacing))
        node, triangle = _candidates(self._corners / spacing - 0.5, columns, rows)
        at = (np.stack([node % columns, node // columns], axis=1).astype(float) + 0.5) * spacing
        weights, depths = self._weigh(at, triangle)
        hit = np.flatnonzero(np.isfinite(depths))
        hit = hit[np.lexsort((triangle[hit], depths[hit], node[hit]))]
        first = hit[np.unique(node[hit], return_index=True)[1]]
        self.points, self.triangles, self.weights = at[first], triangle[first], weights[first]

    def _weigh(self, at: Doubles, triangle: Indices) -> tuple[Doubles, Doubles]:
        """Weights (c, 3) and depth (c,) of points (c, 2) in triangles (c,); NaN outside."""
        a, b, c = np.moveaxis(self._corners[triangle], 1, 0)
        areas = np.stack([_area(b, c, at), _area(c, a, at), _area(a, b, at)], axis=1)
        whole = areas.sum(axis=1, keepdims=True)
        weights = np.divide(areas, whole, out=np.full_like(areas, np.nan), where=whole != 0)
        depth = (weights * self._depths[triangle]).sum(axis=1)
        return weights, np.where((weights >= 0).all(axis=1), depth, np.nan)

    def is_nearest(self, triangle: int) -> bool:
        """Whether nothing hides the middle of a triangle."""
        middle = self.middle(triangle)
        if not np.isfinite(middle).all():
            return False
        low, high = self._corners.min(axis=1), self._corners.max(axis=1)
        near = np.flatnonzero(((low <= middle) & (middle <= high)).all(axis=1))
        depths = self._weigh(np.broadcast_to(middle, (len(near), 2)), near)[1]
        hit = np.flatnonzero(np.isfinite(depths))
        return len(hit) > 0 and int(near[hit[depths[hit].argmin()]]) == triangle

    def middle(self, triangle: int) -> Doubles:
        """(2,) px."""
        middle: Doubles = self._corners[triangle].mean(axis=0)
        return middle


def _area(a: Doubles, b: Doubles, c: Doubles) -> Doubles:
    """Twice the signed areas of triangles of points (c, 2)."""
    u, v = b - a, c - a
    area: Doubles = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return area


def _candidates(corners: Doubles, columns: int, rows: int) -> tuple[Indices, Indices]:
    """Nodes of the grid in the box of each triangle, with the triangle; corners in grid steps."""
    most = np.array([columns, rows]) - 1
    whole = np.isfinite(corners.reshape(-1, 6).sum(axis=1))
    boxed = np.where(whole[:, None, None], corners, -2.0)
    low = np.ceil(boxed.min(axis=1).clip(0, most + 1.0)).astype(np.int64)
    high = np.floor(boxed.max(axis=1).clip(-1, most)).astype(np.int64)
    size = (high - low + 1).clip(0)
    count = size.prod(axis=1)
    triangle = np.repeat(np.arange(len(corners)), count)
    inside = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    row, column = np.divmod(inside, size[triangle, 0].clip(1))
    return (low[triangle, 1] + row) * columns + low[triangle, 0] + column, triangle


def _crosses(
    surface: SurfaceArrays, field: FieldArrays, view: _View, seen: _Seen, spacing: float
) -> list[str]:
    """One path for all reliable crosses, one for the others."""
    corners = np.asarray(surface.triangles)[seen.triangles]
    places = np.einsum("mk,mka->ma", seen.weights, np.asarray(surface.positions)[corners])
    main = np.take_along_axis(corners, seen.weights.argmax(axis=1)[:, None], axis=1)[:, 0]
    along = np.asarray(field.directions)[main]
    across = np.cross(np.asarray(surface.normals)[main], along)
    reach = 0.42 * spacing / view.pixels_per_unit(view.project(places)[1])[:, None]
    arms = []
    for arm in (along, across):
        tips = [view.project(places + sign * reach * arm)[0] for sign in (-1, 1)]
        arms.append(np.stack(tips, axis=1))
    ends = np.stack(arms, axis=1)  # (m, 2 arms, 2 ends, 2)
    lines = []
    for name, colour in _CROSSES.items():
        chosen = np.asarray(field.reliable)[main] == (name == "reliable")
        data = "".join(
            "M{:.10g},{:.10g} {:.10g},{:.10g}".format(*(np.round(line, 2).ravel() + 0.0))
            for line in ends[chosen].reshape(-1, 2, 2)
            if np.isfinite(line).all()
        )
        lines.append(
            f'<path id="{name}" fill="none" stroke="{colour}" stroke-width="1" '
            f'stroke-linecap="round" d="{data}"/>'
        )
    return lines


def _marks(field: FieldArrays, seen: _Seen, spacing: float) -> list[str]:
    """A disc for each singularity that is in sight."""
    lines = ['<g id="singularities">']
    listed = zip(field.singular_triangles.tolist(), field.singular_indices.tolist(), strict=True)
    for triangle, index in listed:
        if not seen.is_nearest(triangle):
            continue
        x, y = seen.middle(triangle)
        radius = 0.35 * spacing * np.sqrt(abs(index))
        lines.append(
            f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}" '
            f'fill="{_MARKS[1 if index > 0 else -1]}"><title>{index:+d}</title></circle>'
        )
    return [*lines, "</g>"]
