"""The small pictures of the presets that the add-on comes with: a corner of Suzanne in each style.

    blender -b --factory-startup --python-exit-code 3 --python examples/thumbnails.py -- [FOLDER]

They go beside the presets, or to FOLDER. The same presets make the same bytes.
"""

import pathlib
import sys
from typing import Any

import bpy
from mathutils import Vector

ROOT = pathlib.Path(__file__).resolve().parents[1]
PRESETS = ROOT / "addon" / "presets" / "illustrate"
SIZE_PX = 160
PAGE_MM = 45.0  # of presets in millimetres: a detail of their page
PLACE, TARGET = Vector((1.6, -3.6, 1.0)), Vector((0.05, 0.0, 0.05))


def make_scene() -> Any:
    """Suzanne's head, as large as the picture, with light from the left."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    bpy.ops.object.shade_smooth()
    monkey.modifiers.new("Subdivision", "SUBSURF").levels = 2
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = PLACE
    camera.rotation_euler = (PLACE - TARGET).to_track_quat("Z", "Y").to_euler()
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.rotation_euler = (0.7, -0.5, 0.0)
    for thing in (camera, sun):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = SIZE_PX
    return scene


def thumbnail(scene: Any, preset: str) -> bytes:
    """A PNG of the scene with a preset's settings."""
    from illustrate.output.files import Page
    from illustrate.output.png import png_of
    from illustrate.running import illustration
    from illustrate.ui import presets

    presets.apply(preset)
    if scene.illustrate.unit == "MILLIMETRE":
        scene.illustrate.page_width_mm = PAGE_MM
    if scene.illustrate.tone_source != "LIGHTS":
        scene.illustrate.tone_source = "LIGHTS"  # there is nothing to be rendered or read
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    png: bytes = png_of(Page(scene, made.drawing, made.arrays.camera, made.names, []))
    return png


def write_all(folder: pathlib.Path) -> list[pathlib.Path]:
    """One picture for each preset; their files."""
    scene, written = make_scene(), []
    for preset in sorted(PRESETS.glob("*.py")):
        path = folder / f"{preset.stem}.png"
        path.write_bytes(thumbnail(scene, preset.stem))
        written.append(path)
    return written


def main() -> None:
    """Finds the add-on and writes the pictures."""
    sys.path[:0] = [str(ROOT / "build" / "addons")]
    import illustrate

    illustrate.register()
    own = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    folder = pathlib.Path(own[0]) if own else PRESETS
    folder.mkdir(parents=True, exist_ok=True)
    for path in write_all(folder):
        print(path.name, path.stat().st_size)


if __name__ == "__main__":
    main()
