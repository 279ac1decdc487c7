"""Parts of meshes: faces by themselves, with all that they have."""

from dataclasses import replace
from typing import Any

import numpy as np

from .mesh_arrays import MeshArrays

PAIRS = ("edge_vertices", "marked_edges")


def hanging_together(mesh: MeshArrays, faces: Any) -> Any:
    """(f,) bool: faces (f,) bool, and all that hang together with them by vertices."""
    of_corners = np.repeat(np.arange(len(faces)), mesh.face_sizes)
    chosen, before = faces.copy(), -1
    reached = np.zeros(len(mesh.positions), bool)
    while before != (before := int(chosen.sum())):
        reached[mesh.corner_vertices[chosen[of_corners]]] = True
        chosen[of_corners[reached[mesh.corner_vertices]]] = True
    return chosen


def faces_alone(mesh: MeshArrays, faces: Any, with_loose: bool) -> MeshArrays:
    """The faces (f,) bool with their vertices and edges. with_loose: and all loose edges."""
    of_corners = np.repeat(faces, mesh.face_sizes)
    is_kept = np.zeros(len(mesh.positions), bool)
    is_kept[mesh.corner_vertices[of_corners]] = True
    loose = np.zeros((0, 2), np.int32)
    if with_loose and mesh.loose_edges is not None:
        loose = mesh.loose_edges
        is_kept[loose.reshape(-1)] = True
    numbers = (np.cumsum(is_kept) - 1).astype(np.int32)
    part = replace(
        mesh,
        positions=mesh.positions[is_kept],
        face_sizes=mesh.face_sizes[faces],
        corner_vertices=numbers[mesh.corner_vertices[of_corners]],
        face_materials=mesh.face_materials[faces],
        loose_edges=numbers[loose],
    )
    _keep_edges(part, mesh, is_kept, numbers)
    _keep_values(part, mesh, faces, of_corners)
    return part


def _keep_edges(part: MeshArrays, mesh: MeshArrays, is_kept: Any, numbers: Any) -> None:
    for name in PAIRS:
        pairs = getattr(mesh, name)
        chosen = is_kept[pairs].all(axis=1)
        setattr(part, name, numbers[pairs[chosen]])
        if name == "edge_vertices":
            part.edge_sharpness = mesh.edge_sharpness[chosen]
    if mesh.vertex_sharpness is not None:
        part.vertex_sharpness = mesh.vertex_sharpness[is_kept]


def _keep_values(part: MeshArrays, mesh: MeshArrays, faces: Any, of_corners: Any) -> None:
    if mesh.corner_normals is not None:
        part.corner_normals = mesh.corner_normals[of_corners]
    if mesh.uv is not None and mesh.face_textures is not None:
        part.uv, part.face_textures = mesh.uv[of_corners], mesh.face_textures[faces]
    if mesh.reflectance is not None:
        is_of_faces = len(mesh.reflectance) == len(faces)
        part.reflectance = mesh.reflectance[faces if is_of_faces else of_corners]
