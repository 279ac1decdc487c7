"""Saves a small file to draw: a camera goes round a head for as long as the scene lasts.

    blender -b --factory-startup --python make_shot.py -- FILE.blend FRAMES KIND

KIND: "apart", whose frames say nothing of each other; "following", whose strokes follow those of
the frame before; "blind", without a camera; "cut", whose camera cannot be drawn from the middle on.
"""

import sys
from math import radians
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parents[3] / "build" / "addons" / "illustrate"))
import headless

file, frames, kind = sys.argv[-3], int(sys.argv[-2]), sys.argv[-1]
headless.find_package()
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
scene = bpy.context.scene
scene.frame_start, scene.frame_end = 1, frames
scene.render.resolution_x, scene.render.resolution_y = 400, 300
scene.illustrate.keep_strokes = kind == "following"
scene.illustrate.auto_exposure = True
scene.illustrate.output = "GREASE_PENCIL"

bpy.ops.mesh.primitive_monkey_add()
bpy.context.object.modifiers.new("Subdivision", "SUBSURF").levels = 1
bpy.ops.object.light_add(type="SUN", rotation=(radians(40), radians(20), 0))
bpy.ops.object.camera_add(location=(0, -6, 0), rotation=(radians(90), 0, 0))
camera = bpy.context.object
bpy.ops.object.empty_add()
camera.parent = middle = bpy.context.object
for frame, turn in ((1, 0), (frames, 60)):
    middle.rotation_euler.z = radians(turn)
    middle.keyframe_insert("rotation_euler", frame=frame)
scene.camera = None if kind == "blind" else camera
if kind == "cut":
    scene.timeline_markers.new("seen", frame=1).camera = camera
    unseeing = bpy.data.objects.new("Unseeing", bpy.data.cameras.new("Unseeing"))
    unseeing.data.type = "PANO"
    scene.collection.objects.link(unseeing)
    scene.timeline_markers.new("unseeing", frame=frames // 2 + 1).camera = unseeing
bpy.ops.wm.save_as_mainfile(filepath=file)
