"""A Blender scene as arrays: evaluated meshes, camera, lights.

With mesh_arrays.py, guide_arrays.py, light_arrays.py and styles.py the only code that reads scene
data.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import bpy
import numpy as np

from .guide_arrays import GuideArrays, read_guides
from .light_arrays import LightArrays, exposed, read_light
from .mesh_arrays import MeshArrays, read_mesh
from .messages import IllustrateError, quoted
from .ownership import is_ours
from .styles import style_of

# Of refined surfaces, where the object is nearest to the camera, in units of paper: pixels of an
# image whose larger side is 1024. The surface, and with it every hatch, is so the same at any
# number of pixels; in images of over 4096 px a unit stays four pixels, as it does for lines.
EDGE_LENGTH = 3.0
UNITS_ACROSS = 1024.0
MOST_PIXELS = 4.0
MEASURED_EDGES = 20_000
LEEWAY = 1.4  # below 2, which would be another level
MOST_HALVINGS = 12  # more than any level of subdivision
DEFORMING_PARENTS = ("ARMATURE", "LATTICE")


@dataclass(frozen=True)
class CameraArrays:
    """Arguments of `illustrate_native.Camera`."""

    projection: Any  # (4, 4) clip from view
    view: Any  # (4, 4) view from world
    width_px: int
    height_px: int

    def pixel_size(self, points: Any) -> Any:
        """World length (p,) of a pixel across the view at the depths of points (p, 3)."""
        row = (self.projection @ self.view)[3]
        w = np.maximum(points @ row[:3] + row[3], self._least_w())
        return 2 * w / (self.projection[0, 0] * self.width_px)

    def unit_size(self, points: Any) -> Any:
        """World length (p,) of a unit of paper across the view at the depths of points (p, 3)."""
        unit = min(max(self.width_px, self.height_px) / UNITS_ACROSS, MOST_PIXELS)
        return unit * self.pixel_size(points)

    def _least_w(self) -> float:
        """Clip w of the near plane."""
        p = self.projection
        return 1.0 if p[3, 2] == 0 else float(p[2, 3] / (p[2, 2] - 1))


@dataclass
class SceneArrays:
    """All that a drawing is made from."""

    camera: CameraArrays
    meshes: list[MeshArrays] = field(default_factory=list)
    styles: list[dict[str, Any]] = field(default_factory=list)  # of the meshes; empty: the scene's
    lights: list[LightArrays] = field(default_factory=list)
    guides: GuideArrays = field(default_factory=GuideArrays)
    without_faces: list[str] = field(default_factory=list)  # objects that were left out


@dataclass
class _Placed:
    """One mesh at one place."""

    original: Any
    style: dict[str, Any]
    matrix: Any  # (4, 4)
    geometry: MeshArrays | None  # in its own space; None: the object's cage


def read_scene(
    scene: Any,
    depsgraph: Any,
    selected_only: bool = False,
    use_lights: bool = True,
    guides: Any = None,
    camera: CameraArrays | None = None,
    auto_exposure: bool = True,
) -> SceneArrays:
    """The evaluated scene as the camera's render would show it, meshes in the depsgraph's order.

    A Subdivision modifier that ends an object's stack is taken out: its cage is read, to be
    subdivided to the limit. Left out are objects hidden from viewport or render, illustrations,
    objects whose style says so, and the objects of the collection `guides`, which are read
    as such. camera: another one than the scene's. auto_exposure: lights are scaled so that the
    strongest is white in the middle of the meshes; without, they are as strong as in a render of
    white surfaces.
    Raises IllustrateError for a scene without a usable camera or without anything to draw.
    """
    arrays = SceneArrays(camera or read_camera(scene, depsgraph))
    guiding = set(guides.all_objects) if guides is not None else set()
    placed = _placed_meshes(scene, depsgraph, selected_only, guiding)
    cages = _read_cages([p.original for p in placed if p.geometry is None], scene)
    for p in placed:
        geometry = p.geometry or cages[p.original]
        if len(geometry.face_sizes):
            arrays.meshes.append(_in_world(geometry, p.matrix, arrays.camera))
            arrays.styles.append(p.style)
        else:
            arrays.without_faces.append(geometry.name)
    if not arrays.meshes:
        raise IllustrateError(nothing_to_draw(scene, selected_only, arrays.without_faces))
    if guides is not None:
        arrays.guides = read_guides(guides, scene.frame_current)
    if use_lights:
        arrays.lights = _read_lights(scene, depsgraph, _centre(arrays.meshes), auto_exposure)
    return arrays


def nothing_to_draw(scene: Any, selected_only: bool, without_faces: list[str]) -> str:
    """What is said of a scene without a mesh to draw, and the way out."""
    empty = f" ({quoted(without_faces)}: no faces)" if without_faces else ""
    if selected_only:
        return (
            f'No mesh with faces is selected in scene "{scene.name}"{empty}: '
            "select what is to be drawn, or set Draw to Scene"
        )
    return (
        f'Nothing in scene "{scene.name}" can be drawn{empty}: add a mesh with '
        "faces, or show one in viewport and render"
    )


# --- Camera -------------------------------------------------------------------------------------


def camera_problem(scene: Any) -> str:
    """Why the scene's camera cannot be drawn from, and the way out; empty when it can."""
    camera = scene.camera
    if camera is None:
        return f'Scene "{scene.name}" has no camera: add one, or choose one in the scene properties'
    if camera.type != "CAMERA":
        return (
            f'"{camera.name}", the camera of scene "{scene.name}", is not a '
            "camera: choose one in the scene properties"
        )
    if camera.data.type not in ("PERSP", "ORTHO"):
        kind = {"PANO": "panoramic"}.get(camera.data.type, camera.data.type.lower())
        return (
            f'Camera "{camera.name}" is {kind}, which cannot be drawn: set its '
            "type to Perspective or Orthographic"
        )
    return ""


def read_camera(scene: Any, depsgraph: Any) -> CameraArrays:
    """The scene's camera at its render size.

    Raises IllustrateError when there is none and for lenses that no matrix describes.
    """
    problem = camera_problem(scene)
    if problem:
        raise IllustrateError(problem)
    camera = scene.camera
    render = scene.render
    width = max(1, int(render.resolution_x * render.resolution_percentage / 100))
    height = max(1, int(render.resolution_y * render.resolution_percentage / 100))
    evaluated = camera.evaluated_get(depsgraph)
    projection = evaluated.calc_matrix_camera(
        depsgraph, x=width, y=height, scale_x=render.pixel_aspect_x, scale_y=render.pixel_aspect_y
    )
    try:
        view = evaluated.matrix_world.normalized().inverted()
    except ValueError as error:
        raise IllustrateError(
            f'Camera "{camera.name}" is scaled to nothing: clear its scale'
        ) from error
    return CameraArrays(np.array(projection), np.array(view), width, height)


# --- Lights -------------------------------------------------------------------------------------


def _read_lights(scene: Any, depsgraph: Any, centre: Any, auto_exposure: bool) -> list[LightArrays]:
    """Lights of the render; `auto_exposure`: the strongest at `centre` (3,) gives 1 there."""
    lights = []
    for instance in depsgraph.object_instances:
        lamp = instance.object
        if lamp.type == "LIGHT" and instance.show_self and not lamp.original.hide_render:
            lights.append(read_light(lamp.data, np.array(instance.matrix_world)))
    if auto_exposure:
        return exposed(lights, centre)
    for light in lights:
        light.strength *= 2.0**scene.view_settings.exposure
    return lights


def _centre(meshes: list[MeshArrays]) -> Any:
    """(3,) middle of the box round all finite vertices."""
    points = _finite(np.concatenate([mesh.positions for mesh in meshes]))
    return (points.min(axis=0) + points.max(axis=0)) / 2 if len(points) else np.zeros(3)


def _finite(points: Any) -> Any:
    return points[np.isfinite(points).all(axis=1)]


# --- Meshes -------------------------------------------------------------------------------------


def _placed_meshes(
    scene: Any, depsgraph: Any, selected_only: bool, left_out: set[Any]
) -> list[_Placed]:
    """Every mesh and instance that is seen; curves, texts and metaballs come as instances."""
    placed = []
    for instance in depsgraph.object_instances:
        thing = instance.object
        if thing.type != "MESH" or not instance.show_self:
            continue
        owner = (instance.parent if instance.is_instance else thing).original
        if is_ours(owner) or owner in left_out or owner.hide_render or thing.original.hide_render:
            continue
        if selected_only and not owner.select_get():
            continue
        style = style_of(owner, scene)
        if style.get("ignore"):
            continue
        matrix = np.array(instance.matrix_world)
        placed.append(_Placed(thing.original, style, matrix, _read_evaluated(thing, depsgraph)))
    return placed


def _read_evaluated(thing: Any, depsgraph: Any) -> MeshArrays | None:
    """The mesh of an evaluated object or instance; None where its cage is to be read instead."""
    own = thing.original.evaluated_get(depsgraph)
    if own.type != "MESH" or own.data != thing.data:
        return read_mesh(thing.data, thing.name, shading=True)
    subdivision = _trailing_subdivision(thing.original)
    if subdivision is not None and subdivision.subdivision_type == "CATMULL_CLARK":
        return None
    with _mesh_of(own) as mesh:
        geometry = read_mesh(mesh, thing.name, shading=True)
    if subdivision is not None:
        geometry.scheme = "none"  # subdivided without smoothing: the artist wants facets
    return geometry


@contextmanager
def _mesh_of(evaluated: Any) -> Iterator[Any]:
    """The mesh of an evaluated object. In edit mode its `data` may be empty: this one never is."""
    try:
        yield evaluated.to_mesh()
    finally:
        evaluated.to_mesh_clear()


def _trailing_subdivision(thing: Any) -> Any:
    """The Subdivision modifier that ends the stack of modifiers in use, or None."""
    used = [modifier for modifier in thing.modifiers if modifier.show_viewport]
    return used[-1] if used and used[-1].type == "SUBSURF" else None


def _read_cages(objects: list[Any], scene: Any) -> dict[Any, MeshArrays]:
    """The meshes below the last Subdivision of `objects`.

    Where nothing comes before the Subdivision, the cage is the mesh that is edited.
    """
    found = {thing: _read_cage(thing, thing.data) for thing in objects if _is_own_cage(thing)}
    others = [thing for thing in dict.fromkeys(objects) if thing not in found]
    return found | _evaluated_cages(others, scene) if others else found


def _is_own_cage(thing: Any) -> bool:
    """True where nothing changes the object's mesh but its last Subdivision."""
    return (
        sum(modifier.show_viewport for modifier in thing.modifiers) == 1
        and thing.mode != "EDIT"
        and thing.data.shape_keys is None
        and thing.parent_type not in DEFORMING_PARENTS
    )


def _evaluated_cages(objects: list[Any], scene: Any) -> dict[Any, MeshArrays]:
    """Cages evaluated in a scene of their own.

    The artist's scene is not evaluated again and nothing stays behind, but Blender draws its
    viewports anew.
    """
    stage = bpy.data.scenes.new("illustrate cages")
    copies: dict[Any, Any] = {}
    try:
        stage.frame_current = scene.frame_current
        for thing in objects:
            copies[thing] = copy = thing.copy()
            copy.modifiers.remove(_trailing_subdivision(copy))
            copy.hide_viewport = False
            stage.collection.objects.link(copy)
        layer = stage.view_layers[0]
        layer.update()
        cages = {}
        for thing, copy in copies.items():
            with _mesh_of(copy.evaluated_get(layer.depsgraph)) as mesh:
                cages[thing] = _read_cage(thing, mesh)
        return cages
    finally:
        for copy in copies.values():
            bpy.data.objects.remove(copy)
        bpy.data.batch_remove((stage,))  # `scenes.remove` crashes in a command of 4.3


def _read_cage(thing: Any, mesh: Any) -> MeshArrays:
    """The control mesh of a subdivision surface with the creases its modifier heeds."""
    subdivision = _trailing_subdivision(thing)
    geometry = read_mesh(mesh, thing.name, shading=False)
    geometry.scheme = "catmull-clark"
    geometry.boundary = "edges" if subdivision.boundary_smooth == "ALL" else "corners"
    if not subdivision.use_creases:
        geometry.edge_vertices, geometry.edge_sharpness = np.zeros((0, 2), np.int32), np.zeros(0)
        geometry.vertex_sharpness = None
    return geometry


def _in_world(geometry: MeshArrays, matrix: Any, camera: CameraArrays) -> MeshArrays:
    """A copy at its place, with the edge length its nearness to the camera asks for."""
    positions = geometry.positions @ matrix[:3, :3].T + matrix[:3, 3]
    sizes = camera.unit_size(_finite(positions))
    arrays = MeshArrays(**{**vars(geometry), "positions": positions})
    if len(sizes):
        arrays.edge_length = _halved(_median_edge(arrays), EDGE_LENGTH * float(sizes.min()))
    return arrays


def _halved(edge: float, longest: float) -> float:
    """What makes subdivision halve `edge` just as often as it must to be at most `longest`.

    It changes only where another level of subdivision does: while the camera moves, it stays the
    same to the last bit. LEEWAY is for edges that mending the mesh makes a little longer.
    """
    if not (edge > 0 and longest > 0):
        return longest
    halvings = min(max(math.ceil(math.log2(edge / longest)), 0), MOST_HALVINGS)
    return LEEWAY * math.ldexp(edge, -halvings)


def _median_edge(mesh: MeshArrays) -> float:
    """Of edges round faces, some of them when they are many; 0 where none is finite."""
    ends = np.cumsum(mesh.face_sizes)
    following = np.arange(1, len(mesh.corner_vertices) + 1)
    following[ends - 1] = ends - mesh.face_sizes
    chosen = np.arange(0, len(following), len(following) // MEASURED_EDGES + 1)
    a = mesh.positions[mesh.corner_vertices[chosen]]
    b = mesh.positions[mesh.corner_vertices[following[chosen]]]
    with np.errstate(invalid="ignore", over="ignore"):
        lengths = np.linalg.norm(b - a, axis=1)
    lengths = lengths[np.isfinite(lengths)]
    return float(np.partition(lengths, len(lengths) // 2)[len(lengths) // 2]) if len(lengths) else 0
