"""Scenes to test with, what is read of them, and strokes as seen without the add-on's code."""

import ctypes
import os
import pathlib
import subprocess
import sys
from typing import Any

import bpy
import numpy as np
from mathutils import Vector

V3 = bpy.app.version >= (4, 3, 0)
Stroke = dict[str, Any]


def read(scene: Any, **options: Any) -> Any:
    """What the add-on reads of the scene."""
    from illustrate.reading.scene import read_scene  # not before user.py has installed it

    return read_scene(scene, bpy.context.evaluated_depsgraph_get(), **options)


def run_script(
    script: Any,
    *arguments: str,
    blend: Any = None,
    user: Any = None,
    variables: dict[str, str] | None = None,
) -> subprocess.CompletedProcess[str]:
    """Runs a script in another process of this Blender, program or module.

    blend: a file to open. user: a folder for the settings of a new user; else those of this one.
    variables: of the environment, besides those of this process.
    """
    opened = [] if blend is None else [str(blend)]
    command = [sys.executable, str(script), *opened, *arguments]
    if bpy.app.binary_path:
        start = [bpy.app.binary_path, "-b", "--factory-startup", *opened]
        command = [*start, "--python-exit-code", "3", "--python", str(script), "--", *arguments]
    variables = {**os.environ, **(variables or {})}
    for name in ("RESOURCES", "CONFIG", "SCRIPTS") if user else ():
        folder = pathlib.Path(user) / name.lower()
        folder.mkdir(parents=True, exist_ok=True)
        variables[f"BLENDER_USER_{name}"] = str(folder)
    return subprocess.run(
        command, capture_output=True, text=True, timeout=300, check=False, env=variables
    )


def new_file() -> None:
    """An empty file; unlike the factory's settings it leaves add-ons enabled."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def add_camera(scene: Any, place: Any = (5, -6, 4), size: Any = (320, 240), **settings: Any) -> Any:
    """A camera at `place` that looks at the origin."""
    camera = bpy.data.objects.new("Eye", bpy.data.cameras.new("Eye"))
    for name, value in settings.items():
        setattr(camera.data, name, value)
    camera.location = place
    camera.rotation_euler = Vector(place).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = size
    return camera


def add_cube(name: str = "Box", place: Any = (0, 0, 0)) -> Any:
    bpy.ops.mesh.primitive_cube_add(location=place)
    cube = bpy.context.object
    cube.name = cube.data.name = name
    return cube


def add_mesh(name: str, positions: Any, faces: Any) -> Any:
    data = bpy.data.meshes.new(name)
    data.from_pydata(positions, [], faces)
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def subdivide(thing: Any, **settings: Any) -> Any:
    modifier = thing.modifiers.new("Subdivision", "SUBSURF")
    for name, value in settings.items():
        setattr(modifier, name, value)
    return modifier


def cube_scene(scene: Any) -> Any:
    """A cube before a camera, with a sun; the cube."""
    add_camera(scene)
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    scene.collection.objects.link(sun)
    return add_cube()


def shade_smooth(thing: Any, smooth: Any) -> None:
    thing.data.polygons.foreach_set("use_smooth", smooth)
    thing.data.update()


def pencil_type() -> str:
    return "GREASEPENCIL" if V3 else "GPENCIL"


def read_pencil(thing: Any) -> dict[str, list[Stroke]]:
    """Strokes of a Grease Pencil object by layer, all frames."""
    found: dict[str, list[Stroke]] = {}
    for layer in thing.data.layers:
        name = layer.name if V3 else layer.info
        found[name] = [
            _stroke(s) for f in layer.frames for s in (f.drawing.strokes if V3 else f.strokes)
        ]
    return found


def _stroke(stroke: Any) -> Stroke:
    if V3:
        return {
            "points": np.array([p.position for p in stroke.points]),
            "radii": np.array([p.radius for p in stroke.points]),
            "closed": stroke.cyclic,
        }
    return {
        "points": np.array([p.co for p in stroke.points]),
        "closed": stroke.use_cyclic,
        "radii": np.array([p.pressure for p in stroke.points]) * stroke.line_width / 2000,
    }


def read_curves(things: Any) -> dict[str, list[Stroke]]:
    """Strokes of curve objects by what follows 'Illustration ' in their names."""
    return {
        thing.name.partition(" ")[2]: [
            {
                "points": np.array([p.co[:3] for p in spline.points]),
                "closed": spline.use_cyclic_u,
                "radii": np.array([p.radius for p in spline.points]) * thing.data.bevel_depth,
            }
            for spline in thing.data.splines
        ]
        for thing in things
    }


def add_artists_stroke(layer: Any, material: int = 0) -> None:
    """A stroke of three points at (7, 7, 7)."""
    frame = layer.frames[0] if len(layer.frames) else layer.frames.new(1)
    if V3:
        frame.drawing.add_strokes([3])
        points = frame.drawing.strokes[len(frame.drawing.strokes) - 1].points
        for point in points:
            point.position = (7, 7, 7)
        return
    stroke = frame.strokes.new()
    stroke.line_width, stroke.material_index = 30, material
    stroke.points.add(3)
    for point in stroke.points:
        point.co = (7, 7, 7)


def add_artists_stroke_at(layer: Any, number: int) -> None:
    """Puts a frame with a stroke of the artist's in place of the layer's frame."""
    old = next(frame for frame in layer.frames if frame.frame_number == number)
    layer.frames.remove(number if V3 else old)
    frame = layer.frames.new(number)
    if V3:
        frame.drawing.add_strokes([2])
        return
    stroke = frame.strokes.new()
    stroke.line_width = 30
    stroke.points.add(2)


def artists_bytes(layer: Any) -> list[Any]:
    """Strokes of a layer that are not the add-on's, with all that they have, by frame."""
    found = []
    for frame in layer.frames:
        strokes = frame.drawing.strokes if V3 else frame.strokes
        if V3:
            kinds = frame.drawing.attributes.get("illustrate_kind")
            is_ours = [bool(v.value) for v in kinds.data] if kinds else [False] * len(strokes)
        else:
            is_ours = [stroke.line_width == 1000 for stroke in strokes]
        found += [
            (frame.frame_number, frame.keyframe_type, _everything(stroke))
            for stroke, ours in zip(strokes, is_ours, strict=True)
            if not ours
        ]
    return found


def _everything(stroke: Any) -> str:
    """All properties of a stroke and of its points."""

    def values(thing: Any) -> list[Any]:
        names = sorted(p.identifier for p in thing.bl_rna.properties if p.identifier != "rna_type")
        read = [
            (name, getattr(thing, name)) for name in names if name not in ("points", "edit_curve")
        ]
        return [(n, tuple(v) if hasattr(v, "__len__") and not isinstance(v, str) else v)
                for n, v in read]  # fmt: skip

    if V3:
        points = [(tuple(p.position), p.radius, p.opacity) for p in stroke.points]
        return repr((stroke.cyclic, stroke.material_index, stroke.softness, points))
    return repr((values(stroke), [values(point) for point in stroke.points]))


def is_artists(stroke: Stroke) -> bool:
    return bool((stroke["points"] == 7).all())


def flush() -> None:
    """So that what Blender printed can be read."""
    library = "ucrtbase" if sys.platform == "win32" else None
    ctypes.CDLL(library).fflush(None)


def snapshot() -> dict[str, Any]:
    """What an operator that fails must leave as it was."""
    blocks = {
        name: sorted(
            block.name for block in getattr(bpy.data, name) if block.name != "Render Result"
        )
        for name in (
            "objects",
            "meshes",
            "scenes",
            "materials",
            "collections",
            "cameras",
            "curves",
            "worlds",
            "grease_pencils",
            "lights",
            "images",
        )
    }
    scene = bpy.context.scene
    things = {
        thing.name: (
            list(map(tuple, thing.matrix_world)),
            thing.select_get(),
            [m.name for m in thing.modifiers],
        )
        for thing in scene.objects
    }
    return {
        **blocks,
        "things": things,
        "frame": scene.frame_current,
        "engine": scene.render.engine,
        "active": bpy.context.view_layer.objects.active,
    }
