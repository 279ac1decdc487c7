"""A Blender mesh as arrays, whatever the version of Blender: faces, creases, shading, marks."""

import math
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np

INFINITELY_SHARP = 10.0
FLAT_CREASE_ANGLE_DEG = 60.0  # flat-shaded objects: a cube stays a cube, a UV sphere is round


@dataclass
class MeshArrays:
    """Arguments of `illustrate_native.PolygonMesh`, by the same names; world space."""

    name: str
    positions: Any  # (n, 3) float64
    face_sizes: Any  # (f,) int32
    corner_vertices: Any  # (sum of face_sizes,) int32
    edge_vertices: Any  # (e, 2) int32
    edge_sharpness: Any  # (e,) 0 smooth .. 10 infinitely sharp
    vertex_sharpness: Any  # (n,) or None
    marked_edges: Any  # (m, 2) int32
    face_materials: Any  # (f,) int32
    boundary: str = "corners"
    crease_angle_deg: float = 180.0
    scheme: str | None = None
    edge_length: float | None = None


def read_mesh(mesh: Any, name: str, shading: bool) -> MeshArrays:
    """Arrays of a Blender mesh. shading: what is shaded sharp is sharp, besides what is creased."""
    edges = _held(mesh, ".edge_verts", mesh.edges, "vertices", np.int32, 2)
    sharpness = _sharpness(_edge_creases(mesh))
    sizes = _get(mesh.polygons, "loop_total", np.int32)
    arrays = MeshArrays(
        name=name,
        positions=_held(mesh, "position", mesh.vertices, "co", np.float32, 3).astype(float),
        face_sizes=sizes,
        corner_vertices=_held(mesh, ".corner_vert", mesh.loops, "vertex_index", np.int32),
        edge_vertices=edges,
        edge_sharpness=sharpness,
        vertex_sharpness=_vertex_sharpness(mesh),
        marked_edges=edges[_freestyle_marks(mesh)],
        face_materials=_face_materials(mesh),
    )
    if shading:
        arrays.crease_angle_deg, is_sharp = _shading(mesh)
        sharpness[is_sharp] = INFINITELY_SHARP
    creased = sharpness > 0
    arrays.edge_vertices, arrays.edge_sharpness = edges[creased], sharpness[creased]
    return arrays


def _get(collection: Any, name: str, dtype: Any, columns: int = 1) -> Any:
    """A property of all elements: (n,) or (n, columns)."""
    values = np.zeros(len(collection) * columns, dtype)
    collection.foreach_get(name, values)
    return values if columns == 1 else values.reshape(-1, columns)


def _held(mesh: Any, attribute: str, elements: Any, name: str, dtype: Any, columns: int = 1) -> Any:
    """The same, copied at once from the attribute that holds it in newer versions of Blender."""
    held = mesh.attributes.get(attribute)
    if held is None:
        return _get(elements, name, dtype, columns)
    return _get(held.data, "vector" if columns == 3 else "value", dtype, columns)


def _attribute(mesh: Any, name: str, dtype: Any, count: int) -> Any:
    """(count,) values of a mesh attribute; zeros where nothing is set."""
    attribute = mesh.attributes.get(name)
    return np.zeros(count, dtype) if attribute is None else _get(attribute.data, "value", dtype)


def _sharpness(crease: Any) -> Any:
    """OpenSubdiv's sharpness of Blender's creases (0 .. 1), as its Subdivision modifier has it."""
    return (INFINITELY_SHARP * crease.astype(float) ** 2).clip(0, INFINITELY_SHARP)


def _edge_creases(mesh: Any) -> Any:
    if bpy.app.version < (4, 0, 0):
        return _get(mesh.edges, "crease", np.float32)
    return _attribute(mesh, "crease_edge", np.float32, len(mesh.edges))


def _vertex_sharpness(mesh: Any) -> Any:
    """(n,), or None where no vertex is creased."""
    if bpy.app.version < (4, 0, 0):
        layers = mesh.vertex_creases
        creases = _get(layers[0].data, "value", np.float32) if len(layers) else np.zeros(0)
    else:
        creases = _attribute(mesh, "crease_vert", np.float32, len(mesh.vertices))
    return _sharpness(creases) if creases.any() else None


def _face_materials(mesh: Any) -> Any:
    """(f,) index of each face's material."""
    if bpy.app.version < (4, 0, 0):
        return _get(mesh.polygons, "material_index", np.int32)
    return _attribute(mesh, "material_index", np.int32, len(mesh.polygons))


def _freestyle_marks(mesh: Any) -> Any:
    """(e,) bool."""
    if bpy.app.version < (5, 0, 0):
        return _get(mesh.edges, "use_freestyle_mark", bool)
    return _attribute(mesh, "freestyle_edge", bool, len(mesh.edges))


def _shading(mesh: Any) -> tuple[float, Any]:
    """Crease angle in degrees and the edges (e,) bool that are sharp, as the mesh is shaded.

    Smooth faces are sharp at marked edges (and beyond the auto smooth angle), flat ones where they
    turn more than FLAT_CREASE_ANGLE_DEG.
    """
    is_flat = ~_get(mesh.polygons, "use_smooth", bool)
    is_sharp = _get(mesh.edges, "use_edge_sharp", bool)
    if is_flat.all():
        return FLAT_CREASE_ANGLE_DEG, is_sharp
    if is_flat.any():
        is_sharp |= _turns_at_flat_faces(mesh, is_flat)
    if getattr(mesh, "use_auto_smooth", False):  # until 4.0
        return math.degrees(mesh.auto_smooth_angle), is_sharp
    return 180.0, is_sharp


def _turns_at_flat_faces(mesh: Any, is_flat: Any) -> Any:
    """(e,) bool: edges with a flat face that turn more than FLAT_CREASE_ANGLE_DEG."""
    sizes = _get(mesh.polygons, "loop_total", np.int32)
    face = np.repeat(np.arange(len(sizes)), sizes)
    edge = _get(mesh.loops, "edge_index", np.int32)
    face = face[np.argsort(edge, kind="stable")]
    count = np.bincount(edge, minlength=len(mesh.edges))
    first = np.cumsum(count) - count
    pairs = np.flatnonzero(count == 2)
    a, b = face[first[pairs]], face[first[pairs] + 1]
    normals = _get(mesh.polygons, "normal", np.float32, 3)
    turned = (normals[a] * normals[b]).sum(axis=1) < math.cos(math.radians(FLAT_CREASE_ANGLE_DEG))
    is_sharp = np.zeros(len(mesh.edges), bool)
    is_sharp[pairs[turned & (is_flat[a] | is_flat[b])]] = True
    return is_sharp
