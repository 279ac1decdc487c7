"""A vehicle: a toy locomotive.

Made of turned parts and boxes that pass into each other: where they do, the lines of intersection
are drawn, though no edge of any mesh is there.
"""

import bpy
import modelling
import numpy as np
import scenes
from modelling import box, turned, turned_to


def build() -> None:
    """Boiler, funnel, dome, cab, frame and six wheels; it runs along x."""
    parts = {
        "Boiler": turned_to(
            turned([(0, 1.62), (0.3, 1.6), (0.46, 1.5), (0.5, 1.4), (0.5, -0.9), (0, -0.9)]),
            "x", (0, 0, 1.05)),
        "Funnel": moved(turned([(0, 0.3), (0.16, 0.3), (0.17, 0.7), (0.2, 0.85), (0.3, 1.15),
                                (0.31, 1.22), (0.26, 1.22), (0.2, 1.05), (0, 1.0)]),
                        (1.15, 0, 1.05)),
        "Dome": moved(turned([(0.3, 0.35), (0.26, 0.55), (0.26, 0.7), (0.2, 0.83), (0.1, 0.9),
                              (0, 0.92)]), (0.1, 0, 1.05)),
        "Frame": box((3.4, 0.8, 0.16), (0.1, 0, 0.5)),
        "Buffer": box((0.14, 1.15, 0.26), (1.85, 0, 0.45)),
        "Cab": modelling.joined([box((0.9, 1.1, 0.75), (-1.2, 0, 0.95)),
                                 *(box((0.09, 0.09, 1.0), (x, y, 1.62)) for x in (-1.6, -0.8)
                                   for y in (-0.48, 0.48))]),
        "Roof": roof(),
    }  # fmt: skip
    for number, x in enumerate((-1.1, -0.15, 0.8)):
        for side in (-1, 1):
            parts[f"Wheel {number} {side}"] = wheel(x, side)
    things = [scenes.add(name, mesh, smooth=False) for name, mesh in parts.items()]
    scenes.finish(things, toward_camera=(1.0, -1.35, 0.55), size=(1600, 1200))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 7.5, 3.2
    settings.feature_width_px, settings.undercut_px, settings.mach_band_px = 2.0, 13.0, 5.0


def moved(mesh: modelling.Mesh, way: tuple[float, float, float]) -> modelling.Mesh:
    """The mesh in another place."""
    return mesh[0] + np.array(way), mesh[1]


def wheel(x: float, side: int) -> modelling.Mesh:
    """A disc wheel with a rim and a hub."""
    profile = [(0, 0.16), (0.1, 0.16), (0.1, 0.08), (0.33, 0.07), (0.33, 0.12), (0.4, 0.12)]
    profile += [(0.4, 0.0), (0, 0.0)]
    positions, faces = turned(profile)
    return turned_to((positions * (1, 1, side), faces), "y", (x, 0.42 * side, 0.4))


def roof() -> modelling.Mesh:
    """A plate bent over the cab."""
    angle = np.linspace(-0.62, 0.62, 21)
    outer = np.column_stack([1.15 * np.sin(angle), 1.15 * np.cos(angle)])
    outline = np.concatenate([outer, (outer * (1.1 / 1.15))[::-1]])
    positions, faces = modelling.plate(outline, 1.2)
    return turned_to((positions - (0, 1.15, 0.6), faces), "x", (-1.2, 0, 2.26))
