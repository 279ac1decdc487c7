"""The example scenes: each function builds one in the open, empty Blender file.

A scene has its objects, a camera that frames them, and a sun from the upper left.
"""

import os
import pathlib
from collections.abc import Callable
from typing import Any

import bpy
import formulas
import numpy as np
from mathutils import Matrix, Vector
from mesh_files import read_mesh, write_obj

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHARED = pathlib.Path(os.environ.get("ILLUSTRATE_SHARED", ROOT.parent / "shared"))

LENS_MM = 70.0  # on a sensor 36 mm wide: a quiet perspective
MARGIN = 1.08  # how much farther the camera stands than the objects just fit
SUN_IN_VIEW = (-0.62, 0.55, 0.56)  # towards the light: left, up, towards the viewer


def suzanne() -> None:
    """Blender's monkey with a Subdivision modifier."""
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    subdivide(monkey)
    finish([monkey], toward_camera=(0.55, -1.5, 0.25), size=(1400, 1200))


def torus_sphere() -> None:
    """A torus that pierces a sphere."""
    ball = add("Sphere", formulas.sphere(1.0))
    ring = add("Torus", formulas.torus(1.0, 0.36))
    ring.matrix_world = (
        Matrix.Translation((0.85, -0.25, 0.12))
        @ Matrix.Rotation(0.5, 4, "Y")
        @ Matrix.Rotation(0.62, 4, "X")
    )
    finish([ball, ring], toward_camera=(0.35, -1.5, 0.75), size=(1500, 1100))


def klein() -> None:
    """The Klein bottle, whose neck passes through its own side."""
    bottle = add("Klein Bottle", formulas.klein_bottle())
    finish([bottle], toward_camera=(-1.1, -1.0, -0.75), size=(1200, 1500))


def drape() -> None:
    """A cloth hanging in folds."""
    cloth = add("Drape", formulas.drape())
    finish([cloth], toward_camera=(0.5, -1.6, 0.4), size=(1500, 1300))


def goblet() -> None:
    """A goblet in light from the side that shades its own foot; tones by shares of the area."""
    cup = add("Goblet", formulas.goblet())
    subdivide(cup)
    finish([cup], toward_camera=(1, -0.4, 0.55), size=(1200, 1600))
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.tones, settings.cast_shadows = "SIDE", "AREA", True


def turntable() -> None:
    """Suzanne, round whom the camera goes."""
    suzanne()
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 700, 600
    pivot = bpy.data.objects.new("Pivot", None)
    scene.collection.objects.link(pivot)
    scene.camera.parent = pivot
    for frame, turn in ((1, 0.0), (13, np.pi / 6)):
        pivot.rotation_euler[2] = turn
        pivot.keyframe_insert("rotation_euler", frame=frame)
    for curve in _curves(pivot.animation_data.action):
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"


def _curves(action: Any) -> Any:
    """The curves of an action of one object; from Blender 5.0 they lie in layers."""
    if hasattr(action, "fcurves"):
        return action.fcurves
    return action.layers[0].strips[0].channelbags[0].fcurves


def robot() -> None:
    """A walking robot of fourteen parts."""
    bpy.ops.wm.open_mainfile(filepath=str(SHARED / "scenes" / "RobotExpressive.blend"))
    bpy.data.objects["RobotArmature"].animation_data.action = bpy.data.actions["Robot_Walking"]
    parts = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    finish(parts, toward_camera=(0.62, -1.0, 0.5), size=(700, 700))


def cube() -> None:
    """Blender's plain cube."""
    bpy.ops.mesh.primitive_cube_add()
    finish([bpy.context.object], toward_camera=(0.7, -1.3, 0.75), size=(1400, 1200))


def spot() -> None:
    """A cow: a control cage of quads with a Subdivision modifier."""
    cow = add_file("smooth/spot_cage.obj")
    subdivide(cow)
    finish([cow], toward_camera=(-0.9, 1.3, 0.35), size=(1400, 1300))


def koala() -> None:
    """A scan of 100,000 triangles."""
    finish([add_file("smooth/koala_100k.ply")], toward_camera=(-0.5, -1.5, 0.3), size=(1400, 1400))


SCENES: dict[str, Callable[[], None]] = {
    "suzanne": suzanne,
    "torus_sphere": torus_sphere,
    "klein": klein,
    "drape": drape,
    "goblet": goblet,
    "cube": cube,
    "spot_cage": spot,
    "koala_100k": koala,
}

SEQUENCES: dict[str, Callable[[], None]] = {"turntable": turntable, "robot": robot}
"""Scenes that move; the demo draws frames 1 to 8."""

FILES = {
    "spot_cage": "meshes/smooth/spot_cage.obj",
    "koala_100k": "meshes/smooth/koala_100k.ply",
    "robot": "scenes/RobotExpressive.blend",
}
"""What a scene reads from the shared folder."""

CAGES = {"suzanne": "Suzanne"}
"""Objects whose control cages the demo leaves as .obj, for curvature.py."""


def is_available(name: str) -> bool:
    """Whether the scene's files are there."""
    return name not in FILES or (SHARED / FILES[name]).is_file()


def build(name: str) -> Any:
    """Empties the open file and builds a scene of SCENES or SEQUENCES in it; the scene."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    {**SCENES, **SEQUENCES}[name]()
    return bpy.context.scene


def add(name: str, mesh: tuple[Any, Any], smooth: bool = True) -> Any:
    """Links an object with positions (n, 3) and faces to the scene; the object.

    Shaded flat it has hard edges where faces turn much, and is smooth elsewhere.
    """
    positions, faces = np.asarray(mesh[0]).tolist(), [list(map(int, face)) for face in mesh[1]]
    return _link(_mesh_data(name, positions, faces), smooth)


def add_file(path: str) -> Any:
    """Links a smooth object from the folder of shared meshes, whose y axis is up, to the scene."""
    file = SHARED / "meshes" / path
    positions, faces = read_mesh(file)
    thing = _link(_mesh_data(file.stem, positions, faces))
    thing.matrix_world = Matrix.Rotation(np.pi / 2, 4, "X")
    return thing


def save_cage(path: pathlib.Path, name: str) -> None:
    """Writes the mesh of an object without its modifiers, y up, as .obj."""
    data = bpy.data.objects[name].data
    positions = [(v.co.x, v.co.z, -v.co.y) for v in data.vertices]
    write_obj(path, positions, [face.vertices for face in data.polygons])


def _mesh_data(name: str, positions: list[Any], faces: list[Any]) -> Any:
    data = bpy.data.meshes.new(name)
    data.from_pydata(positions, [], faces)
    return data


def _link(data: Any, smooth: bool = True) -> Any:
    data.polygons.foreach_set("use_smooth", np.full(len(data.polygons), smooth))
    thing = bpy.data.objects.new(data.name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def subdivide(thing: Any, levels: int = 2) -> None:
    """Gives the object a Subdivision modifier, and smooth shading."""
    modifier = thing.modifiers.new("Subdivision", "SUBSURF")
    modifier.levels = modifier.render_levels = levels
    thing.data.polygons.foreach_set("use_smooth", np.ones(len(thing.data.polygons), bool))


def finish(
    things: list[Any], toward_camera: tuple[float, float, float], size: tuple[int, int]
) -> None:
    """Sets the size of the render, a camera that frames the objects and the sun."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = size
    back = Vector(toward_camera).normalized()
    turn = back.to_track_quat("Z", "Y").to_matrix().to_4x4()
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = LENS_MM
    camera.matrix_world = turn
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    light = (turn @ Vector(SUN_IN_VIEW)).normalized()
    sun.matrix_world = light.to_track_quat("Z", "Y").to_matrix().to_4x4()
    for thing in (camera, sun):
        scene.collection.objects.link(thing)
    scene.camera = camera
    _frame(camera, things)


def _frame(camera: Any, things: list[Any]) -> None:
    """Moves the camera, without turning it, until the objects fill the picture to a margin."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    points = np.concatenate([_world_points(thing.evaluated_get(depsgraph)) for thing in things])
    place, _ = camera.camera_fit_coords(depsgraph, points.ravel().tolist())
    centre = Vector((points.min(axis=0) + points.max(axis=0)) / 2)
    camera.matrix_world.translation = place + (MARGIN - 1) * (place - centre)
    camera.data.clip_end = 4 * (place - centre).length
    camera.data.clip_start = camera.data.clip_end / 1000


def _world_points(thing: Any) -> Any:
    points = np.zeros(3 * len(thing.data.vertices), np.float32)
    thing.data.vertices.foreach_get("co", points)
    matrix = np.array(thing.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
