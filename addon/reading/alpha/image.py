"""Alpha of an image as a function of the plane that is positive where the image shows something.

An image is blurred over the cells that it is looked at in, and over two texels at least: its level
is then a smooth curve, no staircase of texels, and what is finer than a cell fades instead of
becoming dots.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from ...running.cache import digest

PADDING: dict[str, Any] = {
    "repeat": "wrap",
    "mirror": "symmetric",
    "extend": "edge",
    "clip": "edge",
}
FINEST_BLUR = 2  # texels
LEAST_THRESHOLD = 0.002  # below half a step of a byte all is opaque, and nothing is beyond the top


@dataclass
class AlphaImage:
    """An image of alpha and the level it is cut at. Raises ValueError for a wrong argument."""

    values: Any  # (h, w) float, rows upwards
    wrap: str = "repeat"  # mirror, extend; clip: nothing outside of the image
    threshold: float = 0.5  # what is at least so opaque is there
    _blurred: dict[int, Any] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        self.values = np.asarray(self.values, np.float32)
        if self.values.ndim != 2 or not self.values.size:
            raise ValueError(f"values: expected (h, w) texels, not {self.values.shape}")
        if self.wrap not in PADDING:
            raise ValueError(f"wrap: {self.wrap!r} is not one of {', '.join(PADDING)}")
        if not 0 <= self.threshold <= 1:
            raise ValueError(f"threshold: {self.threshold} is not between 0 and 1")

    @cached_property
    def key(self) -> str:
        """A name for what it shows, found once however many meshes share it."""
        return f"{self.wrap} {self.threshold} {digest(self.values)}"

    @property
    def size(self) -> Any:
        """(2,) texels across and upwards."""
        return np.array(self.values.shape[::-1], float)

    @cached_property
    def _alone(self) -> "AlphaImage":
        return replace(self, wrap="extend", _blurred={})

    def seen_at(self, uv: Any) -> "AlphaImage":
        """The image as it is seen at uv (..., 2): alone, where no more than one copy of it is.

        Else the stem at the lower rim of a leaf would show beyond its tip, at the upper rim.
        """
        is_alone = self.wrap == "repeat" and uv.size and uv.min() >= 0 and uv.max() <= 1
        return self._alone if is_alone else self

    def above(self, uv: Any, cell: int) -> Any:
        """(...) how far alpha is above the threshold at uv (..., 2), by cells of so many texels.

        Not negative where something is. Linear across the border of a clipped image, which is so
        straight however it lies in the cells.
        """
        level = min(max(self.threshold, LEAST_THRESHOLD), 1 - LEAST_THRESHOLD)
        found = self._sampled(uv, self._blur(max(cell, FINEST_BLUR))) - level
        if self.wrap == "clip":
            inside = (np.minimum(uv, 1 - uv) * self.size).min(axis=-1)
            found = np.minimum(found, inside / max(cell, FINEST_BLUR))
        return found

    def _sampled(self, uv: Any, values: Any) -> Any:
        """Bilinear between the middles of texels."""
        across, upwards = (uv * self.size - 0.5)[..., 0], (uv * self.size - 0.5)[..., 1]
        x, y = np.floor(across).astype(np.int64), np.floor(upwards).astype(np.int64)
        s, t = (across - x).astype(np.float32), (upwards - y).astype(np.float32)
        left, right = self._wrapped(x, 1), self._wrapped(x + 1, 1)
        below, above = self._wrapped(y, 0), self._wrapped(y + 1, 0)
        low = values[below, left] * (1 - s) + values[below, right] * s
        high = values[above, left] * (1 - s) + values[above, right] * s
        return low * (1 - t) + high * t

    def _wrapped(self, index: Any, axis: int) -> Any:
        """Texels that stand for those of any number."""
        count = self.values.shape[axis]
        if self.wrap == "repeat":
            return index % count
        if self.wrap == "mirror":
            turned = index % (2 * count)
            return np.where(turned < count, turned, 2 * count - 1 - turned)
        return index.clip(0, count - 1)

    def _blur(self, width: int) -> Any:
        """(h, w) weighed means that fade to nothing `width` texels away."""
        if width not in self._blurred:
            padded = np.pad(np.nan_to_num(self.values), width, mode=PADDING[self.wrap])
            for axis in (0, 1):
                padded = _tent(padded, width, axis)
            self._blurred[width] = padded.astype(np.float32)
        return self._blurred[width]


def _tent(values: Any, width: int, axis: int) -> Any:
    """Two means over `width` values, forwards and back; shorter by `width` at either end."""
    moved = np.moveaxis(values.astype(float), axis, -1)
    for _ in range(2):
        sums = np.cumsum(np.insert(moved, 0, 0.0, axis=-1), axis=-1)
        moved = (sums[..., width:] - sums[..., :-width]) / width
    return np.moveaxis(moved[..., 1:-1], -1, axis)
