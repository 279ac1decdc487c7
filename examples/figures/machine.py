"""A machine: two gears on their shafts.

Flat faces and round ones in one drawing: edges where faces turn by more than thirty degrees, smooth
hatches round the shafts, and the shadows that the shafts cast.
"""

import bpy
import modelling
import numpy as np
import scenes


def build() -> None:
    """A large gear, a small one that it drives, and a plate behind."""
    far = 1.62
    large = gear_wheel(30, 1.1, 0.075, 0.35, 0.0)
    small = gear_wheel(14, 0.513, 0.075, 0.35, np.pi / 14 + 0.02)
    things = [
        scenes.add("Gear", large, smooth=False),
        scenes.add("Pinion", (small[0] + (far, 0, 0), small[1]), smooth=False),
        scenes.add("Shaft", shaft(0.0, 0.26), smooth=False),
        scenes.add("Pinion Shaft", shaft(far, 0.15), smooth=False),
        scenes.add("Plate", plate(far), smooth=False),
    ]
    scenes.finish(things, toward_camera=(-0.75, -0.9, 1.25), size=(1500, 1150))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 7.0, 3.0
    settings.feature_width_px, settings.undercut_px, settings.mach_band_px = 1.8, 12.0, 5.0


def gear_wheel(
    teeth: int, radius: float, depth: float, width: float, turn: float
) -> modelling.Mesh:
    """A gear round the z axis with a hub on top."""
    rim = modelling.gear(teeth, radius, depth)
    c, s = np.cos(turn), np.sin(turn)
    rim = rim @ np.array([[c, s], [-s, c]])
    hub = modelling.turned([(0.42 * radius, width), (0.42 * radius, width + 0.12),
                            (0.38 * radius, width + 0.16), (0.05, width + 0.16)])  # fmt: skip
    return modelling.joined([modelling.plate(rim, width), hub])


def shaft(x: float, radius: float) -> modelling.Mesh:
    """A shaft with a chamfered end."""
    profile = [(radius, -0.5), (radius, 1.1), (0.85 * radius, 1.15), (0, 1.15)]
    positions, faces = modelling.turned(profile)
    return positions + np.array((x, 0, 0)), faces


def plate(far: float) -> modelling.Mesh:
    """The plate that holds the shafts, rounded at both ends."""
    angle = np.linspace(np.pi / 2, 3 * np.pi / 2, 25)
    left = np.column_stack([0.62 * np.cos(angle), 0.62 * np.sin(angle)])
    right = (far, 0) - left * 0.75
    positions, faces = modelling.plate(np.concatenate([left, right]), 0.25)
    return positions - (0, 0, 0.5), faces
