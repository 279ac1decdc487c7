"""A map in relief: two ranges and a plain.

Hatches follow the slopes, as on maps of the nineteenth century; light comes from the north-west, so
the slopes that lie away from it are dark.
"""

from typing import Any

import bpy
import formulas
import numpy as np
import scenes


def build() -> None:
    """Seen from above, a little from the south."""
    land = scenes.add("Land", relief())
    scenes.finish([land], toward_camera=(0.0, -0.5, 1.0), size=(1600, 1050))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 6.0, 2.6
    settings.highlight_threshold, settings.shadow_threshold = 0.86, 0.52
    settings.undercut_px, settings.mach_band_px, settings.hatch_width_by_light = 8.0, 3.0, 0.9


def relief(cells: int = 220) -> tuple[Any, Any]:
    """Two ranges, foothills, and a valley that is filled to one level."""
    x, y = np.meshgrid(np.linspace(-1.6, 1.6, cells + 1), np.linspace(-1, 1, cells * 5 // 8 + 1),
                       indexing="ij")  # fmt: skip
    ridge = np.exp(-(((y - 0.35 - 0.22 * np.sin(2.1 * x)) / 0.3) ** 2))
    ridge *= 0.75 + 0.25 * np.cos(3 * x)
    second = np.exp(-(((y + 0.45 - 0.18 * np.sin(2.6 * x + 1.2)) / 0.24) ** 2)) * np.exp(
        -(((x - 0.55) / 0.8) ** 2)
    )
    spurs = 0.5 + 0.5 * np.sin(9 * x + 2.5 * np.sin(3 * y)) * np.cos(5 * y + 1.5 * np.sin(4 * x))
    peaks = 0.5 + 0.5 * np.sin(14 * x + 3 * np.sin(6 * y + 1)) * np.sin(11 * y + 2 * np.cos(5 * x))
    z = 0.62 * ridge * (0.55 + 0.45 * spurs) + 0.42 * second * (0.6 + 0.4 * spurs)
    z = z + 0.07 * peaks * (ridge + second + 0.15) + 0.05 * spurs
    level = 0.055
    soft = 0.012
    z = level + soft * np.logaddexp(0, (z - level) / soft)
    positions = np.stack([x, y, 1.25 * z], axis=-1)
    return positions.reshape(-1, 3), formulas.grid_quads(np.arange(z.size).reshape(z.shape))
