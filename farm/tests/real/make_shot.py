"""Saves a file to draw: a small one, where a camera goes round a head for as long as the scene
lasts, or the walking robot of the examples.

    blender -b --factory-startup --python make_shot.py -- FILE.blend FRAMES KIND

KIND: "apart", whose frames say nothing of each other; "following", whose strokes follow those of
the frame before; "blind", without a camera; "cut", whose camera cannot be drawn from the middle on;
"robot", whose strokes follow those of the frame before.
"""

import sys
from math import radians
from pathlib import Path

import bpy

ROOT = Path(__file__).parents[3]
sys.path += [str(ROOT / "build" / "addons" / "illustrate"), str(ROOT / "examples")]
import headless  # noqa: E402
import scenes  # noqa: E402


def head(frames: int, kind: str) -> None:
    """Suzanne under a sun, on a page of 400 x 300 pixels."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 400, 300
    bpy.ops.mesh.primitive_monkey_add()
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.object.light_add(type="SUN", rotation=(radians(40), radians(20), 0))
    scene.camera = None if kind == "blind" else orbiting_camera(frames)
    if kind == "cut":
        scene.timeline_markers.new("seen", frame=1).camera = scene.camera
        scene.timeline_markers.new("unseeing", frame=frames // 2 + 1).camera = panorama()


def orbiting_camera(frames: int) -> bpy.types.Object:
    """A camera that turns by 60 degrees round the middle."""
    bpy.ops.object.camera_add(location=(0, -6, 0), rotation=(radians(90), 0, 0))
    camera = bpy.context.object
    bpy.ops.object.empty_add()
    camera.parent = middle = bpy.context.object
    for frame, turn in ((1, 0), (frames, 60)):
        middle.rotation_euler.z = radians(turn)
        middle.keyframe_insert("rotation_euler", frame=frame)
    return camera


def panorama() -> bpy.types.Object:
    """A camera that cannot be drawn."""
    camera = bpy.data.objects.new("Unseeing", bpy.data.cameras.new("Unseeing"))
    camera.data.type = "PANO"
    bpy.context.scene.collection.objects.link(camera)
    return camera


def make(file: str, frames: int, kind: str) -> None:
    """Saves a file of one of the kinds."""
    headless.find_package()
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    if kind == "robot":
        scenes.robot()
    else:
        head(frames, kind)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, frames
    scene.illustrate.keep_strokes = kind in ("following", "robot")
    scene.illustrate.auto_exposure = True
    scene.illustrate.output = "GREASE_PENCIL"
    bpy.ops.wm.save_as_mainfile(filepath=file)


make(sys.argv[-3], int(sys.argv[-2]), sys.argv[-1])
