"""An interior: a room with a table at the window.

Only flat walls and boxes, in wide perspective: hatches run along the walls and boards, and what the
sun through the window does not reach is darker.
"""

import bpy
import modelling
import scenes
from mathutils import Vector
from modelling import box

LENS_MM = 26.0


def build() -> None:
    """The camera stands in the room, the sun outside."""
    scenes.add("Room", room(), smooth=False)
    scenes.add("Table", table((0.75, 1.5), 1.5, 0.85, 0.74), smooth=False)
    for number, (x, y, side) in enumerate(((0.35, 1.0, -1), (1.2, 2.05, 1))):
        scenes.add(f"Chair {number}", chair(x, y, side), smooth=False)
    jug = modelling.turned([(0.01, 0), (0.07, 0), (0.11, 0.06), (0.12, 0.13), (0.08, 0.22),
                            (0.06, 0.26), (0.08, 0.31)])  # fmt: skip
    scenes.add("Jug", (jug[0] + (0.9, 1.55, 0.74), jug[1]))
    stand((-1.6, -1.9, 1.5), (0.35, 2.3, 0.95))
    settings = bpy.context.scene.illustrate
    settings.line_width_px, settings.feature_width_px, settings.spacing_px = 2.6, 2.2, 8.0
    settings.undercut_px, settings.mach_band_px, settings.highlight_threshold = 8.0, 3.0, 0.7


def room() -> modelling.Mesh:
    """Floor, the wall ahead with a picture, and the wall on the right with a window."""
    floor = box((5, 6.5, 0.1), (0, 0.2, -0.05))
    ahead = box((5, 0.12, 2.8), (0, 3.4, 1.4))
    rails = [box((0.9, 0.05, 0.06), (-1.1, 3.32, z)) for z in (1.2, 1.9)]
    stiles = [box((0.06, 0.05, 0.7), (x, 3.32, 1.55)) for x in (-1.52, -0.68)]
    skirting = box((5, 0.04, 0.12), (0, 3.33, 0.06))
    low, high, near, far = 0.85, 2.2, 0.9, 2.5
    middle = (low + high) / 2
    wall = [box((0.14, 6.5, low), (2.3, 0.2, low / 2)),
            box((0.14, 6.5, 2.8 - high), (2.3, 0.2, (2.8 + high) / 2)),
            box((0.14, near + 3.05, high - low), (2.3, (near - 3.05) / 2, middle)),
            box((0.14, 3.4 - far, high - low), (2.3, (3.4 + far) / 2, middle))]  # fmt: skip
    bars = [box((0.05, 0.05, high - low), (2.3, (near + far) / 2, middle)),
            box((0.05, far - near, 0.05), (2.3, (near + far) / 2, 1.65)),
            box((0.3, far - near + 0.1, 0.05), (2.18, (near + far) / 2, low - 0.02))]  # fmt: skip
    return modelling.joined([floor, ahead, *rails, *stiles, skirting, *wall, *bars])


def table(place: tuple[float, float], long: float, wide: float, high: float) -> modelling.Mesh:
    """A board on four legs."""
    x, y = place
    legs = [box((0.07, 0.07, high - 0.04), (x + i * (long / 2 - 0.1), y + j * (wide / 2 - 0.1),
                                            (high - 0.04) / 2))
            for i in (-1, 1) for j in (-1, 1)]  # fmt: skip
    return modelling.joined([box((long, wide, 0.05), (x, y, high - 0.025)), *legs])


def chair(x: float, y: float, side: int) -> modelling.Mesh:
    """A chair whose back is on that side of it."""
    back = y + side * 0.2
    rails = [box((0.4, 0.03, 0.08), (x, back, z)) for z in (0.62, 0.78, 0.94)]
    posts = [box((0.04, 0.04, 1.0), (x + i * 0.19, back, 0.5)) for i in (-1, 1)]
    legs = [box((0.04, 0.04, 0.45), (x + i * 0.19, y - side * 0.19, 0.225)) for i in (-1, 1)]
    return modelling.joined([box((0.44, 0.44, 0.04), (x, y, 0.46)), *rails, *posts, *legs])


def stand(eye: tuple[float, ...], target: tuple[float, ...]) -> None:
    """A camera at the eye, a sun that shines through the window, and a little light of the room."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 1600, 1150
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens, camera.data.clip_start = LENS_MM, 0.05
    camera.location = eye
    camera.rotation_euler = (Vector(target) - Vector(eye)).to_track_quat("-Z", "Y").to_euler()
    for name, way, energy in (("Sun", (0.75, -0.12, 0.5), 4.0), ("Sky", (-0.5, -0.7, 0.9), 1.2)):
        sun = bpy.data.objects.new(name, bpy.data.lights.new(name, "SUN"))
        sun.data.energy = energy
        sun.data.use_shadow = name == "Sun"
        sun.rotation_euler = Vector(way).to_track_quat("Z", "Y").to_euler()
        scene.collection.objects.link(sun)
    scene.collection.objects.link(camera)
    scene.camera = camera
