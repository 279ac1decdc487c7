"""Meshes cut along the level of alpha: what an image shows of them, with its outline as boundary.

`cut_by_alpha` is a function of arrays alone. A face that the level crosses is sampled on a lattice
of cells of CELL texels (patches.py, image.py) and marched (march.py). Its points lie linearly, on
quads bilinearly, between the corners, and so do all values of corners. Points on edges are named by
edge and place, so that neighbours share them: nothing cracks, and a face that stays whole becomes a
polygon of more corners where its neighbour has points on their edge. Faces that are wholly there
stay as they are otherwise, and those that are not vanish; so do vertices that no face has left.

Bounds: at most MOST_SAMPLES nodes and MOST_CUT crossed cells in a mesh. Where texels would need
more, cells are 2, 4, 8 .. times as wide.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..mesh_arrays import MeshArrays
from .image import AlphaImage
from .march import Polygons, count_cut, march
from .patches import Edges, Patches, edges_of, halvings_of, lattice_sizes, patches_of
from .welding import Corners, following_of, side_points, spread_edges, welded

CELL = 2  # texels, as wide as the finest blur: crossings are linear in it, and exact to a tenth
MOST_SAMPLES = 2_000_000
MOST_CUT = 150_000
FARTHEST_UV = 1e6  # copies of the image away: beyond there is no telling texels apart
FEW_CELLS = 16  # along a face: the outline is coarse where texels are finer than these
OF_CORNERS = ("uv", "corner_normals", "reflectance")
OF_FACES = ("face_materials", "face_textures", "reflectance")


@dataclass
class Cut:
    """A mesh that has been cut, or the very mesh where nothing was."""

    mesh: MeshArrays
    is_coarse: bool = False  # the bounds made cells so wide that it shows


def cut_by_alpha(mesh: MeshArrays, uv: Any, face_images: Any, images: list[AlphaImage]) -> Cut:
    """Cuts away where images are less opaque than their thresholds.

    uv: (corners, 2) places on the images, v upwards. face_images: (f,) the image of each face,
    -1: it stays. The mesh is no cage. Raises ValueError for arrays of another length and for
    numbers of images that are not there.
    """
    uv, face_images = np.asarray(uv, float), np.asarray(face_images, np.int64)
    _check(mesh, uv, face_images, len(images))
    chosen = (face_images >= 0) & (mesh.face_sizes >= 3)
    if not chosen.any():
        return Cut(mesh)
    uv = np.nan_to_num(uv).clip(-FARTHEST_UV, FARTHEST_UV)
    edges = edges_of(mesh.face_sizes, mesh.corner_vertices, len(mesh.positions))
    patches = patches_of(mesh.face_sizes, mesh.corner_vertices, edges, chosen)
    found = _sample(patches, edges, uv, face_images, images)
    some, every = _told_by_patches(found, patches, len(mesh.face_sizes))
    is_whole = ~chosen | every
    if is_whole.all():
        return Cut(mesh)
    is_cut = some & ~is_whole
    polygons = _march(found, is_cut[patches.faces])
    made = _assembled(mesh, edges, patches, found, polygons, is_whole)
    return Cut(made, bool(found.is_coarse[is_cut[patches.faces]].any()))


def _check(mesh: MeshArrays, uv: Any, face_images: Any, count: int) -> None:
    expected = {"uv": (len(mesh.corner_vertices), 2), "face_images": (len(mesh.face_sizes),)}
    for name, values in (("uv", uv), ("face_images", face_images)):
        if values.shape != expected[name]:
            raise ValueError(f"{name}: expected shape {expected[name]}, not {values.shape}")
    if len(face_images) and not -1 <= face_images.min() <= face_images.max() < count:
        raise ValueError(f"face_images: numbers from -1 to {count - 1}, by the count of images")


# --- Samples ------------------------------------------------------------------------------------


@dataclass
class _Samples:
    """What was sampled of patches."""

    sizes: Any  # (p, 2) cells of each lattice
    groups: list[tuple[Any, Any]]  # patches of one size, and their values (g, m + 1, n + 1)
    is_coarse: Any  # (p,)
    side_hashes: Any  # (p, 4) the same for sides that see the same of an image


def _sample(
    patches: Patches, edges: Edges, uv: Any, face_images: Any, images: list[AlphaImage]
) -> _Samples:
    at, of = patches.at_corners(uv), face_images[patches.faces]
    images = [image.seen_at(at[of == i]) for i, image in enumerate(images)]
    texels = np.array([image.size for image in images])[face_images[edges.faces]]
    lengths = np.linalg.norm((uv[edges.following] - uv) * texels, axis=1) / CELL
    halvings = halvings_of(patches, lengths, edges)
    coarser = 0
    while True:
        sizes = lattice_sizes(patches, halvings, coarser)
        is_least = bool((lattice_sizes(patches, halvings, coarser + 1) == sizes).all())
        if is_least or (sizes + 1).prod(axis=1).sum() <= MOST_SAMPLES:
            groups = list(_groups(sizes, at, of, images, CELL << coarser))
            if is_least or sum(count_cut(values) for _, values in groups) <= MOST_CUT:
                break
        coarser += 1
    finest = lattice_sizes(patches, halvings, 0)
    is_coarse = (finest > sizes).any(axis=1) & (sizes < FEW_CELLS).all(axis=1)
    return _Samples(sizes, groups, is_coarse, _hashes(patches, at, of))


def _groups(sizes: Any, at: Any, of: Any, images: list[AlphaImage], cell: int) -> Any:
    """Patches of one size and image, and values at their nodes; many see the same of it."""
    kinds, numbers = np.unique(np.column_stack([sizes, of]), axis=0, return_inverse=True)
    for number, (m, n, image) in enumerate(kinds.tolist()):
        group = np.flatnonzero(numbers.reshape(-1) == number)
        corners, same = np.unique(at[group].reshape(-1, 8), axis=0, return_inverse=True)
        nodes = _between(
            corners.reshape(-1, 4, 2), *np.ogrid[0 : 1 : (m + 1) * 1j, 0 : 1 : (n + 1) * 1j]
        )
        yield group, images[image].above(nodes, cell)[same.reshape(-1)]


def _between(corners: Any, s: Any, t: Any) -> Any:
    """(p, m, n, k) bilinear between corners (p, 4, k) at all s (m, 1) and t (1, n)."""
    a, b, c, d = (corners[:, i, None, None, :] for i in range(4))
    s, t = s[None, :, :, None], t[None, :, :, None]
    return (a * (1 - s) + b * s) * (1 - t) + (d * (1 - s) + c * s) * t


def _hashes(patches: Patches, at: Any, of: Any) -> Any:
    """(p, 4) of edge, image and UV at its two ends."""
    is_back = (patches.places[:, :, 0] > patches.places[:, :, 1])[..., None]
    here, there = at, np.roll(at, -1, axis=1)
    ends = np.concatenate([np.where(is_back, there, here), np.where(is_back, here, there)], axis=2)
    bits = np.ascontiguousarray(ends + 0.0).view(np.uint64)
    mixed = patches.edges.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    mixed = mixed ^ (of.astype(np.uint64)[:, None] * np.uint64(0xC2B2AE3D27D4EB4F))
    for i in range(4):
        mixed = (mixed ^ bits[..., i]) * np.uint64(0xFF51AFD7ED558CCD)
        mixed ^= mixed >> np.uint64(29)
    return mixed


def _told_by_patches(found: _Samples, patches: Patches, count: int) -> tuple[Any, Any]:
    """(f,) bool: faces with anything inside, and those that are inside everywhere."""
    some, every = np.zeros(count, bool), np.ones(count, bool)
    for group, values in found.groups:
        inside = (values >= 0).reshape(len(group), -1)
        some[patches.faces[group[inside.any(axis=1)]]] = True
        every[patches.faces[group[~inside.all(axis=1)]]] = False
    return some, every


def _march(found: _Samples, is_cut: Any) -> Polygons:
    parts = [
        march(values[is_cut[group]], group[is_cut[group]])
        for group, values in found.groups
        if is_cut[group].any()
    ]
    if not parts:
        none = np.zeros(0, np.int64)
        return Polygons(none, none, none, none, none, none.astype(float))
    names = Polygons.__dataclass_fields__
    return Polygons(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


# --- The mesh -----------------------------------------------------------------------------------


def _assembled(
    mesh: MeshArrays,
    edges: Edges,
    patches: Patches,
    found: _Samples,
    polygons: Polygons,
    is_whole: Any,
) -> MeshArrays:
    """Whole faces as they were and polygons of the others, in the order of the faces."""
    values, names = _corner_values(mesh)
    kept = np.flatnonzero(is_whole[edges.faces])
    whole = _whole_corners(mesh, edges, kept, values)
    parts = _part_corners(patches, found, polygons, values)
    faces = np.concatenate([np.flatnonzero(is_whole), _faces_of(polygons, patches)])
    corners = whole.joined(parts).ordered(np.argsort(faces, kind="stable"))
    faces = np.sort(faces, kind="stable")
    points = welded(corners, len(mesh.positions), mesh.loose_edges)
    made = replace(
        mesh,
        name=mesh.name,
        positions=np.where(
            (points.vertices >= 0)[:, None],
            mesh.positions[points.vertices.clip(0)],
            points.positions,
        ),
        face_sizes=points.corners.sizes.astype(np.int32),
        corner_vertices=points.corner_vertices.astype(np.int32),
        **_edge_values(mesh, edges, points),
    )
    _set_values(made, mesh, faces, points, names)
    return made


def _corner_values(mesh: MeshArrays) -> tuple[Any, dict[str, slice]]:
    """(corners, 3 + k) the places and all values of corners, and where which are."""
    columns, names, at = [mesh.positions[mesh.corner_vertices]], {}, 3
    for name in OF_CORNERS:
        held = getattr(mesh, name)
        if held is None or len(held) != len(mesh.corner_vertices) or _is_of_faces(mesh, name):
            continue
        columns.append(np.asarray(held, float).reshape(len(held), -1))
        names[name] = slice(at, at + columns[-1].shape[1])
        at = names[name].stop
    return np.concatenate(columns, axis=1), names


def _is_of_faces(mesh: MeshArrays, name: str) -> bool:
    held = getattr(mesh, name)
    return name in OF_FACES and held is not None and len(held) == len(mesh.face_sizes)


def _whole_corners(mesh: MeshArrays, edges: Edges, kept: Any, values: Any) -> Corners:
    sizes = np.bincount(edges.faces[kept], minlength=len(mesh.face_sizes))
    start = np.where(edges.is_forward[kept], 0.0, 1.0)
    return Corners(
        sizes[np.unique(edges.faces[kept])],
        mesh.corner_vertices[kept].astype(np.int64),
        values[kept],
        edges.of_corners[kept],
        np.stack([start, 1 - start], axis=1),
    )


def _part_corners(patches: Patches, found: _Samples, polygons: Polygons, values: Any) -> Corners:
    """Corners of polygons: their names, values, and the sides that they run along."""
    keys, x, y = side_points(patches, found.sizes, found.side_hashes, polygons)
    sizes = found.sizes[polygons.patches]
    s, t = x / sizes[:, 0], y / sizes[:, 1]
    between = _at_places(patches.at_corners(values), polygons.patches, s[:, None], t[:, None])
    numbers, places = _runs(patches, polygons, s, t)
    return Corners(polygons.sizes, keys, between, numbers, places)


def _at_places(corners: Any, numbers: Any, s: Any, t: Any) -> Any:
    """(c, k) bilinear between corners (p, 4, k) of numbered patches, at s and t (c, 1)."""
    a, b, c, d = corners.swapaxes(0, 1)
    found = a[numbers]
    for share, slope in ((s, b - a), (t, d - a), (s * t, a - b + c - d)):
        if slope.any():
            found += share * slope[numbers]
    return found


def _runs(patches: Patches, polygons: Polygons, s: Any, t: Any) -> tuple[Any, Any]:
    """(c,) the edge along which a polygon goes on from each corner, -1: none; (c, 2) where."""
    following = following_of(polygons.sizes)
    numbers, places = np.full(len(s), -1), np.zeros((len(s), 2))
    for side, (at, across, rim) in enumerate(((s, t, 0), (t, s, 1), (1 - s, t, 1), (1 - t, s, 0))):
        on = np.flatnonzero((across == rim) & (across[following] == rim))
        begin, end = patches.places[polygons.patches[on], side].T
        numbers[on] = patches.edges[polygons.patches[on], side]
        along = np.stack([at[on], at[following[on]]], axis=1)
        places[on] = begin[:, None] + (end - begin)[:, None] * along
    return numbers, places


def _faces_of(polygons: Polygons, patches: Patches) -> Any:
    """(n,) the face that each polygon is a part of."""
    return patches.faces[polygons.patches[np.cumsum(polygons.sizes) - polygons.sizes]]


def _edge_values(mesh: MeshArrays, edges: Edges, points: Any) -> dict[str, Any]:
    """Creases, marks, loose edges and sharp vertices of the new mesh."""
    creased, rows = spread_edges(mesh.edge_vertices, edges, points)
    marked, _ = spread_edges(mesh.marked_edges, edges, points)
    values = {
        "edge_vertices": creased,
        "edge_sharpness": np.asarray(mesh.edge_sharpness)[rows],
        "marked_edges": marked,
    }
    if mesh.loose_edges is not None:
        values["loose_edges"] = points.numbers[mesh.loose_edges].astype(np.int32)
    if mesh.vertex_sharpness is not None:
        own = np.asarray(mesh.vertex_sharpness)[points.vertices.clip(0)]
        values["vertex_sharpness"] = np.where(points.vertices >= 0, own, 0.0)
    return values


def _set_values(
    made: MeshArrays, mesh: MeshArrays, faces: Any, points: Any, names: dict[str, slice]
) -> None:
    """Sets what corners and faces have."""
    for name, columns in names.items():
        held = getattr(mesh, name)
        found = points.corners.values[:, columns].astype(held.dtype)
        setattr(made, name, found if held.ndim > 1 else found[:, 0])
    for name in OF_FACES:
        if getattr(mesh, name) is not None and _is_of_faces(mesh, name):
            setattr(made, name, np.asarray(getattr(mesh, name))[faces])
