"""Lengths on paper as lengths in the image."""

import math


def lengths_in_pixels(pixels_per_mm: float, **lengths_mm: float) -> dict[str, float]:
    """Lengths in millimetres, named `..._mm`, as lengths in pixels, named `..._px`.

        scale = camera_width_px / page_width_mm
        DrawOptions(**lengths_in_pixels(scale, mach_band_mm=0.5, undercut_mm=1.2))

    Raises TypeError for a name that does not end in _mm, ValueError for a scale or length that is
    not finite, a scale that is not positive or a length that is negative.
    """
    if not (math.isfinite(pixels_per_mm) and pixels_per_mm > 0):
        raise ValueError(f"pixels_per_mm is {pixels_per_mm}: it must be positive and finite")
    pixels = {}
    for name, length in lengths_mm.items():
        if not name.endswith("_mm"):
            raise TypeError(f"{name} is no length in millimetres: its name must end in _mm")
        if not (math.isfinite(length) and length >= 0):
            raise ValueError(f"{name} is {length}: it must be at least 0 and finite")
        pixels[name.removesuffix("_mm") + "_px"] = length * pixels_per_mm
    return pixels
