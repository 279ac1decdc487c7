"""A Blender mesh as arrays, whatever the version of Blender: faces, creases, shading, marks."""

from dataclasses import dataclass, field, replace
from typing import Any

import bpy
import numpy as np

INFINITELY_SHARP = 10.0

# Normals that agree at every vertex and stand so far off their faces at so many corners are the
# means that a program has made of folds, which nobody has chosen.
FOLD_DEG, FOLD_SHARE = 30.0, 0.05
AGREEING = 0.999  # the length of their mean
BLURRED_CREASE_DEG = 31.0
SMALLEST_FACE = 3  # corners


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
    has none, but for custom ones, and its sharp edges count as creases. Custom ones that blur its
    folds do not count, but that they say smooth: `crease_angle_deg` is the least angle of an edge.
    """
    sizes, edge_corners = _face_sizes(mesh), _edges_of_corners(mesh)
    corners = _held(mesh, ".corner_vert", mesh.loops, "vertex_index", np.int32)
    sharpness, normals, crease_deg = _sharpness(_edge_creases(mesh)), None, 180.0
    if not cage:
        is_smooth, crease_deg = _is_smooth(mesh), 0.0
        normals = _corner_normals(mesh, corners, is_smooth)
        if not is_smooth.any() and _blur_folds(mesh, normals, sizes, corners):
            normals, crease_deg = None, BLURRED_CREASE_DEG
        if not is_smooth.all():
            is_flat = np.repeat(~is_smooth, sizes)
            sharpness[_marks_at(mesh, edge_corners[is_flat])] = INFINITELY_SHARP
    is_creased = sharpness > 0
    creased, marked, loose = _ends_of(
        mesh, is_creased, _freestyle_marks(mesh), _has_faces(mesh, edge_corners, 0)
    )
    return MeshArrays(
        name=name,
        positions=positions_of(mesh).astype(float),
        face_sizes=sizes,
        corner_vertices=corners,
        edge_vertices=creased,
        edge_sharpness=sharpness[is_creased],
        vertex_sharpness=_vertex_sharpness(mesh),
        marked_edges=marked,
        face_materials=_face_materials(mesh),
        cage=cage,
        crease_angle_deg=crease_deg,
        corner_normals=normals,
        loose_edges=loose,
    )


def positions_of(mesh: Any) -> Any:
    """(n, 3) float32 the places of its vertices."""
    return _held(mesh, "position", mesh.vertices, "co", np.float32, 3)


def open_edges(mesh: Any) -> Any:
    """(m, 2) the vertices of edges with one face."""
    return _ends_of(mesh, _has_faces(mesh, _edges_of_corners(mesh), 1))[0]


def _get(collection: Any, name: str, dtype: Any, columns: int = 1) -> Any:
    """A property of all elements: (n,) or (n, columns)."""
    values = np.zeros(len(collection) * columns, dtype)
    collection.foreach_get(name, _as_held(collection, name, values))
    return values if columns == 1 else values.reshape(-1, columns)


def _as_held(collection: Any, name: str, values: Any) -> Any:
    """`values` with the sign that Blender's own integers have: others are copied one by one."""
    if values.dtype != np.int32 or not len(collection):
        return values
    is_unsigned = collection[0].bl_rna.properties[name].subtype == "UNSIGNED"
    return values.view(np.uint32) if is_unsigned else values


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


def _face_sizes(mesh: Any) -> Any:
    """(f,) corners of each face."""
    count = len(mesh.polygons)
    if len(mesh.loops) == SMALLEST_FACE * count:  # no face has fewer
        return np.full(count, SMALLEST_FACE, np.int32)
    return _get(mesh.polygons, "loop_total", np.int32)


def _ends_of(mesh: Any, *chosen: Any) -> list[Any]:
    """(m, 2) the vertices of edges, for each (e,) bool; most meshes have none to be looked up."""
    if not any(each.any() for each in chosen):
        return [np.zeros((0, 2), np.int32) for _ in chosen]
    edges = _held(mesh, ".edge_verts", mesh.edges, "vertices", np.int32, 2)
    return [edges[each] for each in chosen]


def _sharpness(crease: Any) -> Any:
    """OpenSubdiv's sharpness of Blender's creases (0 .. 1), as its Subdivision modifier has it."""
    return (INFINITELY_SHARP * crease.astype(float) ** 2).clip(0, INFINITELY_SHARP)


def _edge_creases(mesh: Any) -> Any:
    if bpy.app.version < (4, 0, 0):
        has_creases = mesh.has_crease_edge
        return _get(mesh.edges, "crease", np.float32) if has_creases else np.zeros(len(mesh.edges))
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
    return _attribute(mesh, "material_index", np.int32, len(mesh.polygons))


def _freestyle_marks(mesh: Any) -> Any:
    """(e,) bool."""
    # The attribute exists before, but is not the mark; from 5.0 on it is, and nothing else.
    if bpy.app.version < (5, 0, 0):
        return _get(mesh.edges, "use_freestyle_mark", bool)
    return _attribute(mesh, "freestyle_edge", bool, len(mesh.edges))


def _has_faces(mesh: Any, edge_corners: Any, count: int) -> Any:
    """(e,) bool: edges of as many faces as `count`."""
    return np.bincount(edge_corners, minlength=len(mesh.edges)) == count


def _edges_of_corners(mesh: Any) -> Any:
    """(corners,) the edge from each corner to the next."""
    return _held(mesh, ".corner_edge", mesh.loops, "edge_index", np.int32)


def _is_smooth(mesh: Any) -> Any:
    """(f,) bool: faces that are not shaded flat."""
    if bpy.app.version < (4, 1, 0):
        return _get(mesh.polygons, "use_smooth", bool)
    return ~_attribute(mesh, "sharp_face", bool, len(mesh.polygons))


def _corner_normals(mesh: Any, corners: Any, is_smooth: Any) -> Any:
    """(corners, 3) normals that the mesh is shaded with; None where all of it is shaded flat.

    They hold whatever makes an edge look hard: flat faces, sharp edges, an angle of auto smooth,
    custom and weighted normals, vertices that an importer has split.
    """
    if not is_smooth.any() and not _has_custom_normals(mesh):
        return None
    if hasattr(mesh, "corner_normals"):  # from 4.1
        return _get(mesh.corner_normals, "vector", np.float32, 3)
    if is_smooth.all() and not mesh.use_auto_smooth:  # nothing makes corners differ
        return np.take(_get(mesh.vertex_normals, "vector", np.float32, 3), corners, axis=0)
    # Before, the normals of loops are zero.
    mesh.calc_normals_split()
    try:
        return _get(mesh.loops, "normal", np.float32, 3)
    finally:
        mesh.free_normals_split()


def _has_custom_normals(mesh: Any) -> bool:
    """Whether normals of its own shade a mesh, flat faces too."""
    return bool(mesh.has_custom_normals and getattr(mesh, "use_auto_smooth", True))


def _blur_folds(mesh: Any, normals: Any, sizes: Any, corners: Any) -> bool:
    if normals is None:
        return False
    sums = np.zeros((len(mesh.vertices), 3))
    np.add.at(sums, corners, normals)
    counts = np.bincount(corners, minlength=len(sums))
    if (np.linalg.norm(sums, axis=1) < AGREEING * counts).any():
        return False
    faces = np.repeat(_get(mesh.polygons, "normal", np.float32, 3), sizes, axis=0)
    is_off = np.einsum("ci,ci->c", faces, normals) < np.cos(np.radians(FOLD_DEG))
    return bool(is_off.mean() > FOLD_SHARE)


def _marks_at(mesh: Any, edges: Any) -> Any:
    """(e,) bool: those of `edges` marked sharp, which normals of flat faces do not tell."""
    is_asked = np.zeros(len(mesh.edges), bool)
    is_asked[edges] = True
    return is_asked & _get(mesh.edges, "use_edge_sharp", bool)
