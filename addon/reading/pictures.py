"""Images of Blender's as linear luminance."""

from typing import Any

import numpy as np

from ..messages import said

LUMINANCE = (0.2126, 0.7152, 0.0722)
MOST_TEXELS = 8192 * 8192
RGBA = 4  # channels
OPAQUE_DEPTHS = (8, 24, 96)  # bits of a pixel: grey, and three colours of bytes or floats
SIDE = 2048  # larger images are averaged down to about that


def read_image(image: Any) -> Any:
    """(h, w) float32 luminance, linear, rows upwards. Raises ValueError in words of the artist."""
    pixels = _read_pixels(image)
    colours = pixels[..., :3] if image.channels > 2 else pixels[..., :1]
    # Pixels of bytes come as the file has them, floats are linear already.
    if image.colorspace_settings.name == "sRGB" and not image.is_float:
        colours = _linear(colours)
    weights = np.array(LUMINANCE if colours.shape[2] == 3 else (1.0,), np.float32)
    return np.ascontiguousarray(colours @ weights)


def read_alpha(image: Any) -> Any:
    """(h, w) float32 alpha, rows upwards. Raises ValueError as `read_image` does."""
    pixels = _read_pixels(image)
    # Blender gives alpha of 1 to files that have none.
    if image.channels != RGBA or image.depth in OPAQUE_DEPTHS or image.alpha_mode == "NONE":
        raise ValueError(said("it has no alpha"))
    return np.ascontiguousarray(pixels[..., -1])


def _read_pixels(image: Any) -> Any:
    """(h, w, channels) float32 as the file has them, large ones averaged."""
    width, height = image.size
    if not width * height:
        raise ValueError(said("its file is missing or cannot be read"))
    if width * height > MOST_TEXELS:
        raise ValueError(
            said(
                "it has {width} x {height} pixels, more than {most}",
                width=width,
                height=height,
                most=MOST_TEXELS,
            )
        )
    pixels = np.zeros(width * height * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    return _averaged(pixels.reshape(height, width, image.channels))


def _averaged(pixels: Any) -> Any:
    """Means of squares of pixels, so that no side is much longer than SIDE."""
    step = -(-max(pixels.shape[:2]) // SIDE)
    if step == 1:
        return pixels
    height, width = (max(size // step, 1) for size in pixels.shape[:2])
    tall, wide = min(step, pixels.shape[0]), min(step, pixels.shape[1])
    cut = pixels[: height * tall, : width * wide]
    return cut.reshape(height, tall, width, wide, -1).mean(axis=(1, 3))


def _linear(encoded: Any) -> Any:
    """From sRGB's encoding to light."""
    low = encoded / 12.92
    return np.where(encoded <= 0.04045, low, ((encoded.clip(0) + 0.055) / 1.055) ** 2.4)
