"""A Blender mesh as arrays, whatever the version of Blender: faces, creases, shading, marks."""

from dataclasses import dataclass, field, replace
from typing import Any

import bpy
import numpy as np

INFINITELY_SHARP = 10.0


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
    corner_normals: Any = None  # (sum of face_sizes, 3) float32 of any length, or None
    cage: bool = True
    loose_edges: Any = None  # (l, 2) int32, of no face
    hole_faces: Any = None  # (h,) int32 faces that shape the surface and are not there, or None
    reflectance: Any = None  # (f,) or (sum of face_sizes,), or None: white
    uv: Any = None  # (sum of face_sizes, 2), or None
    textures: list[Any] = field(default_factory=list)  # TextureArrays
    face_textures: Any = None  # (f,) int32, -1: none; or None

    @property
    def shape(self) -> "MeshArrays":
        """Without what shapes nothing."""
        return replace(self, reflectance=None, uv=None, textures=[], face_textures=None)

    @property
    def look(self) -> tuple[Any, ...]:
        """What shapes nothing, textures by their names."""
        keys = [texture.key for texture in self.textures]
        return self.reflectance, self.uv, keys, self.face_textures


def read_mesh(mesh: Any, name: str, cage: bool) -> MeshArrays:
    """Arrays of a Blender mesh, sharp where its edges and vertices are creased.

    cage: it stands for the smooth surface that it controls, however it is shaded. Else it is the
    surface itself, with the normals that it is shaded with; a mesh that is shaded flat all over
    has none, and its sharp edges count as creases.
    """
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
        cage=cage,
        loose_edges=edges[_is_loose(mesh)],
    )
    if not cage:
        arrays.corner_normals = _corner_normals(mesh)
        sharpness[_marks_at_flat_faces(mesh)] = INFINITELY_SHARP
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
    # The attribute exists before, but is not the mark; from 5.0 on it is, and nothing else.
    if bpy.app.version < (5, 0, 0):
        return _get(mesh.edges, "use_freestyle_mark", bool)
    return _attribute(mesh, "freestyle_edge", bool, len(mesh.edges))


def _is_loose(mesh: Any) -> Any:
    """(e,) bool: edges of no face."""
    loose = np.ones(len(mesh.edges), bool)
    loose[_edges_of_corners(mesh)] = False
    return loose


def _edges_of_corners(mesh: Any) -> Any:
    """(corners,) the edge from each corner to the next."""
    return _held(mesh, ".corner_edge", mesh.loops, "edge_index", np.int32)


def _corner_normals(mesh: Any) -> Any:
    """(corners, 3) normals that the mesh is shaded with; None where all of it is shaded flat.

    They hold whatever makes an edge look hard: flat faces, sharp edges, an angle of auto smooth,
    custom and weighted normals, vertices that an importer has split.
    """
    if not _get(mesh.polygons, "use_smooth", bool).any():
        return None
    if hasattr(mesh, "corner_normals"):  # from 4.1
        return _get(mesh.corner_normals, "vector", np.float32, 3)
    # Before, the normals of loops are zero.
    mesh.calc_normals_split()
    try:
        return _get(mesh.loops, "normal", np.float32, 3)
    finally:
        mesh.free_normals_split()


def _marks_at_flat_faces(mesh: Any) -> Any:
    """(e,) bool: edges marked sharp where a face is shaded flat, which normals do not tell."""
    is_flat = ~_get(mesh.polygons, "use_smooth", bool)
    sizes = _get(mesh.polygons, "loop_total", np.int32)
    edges = _edges_of_corners(mesh)
    at_flat = np.zeros(len(mesh.edges), bool)
    at_flat[edges[np.repeat(is_flat, sizes)]] = True
    return at_flat & _get(mesh.edges, "use_edge_sharp", bool)
