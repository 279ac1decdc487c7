"""Where hatches run (paper, figure 8).

From left to right: silhouettes alone; hatches near the raw directions of curvature, restless
wherever the surface bends alike in both directions; directions kept where one curvature is at most
two thirds of the other; only where they are reliable; all of them smoothed.
"""

from typing import Any

import bpy
import scenes

PANELS: tuple[dict[str, Any], ...] = (
    {"hatching": False},
    {"parabolic_ratio": 1.0, "largest_energy": 2.0, "least_curvature": 0.0},
    {"parabolic_ratio": 0.67, "largest_energy": 1.0},
    {},
    {"parabolic_ratio": 0.0},
)


def build() -> None:
    """Suzanne in light from the side, dark enough to be hatched all over."""
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    scenes.subdivide(monkey)
    scenes.finish([monkey], toward_camera=(0.55, -1.5, 0.25), size=(620, 640))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 6.0, 2.4
    settings.tones, settings.highlight_share, settings.shadow_share = "AREA", 0.1, 0.35
    settings.mach_band_px, settings.undercut_px = 4.0, 9.0
