"""Pictures of triangles without a window: an orthographic view, a depth buffer, PNG files."""

import pathlib
import struct
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np

SIZE_PX, MARGIN_PX = 800, 40


@dataclass(frozen=True)
class View:
    """An orthographic view that fills the picture with an object.

    axes: (3, 3) rows right, up, towards the viewer. low: (2,) and scale: from world to px.
    """

    axes: Any
    low: Any
    scale: float

    @classmethod
    def of(cls, positions: Any, toward_camera: Any) -> "View":
        """Of positions (n, 3), y up; toward_camera (3,) is not vertical."""
        back = np.asarray(toward_camera, float) / np.linalg.norm(toward_camera)
        right = np.cross((0.0, 1.0, 0.0), back)
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(back, right), back])
        flat = positions @ axes[:2].T
        extent = np.ptp(flat, axis=0)
        scale = (SIZE_PX - 2 * MARGIN_PX) / extent.max()
        middle = flat.min(axis=0) + extent / 2
        return cls(axes, middle - SIZE_PX / 2 / scale, scale)

    def project(self, positions: Any) -> Any:
        """(n, 3): px to the right, px downwards, depth that grows towards the viewer."""
        x, y = ((positions @ self.axes[:2].T - self.low) * self.scale).T
        return np.stack([x, SIZE_PX - y, positions @ self.axes[2]], axis=1)


def rasterise(points: Any, triangles: Any) -> tuple[Any, Any]:
    """The nearest triangle at each pixel, -1: none, and the weights of its corners (..., 3).

    points: (n, 3) as of `View.project`. Triangles whose boxes fit the same square of 2^i pixels are
    done at once, against all pixels of their squares.
    """
    nearest = np.full(SIZE_PX * SIZE_PX, -1)
    weights, depths = np.zeros((SIZE_PX * SIZE_PX, 3)), np.full(SIZE_PX * SIZE_PX, -np.inf)
    flat = points[triangles, :2]
    first = np.ceil(flat.min(axis=1) - 0.5).astype(int)
    size = (np.floor(flat.max(axis=1) - 0.5).astype(int) - first + 1).clip(0)
    sides = 1 << np.ceil(np.log2(size.max(axis=1).clip(1))).astype(int)
    sides[size.min(axis=1) == 0] = 0
    for side in np.unique(sides[sides > 0]):
        offsets = np.stack(np.divmod(np.arange(side * side), side)[::-1], axis=1)
        members = np.flatnonzero(sides == side)
        for part in np.array_split(members, 1 + members.size * side**2 // 2_000_000):
            pixels = first[part, None] + offsets
            w = _barycentrics(flat[part], pixels + 0.5)
            t, k = np.nonzero(
                (w >= -1e-9).all(axis=2) & ((pixels >= 0) & (pixels < SIZE_PX)).all(axis=2)
            )
            place, w = pixels[t, k] @ (1, SIZE_PX), w[t, k]
            depth = (w * points[triangles[part[t]], 2]).sum(axis=1)
            order = np.lexsort((depth, place))
            order = order[np.append(np.diff(place[order]) > 0, True)] if order.size else order
            order = order[depth[order] > depths[place[order]]]
            depths[place[order]], weights[place[order]] = depth[order], w[order]
            nearest[place[order]] = part[t[order]]
    return nearest.reshape(SIZE_PX, SIZE_PX), weights.reshape(SIZE_PX, SIZE_PX, 3)


def _barycentrics(flat: Any, at: Any) -> Any:
    """(t, p, 3) of points at (t, p, 2) in triangles flat (t, 3, 2); -1 where there are none."""
    a, b, c = (flat[:, None, k] for k in range(3))

    def double_area(p: Any, q: Any, r: Any) -> Any:
        u, v = q - p, r - p
        return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]

    whole = double_area(a, b, c)
    whole = np.where(whole == 0, -np.inf, whole)
    w1, w2 = double_area(a, at, c) / whole, double_area(a, b, at) / whole
    return np.where(np.isinf(whole)[..., None], -1.0, np.stack([1 - w1 - w2, w1, w2], axis=-1))


def write_png(path: pathlib.Path, image: Any) -> None:
    """Writes (h, w, 3) values from 0 to 255."""
    height, width = image.shape[:2]
    pixels = np.rint(image).astype(np.uint8).reshape(height, -1)
    rows = np.full((height, 1 + 3 * width), 2, np.uint8)  # rows begin with 2: less the one above
    rows[:, 1:] = np.diff(pixels, axis=0, prepend=np.zeros_like(pixels[:1]))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    data = b"\x89PNG\r\n\x1a\n"
    for kind, body in (
        (b"IHDR", header),
        (b"IDAT", zlib.compress(rows.tobytes())),
        (b"IEND", b""),
    ):
        data += struct.pack(">I", len(body)) + kind + body
        data += struct.pack(">I", zlib.crc32(kind + body))
    path.write_bytes(data)
