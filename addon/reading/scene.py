"""A Blender scene as arrays: evaluated meshes, camera, lights.

With instances.py, cages.py, mesh_arrays.py, guide_arrays.py, light_arrays.py and styles.py the only
code that reads scene data.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..messages import IllustrateError, quoted, said
from ..ownership import is_ours
from .guide_arrays import GuideArrays, read_guides
from .instances import Placed, read_shown
from .light_arrays import LightArrays, read_light, read_world, strength_problem
from .mesh_arrays import MeshArrays

# Of refined surfaces, where the object is nearest to the camera, in units of paper: pixels of an
# image whose larger side is 1024. The surface, and with it every hatch, is so the same at any
# number of pixels; in images of over 4096 px a unit stays four pixels, as it does for lines.
EDGE_LENGTH = 3.0
UNITS_ACROSS = 1024.0
MOST_PIXELS = 4.0
MEASURED_EDGES = 20_000
LEEWAY = 1.4  # below 2, which would be another level
LONG_SHARE = 0.95  # of the edges are no longer than a long one
NO_COLOUR = (0.6, 0.6, 0.6, 1.0)  # of objects without a material, linear
MOST_HALVINGS = 12  # more than any level of subdivision


@dataclass(frozen=True)
class CameraArrays:
    """Arguments of `illustrate_native.Camera`."""

    projection: Any  # (4, 4) clip from view
    view: Any  # (4, 4) view from world
    width_px: int
    height_px: int

    def pixel_size(self, points: Any) -> Any:
        """World length (p,) of a pixel, upwards as in the core, at the depths of points (p, 3)."""
        row = (self.projection @ self.view)[3]
        w = np.maximum(points @ row[:3] + row[3], self._least_w())
        return 2 * w / (self.projection[1, 1] * self.height_px)

    def unit_size(self, points: Any) -> Any:
        """World length (p,) of a unit of paper across the view at the depths of points (p, 3)."""
        unit = min(max(self.width_px, self.height_px) / UNITS_ACROSS, MOST_PIXELS)
        return unit * self.pixel_size(points)

    def _least_w(self) -> float:
        """Clip w of the near plane."""
        p = self.projection
        return 1.0 if p[3, 2] == 0 else float(p[2, 3] / (p[2, 2] - 1))


@dataclass
class Copy:
    """What an object is a copy of, if others have the same mesh."""

    mesh: MeshArrays  # in its own space, without a name
    matrix: Any  # (4, 4)


@dataclass
class SceneArrays:
    """All that a drawing is made from."""

    camera: CameraArrays
    placed: list[Placed] = field(default_factory=list)  # not put into the world yet
    meshes: list[MeshArrays] = field(default_factory=list)
    copies: list[Copy] = field(default_factory=list)  # of the meshes; empty: none is shared
    styles: list[dict[str, Any]] = field(default_factory=list)  # of the meshes; empty: the scene's
    lights: list[LightArrays] = field(default_factory=list)
    guides: GuideArrays = field(default_factory=GuideArrays)
    left_out: dict[str, list[str]] = field(default_factory=dict)  # by kind: what is not drawn
    partly_read: list[str] = field(default_factory=list)  # materials
    drawn_whole: list[str] = field(default_factory=list)  # materials that nodes cut out
    uncut: dict[str, str] = field(default_factory=dict)  # materials, and why they are not cut out
    coarsely_cut: list[str] = field(default_factory=list)  # objects
    unread_images: dict[str, str] = field(default_factory=dict)  # what is wrong, by name
    unusable_lights: dict[str, str] = field(default_factory=dict)  # the same


def read_scene(
    scene: Any,
    depsgraph: Any,
    selected_only: bool = False,
    use_lights: bool = True,
    guides: Any = None,
    camera: CameraArrays | None = None,
    in_world: bool = True,
) -> SceneArrays:
    """The evaluated scene as the camera's render would show it, meshes in the depsgraph's order.

    A Subdivision modifier that ends an object's stack is taken out: its cage is read, to be
    subdivided to the limit. Any other mesh is the surface itself, unless its style says that it is
    a cage. Left out are objects hidden from viewport or render, illustrations, objects whose style
    says so, and the objects of the collection `guides`, which are read as such. What a render shows
    and a drawing cannot is named in `left_out`. camera: another one than the scene's. Lights are as
    strong as in a render. in_world: False leaves it to the caller to put meshes into the world.
    Raises IllustrateError for a scene without a usable camera or without anything to draw.
    """
    arrays = SceneArrays(camera or read_camera(scene, depsgraph))
    guiding = set(guides.all_objects) if guides is not None else set()

    def is_wanted(thing: Any) -> bool:
        chosen = not selected_only or thing.select_get()
        return chosen and not is_ours(thing) and thing not in guiding

    shown = read_shown(scene, depsgraph, is_wanted)
    arrays.placed = shown.placed
    arrays.styles = [placed.style for placed in shown.placed]
    arrays.left_out = shown.left_out
    arrays.partly_read, arrays.unread_images = shown.lightness.partly, shown.lightness.unread
    arrays.drawn_whole, arrays.uncut = shown.alpha.unfollowed, shown.alpha.uncut
    arrays.coarsely_cut = shown.alpha.coarse
    if not arrays.placed:
        names = [name for listed in shown.left_out.values() for name in listed]
        raise IllustrateError(nothing_to_draw(scene, selected_only, names))
    if guides is not None:
        arrays.guides = read_guides(guides, scene.frame_current)
    if use_lights:
        arrays.lights = read_lights(scene, depsgraph)
        arrays.unusable_lights = unusable_lights(depsgraph)
    if in_world:
        put_into_world(arrays)
    return arrays


def put_into_world(arrays: SceneArrays) -> None:
    """Makes meshes of what was read; needs no Blender, and takes half as long as reading."""
    arrays.meshes = [_in_world(placed, arrays.camera) for placed in arrays.placed]
    arrays.copies = [_as_copy(placed) for placed in arrays.placed]
    arrays.placed = []


def nothing_to_draw(scene: Any, selected_only: bool, without_faces: list[str]) -> str:
    """What is said of a scene without a mesh to draw, and the way out."""
    empty = ""
    if without_faces:
        empty = f" ({said('{names}: no faces', names=quoted(without_faces))})"
    if selected_only:
        return said(
            'No mesh with faces is selected in scene "{scene}"{empty}: '
            "select what is to be drawn, or set Draw to Scene",
            scene=scene.name,
            empty=empty,
        )
    return said(
        'Nothing in scene "{scene}" can be drawn{empty}: add a mesh with '
        "faces, or show one in viewport and render",
        scene=scene.name,
        empty=empty,
    )


def collections_of(scene: Any, name: str) -> tuple[str, ...]:
    """Names of the scene's collections that an object is in, those that these are in too."""
    return tuple(c.name for c in scene.collection.children_recursive if name in c.all_objects)


def colour_of(material: Any) -> tuple[float, ...]:
    """The colour of a material or None, linear: its base colour, or in the viewport."""
    if material is None:
        return NO_COLOUR
    tree = material.node_tree if material.use_nodes else None  # a tree out of use stays there
    for node in tree.nodes if tree else ():
        if node.type == "BSDF_PRINCIPLED" and not node.inputs["Base Color"].is_linked:
            return tuple(node.inputs["Base Color"].default_value)
    return tuple(material.diffuse_color)


# --- Camera -------------------------------------------------------------------------------------


def camera_problem(scene: Any) -> str:
    """Why the scene's camera cannot be drawn from, and the way out; empty when it can."""
    camera = scene.camera
    if camera is None:
        return said(
            'Scene "{scene}" has no camera: add one, or choose one in the scene properties',
            scene=scene.name,
        )
    if camera.type != "CAMERA":
        return said(
            '"{name}", the camera of scene "{scene}", is not a camera: choose one in the scene '
            "properties",
            name=camera.name,
            scene=scene.name,
        )
    # `calc_matrix_camera` would give them an ordinary perspective, without a word.
    if camera.data.type not in ("PERSP", "ORTHO"):
        kinds = {"PANO": said("panoramic")}
        return said(
            'Camera "{name}" is {kind}, which cannot be drawn: set its type to Perspective or '
            "Orthographic",
            name=camera.name,
            kind=kinds.get(camera.data.type, camera.data.type.lower()),
        )
    return ""


def frame_corners(scene: Any) -> Any:
    """(3, 3) the camera frame's top left, top right and bottom left, in the world."""
    camera = scene.camera
    # Blender's order: top right, bottom right, bottom left, top left.
    found = [camera.matrix_world.normalized() @ c for c in camera.data.view_frame(scene=scene)]
    return np.array([found[3], found[0], found[2]])


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
        # Normalized: Blender looks through a scaled camera as if it were not.
        view = evaluated.matrix_world.normalized().inverted()
    except ValueError as error:
        raise IllustrateError(
            said('Camera "{name}" is scaled to nothing: clear its scale', name=camera.name)
        ) from error
    return CameraArrays(np.array(projection, float), np.array(view, float), width, height)


# --- Lights -------------------------------------------------------------------------------------


def read_lights(scene: Any, depsgraph: Any) -> list[LightArrays]:
    """Lights of the render, as strong as its exposure makes them, and the light of the world."""
    lights = read_world(scene.world)
    for lamp, matrix in _lamps(depsgraph):
        lights.append(read_light(lamp.data, matrix))
    for light in lights:
        light.strength *= 2.0**scene.view_settings.exposure
    return [light for light in lights if light.strength > 0 and math.isfinite(light.strength)]


def unusable_lights(depsgraph: Any) -> dict[str, str]:
    """What is wrong with lights that cannot be drawn with, by their names."""
    problems = {lamp.name: strength_problem(lamp.data) for lamp, _ in _lamps(depsgraph)}
    return {name: problem for name, problem in problems.items() if problem}


def _lamps(depsgraph: Any) -> Iterator[tuple[Any, Any]]:
    """Lights of the render with their places; each is valid until the next is asked for."""
    for instance in depsgraph.object_instances:
        lamp = instance.object
        if lamp.type == "LIGHT" and instance.show_self and not lamp.original.hide_render:
            yield lamp, np.array(instance.matrix_world, float)


def _finite(points: Any) -> Any:
    is_finite = np.isfinite(points)
    return points if is_finite.all() else points[is_finite.all(axis=1)]


# --- Meshes -------------------------------------------------------------------------------------


def _in_world(placed: Placed, camera: CameraArrays) -> MeshArrays:
    """A copy at its place, as its style has it, with the edge length its nearness asks for."""
    geometry, linear = placed.geometry, placed.matrix[:3, :3]
    arrays = replace(
        _as_styled(placed),
        name=placed.name,
        positions=geometry.positions @ linear.T + placed.matrix[:3, 3],
    )
    if geometry.corner_normals is not None:
        arrays.corner_normals = geometry.corner_normals @ _of_normals(linear).T
    sizes = camera.unit_size(_finite(arrays.positions))
    if len(sizes):
        arrays.edge_length = _halved(*_usual_edges(arrays), EDGE_LENGTH * float(sizes.min()))
    return arrays


def _as_copy(placed: Placed) -> Copy:
    return Copy(replace(_as_styled(placed), name=""), placed.matrix)


def _as_styled(placed: Placed) -> MeshArrays:
    geometry, surface = placed.geometry, placed.surface
    return replace(
        geometry,
        crease_angle_deg=max(geometry.crease_angle_deg, surface.crease_angle_deg),
        scheme=geometry.scheme or surface.scheme,
    )


def _of_normals(linear: Any) -> Any:
    """(3, 3) float32: what turns normals where `linear` turns points, to the sides of the faces.

    The inverse transpose times the determinant, up to a scale: it is there for flattened objects
    too, and where an object is mirrored, and with it the way round its faces, so are its normals.
    """
    scaled = linear / max(np.abs(linear).max(), np.finfo(float).tiny)
    cofactors = np.stack([np.cross(scaled[i - 2], scaled[i - 1]) for i in range(3)])
    return cofactors.astype(np.float32)


def _halved(edge: float, long_edge: float, longest: float) -> float:
    """What makes subdivision halve `edge` just as often as it must to be at most `longest`.

    It changes only where another level of subdivision does: while the camera moves, it stays the
    same to the last bit. LEEWAY is for edges that mending the mesh makes a little longer. Where
    `edge` is shorter it is doubled, but not beyond `long_edge`: there are none to be halved then.
    """
    if not (edge > 0 and longest > 0):
        return longest
    doublings = math.floor(math.log2(long_edge / edge))
    halvings = min(max(math.ceil(math.log2(edge / longest)), -doublings), MOST_HALVINGS)
    return LEEWAY * math.ldexp(edge, -halvings)


def _usual_edges(mesh: MeshArrays) -> tuple[float, float]:
    """The median of the edges round faces, and one that few exceed; 0 where none is finite.

    Of some of them when they are many.
    """
    ends = np.cumsum(mesh.face_sizes)
    following = np.arange(1, len(mesh.corner_vertices) + 1)
    following[ends - 1] = ends - mesh.face_sizes
    chosen = np.arange(0, len(following), len(following) // MEASURED_EDGES + 1)
    a = mesh.positions[mesh.corner_vertices[chosen]]
    b = mesh.positions[mesh.corner_vertices[following[chosen]]]
    with np.errstate(invalid="ignore", over="ignore"):
        lengths = np.linalg.norm(b - a, axis=1)
    lengths = lengths[np.isfinite(lengths)]
    if not len(lengths):
        return 0.0, 0.0
    places = [len(lengths) // 2, int(LONG_SHARE * (len(lengths) - 1))]
    return tuple(np.partition(lengths, places)[places].tolist())
