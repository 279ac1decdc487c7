"""A motion strip: a ball that bounces.

Five frames of one animation, side by side: it squashes where it lands and stretches in flight, and
its hatches go with it.
"""

from typing import Any

import bpy
import formulas
import numpy as np
import scenes
from mathutils import Vector

FRAMES = (1, 4, 7, 10, 13)
HEIGHTS = (2.1, 1.25, 0.42, 1.3, 2.0)
STRETCH = (1.0, 1.15, 0.6, 1.18, 1.0)

PANELS: tuple[dict[str, Any], ...] = tuple({"frame_current": frame} for frame in FRAMES)


def build() -> None:
    """The ball falls, lands in the third frame, and rises again."""
    ball = scenes.add("Ball", formulas.sphere(0.6))
    plate = scenes.add("Plate", plate_mesh(), smooth=False)
    scenes.finish([plate], toward_camera=(0.15, -1.5, 0.32), size=(420, 760))
    camera = bpy.context.scene.camera
    camera.location = Vector((0.55, -8.6, 2.9))
    ahead = Vector((0, 0, 1.25)) - camera.location
    camera.rotation_euler = ahead.to_track_quat("-Z", "Y").to_euler()
    camera.data.clip_end = 100
    for frame, height, stretch in zip(FRAMES, HEIGHTS, STRETCH, strict=True):
        wide = 1 / np.sqrt(stretch)
        ball.location, ball.scale = (0, 0, height), (wide, wide, stretch)
        ball.keyframe_insert("location", frame=frame)
        ball.keyframe_insert("scale", frame=frame)
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 5.5, 2.4
    settings.undercut_px, settings.mach_band_px = 9.0, 3.0


def plate_mesh() -> tuple[Any, Any]:
    """A flat square to land on."""
    corners = np.array([[-0.9, -0.9, 0], [0.9, -0.9, 0], [0.9, 0.9, 0], [-0.9, 0.9, 0]], float)
    return corners, [[0, 1, 2, 3]]
