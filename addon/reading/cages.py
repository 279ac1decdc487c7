"""The cages of Subdivision modifiers, with what the modifier says of them."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import bpy
import numpy as np

from .lightness import LightnessReader
from .mesh_arrays import INFINITELY_SHARP, MeshArrays, open_edges, read_mesh

DEFORMING_PARENTS = ("ARMATURE", "LATTICE")
NORMALS_ONLY = ("WEIGHTED_NORMAL", "NORMAL_EDIT")
SMOOTH_BY_ANGLE = "Smooth by Angle"  # the nodes that Blender's Shade Auto Smooth adds, from 4.1


def trailing_subdivision(thing: Any) -> Any:
    """The Subdivision modifier that ends the stack of modifiers in use, or None.

    Those after it that change normals and nothing else do not count.
    """
    used = [m for m in thing.modifiers if m.show_viewport and not _keeps_shape(m)]
    return used[-1] if used and used[-1].type == "SUBSURF" else None


def _keeps_shape(modifier: Any) -> bool:
    nodes = modifier.node_group if modifier.type == "NODES" else None
    is_smoothing = nodes is not None and nodes.name.startswith(SMOOTH_BY_ANGLE)
    return modifier.type in NORMALS_ONLY or is_smoothing


def is_sculpted(thing: Any) -> bool:
    """True where a brush moves the very mesh that is shown: Blender evaluates it no more then."""
    if thing.mode != "SCULPT" or not _keeps_its_mesh(thing):
        return False
    idle = [m for m in thing.modifiers if m.type == "SUBSURF" and m.levels == 0]
    return not any(m.show_viewport and m not in idle for m in thing.modifiers)


@contextmanager
def mesh_of(evaluated: Any) -> Iterator[Any]:
    """The mesh of an evaluated object. In edit mode its `data` may be empty: this one never is.

    Of what is sculpted it is a copy of the original's, with the normals that belong to it.
    """
    sculpted = is_sculpted(evaluated.original)
    thing = evaluated.original if sculpted else evaluated
    try:
        mesh = thing.to_mesh()
        if sculpted:
            mesh.update()  # the brush leaves normals as they were
        yield mesh
    finally:
        thing.to_mesh_clear()


def read_cages(objects: list[Any], scene: Any, lightness: LightnessReader) -> dict[Any, MeshArrays]:
    """The meshes below the last Subdivision of `objects`.

    Where nothing comes before the Subdivision, the cage is the mesh that is edited.
    """
    found = {
        thing: _read_cage(thing, thing.data, lightness) for thing in objects if _is_own_cage(thing)
    }
    others = [thing for thing in dict.fromkeys(objects) if thing not in found]
    return found | _evaluated_cages(others, scene, lightness) if others else found


def _is_own_cage(thing: Any) -> bool:
    """True where nothing changes the object's mesh but its last Subdivision."""
    return (
        sum(modifier.show_viewport for modifier in thing.modifiers) == 1
        and thing.mode != "EDIT"
        and _keeps_its_mesh(thing)
    )


def _keeps_its_mesh(thing: Any) -> bool:
    """True where nothing but modifiers may change the object's mesh."""
    return thing.data.shape_keys is None and thing.parent_type not in DEFORMING_PARENTS


def _evaluated_cages(
    objects: list[Any], scene: Any, lightness: LightnessReader
) -> dict[Any, MeshArrays]:
    """Cages evaluated in a scene of their own.

    The artist's scene is not evaluated again and nothing stays behind, but Blender draws its
    viewports anew.
    """
    stage = bpy.data.scenes.new("illustrate cages")
    copies: dict[Any, Any] = {}
    try:
        # Not `frame_set`, which calls the artist's frame_change handlers.
        stage.frame_current = scene.frame_current
        for thing in objects:
            copies[thing] = copy = thing.copy()
            copy.modifiers.remove(trailing_subdivision(copy))
            copy.hide_viewport = False
            stage.collection.objects.link(copy)
        layer = stage.view_layers[0]
        layer.update()
        _deform_again(list(copies.values()), layer)
        cages = {}
        for thing, copy in copies.items():
            with mesh_of(copy.evaluated_get(layer.depsgraph)) as mesh:
                cages[thing] = _read_cage(thing, mesh, lightness)
        return cages
    finally:
        for copy in copies.values():
            bpy.data.objects.remove(copy)
        bpy.data.batch_remove((stage,))  # `scenes.remove` crashes in a command of 4.3


def _deform_again(copies: list[Any], layer: Any) -> None:
    """Blender deforms by a parent while that is placed: now and then by where it was before."""
    deformed = [copy for copy in copies if copy.parent_type in DEFORMING_PARENTS]
    for copy in deformed:
        copy.update_tag(refresh={"DATA"})
    if deformed:
        layer.update()


def _read_cage(thing: Any, mesh: Any, lightness: LightnessReader) -> MeshArrays:
    """The control mesh of a subdivision surface with the creases its modifier heeds."""
    subdivision = trailing_subdivision(thing)
    geometry = read_mesh(mesh, thing.name, cage=True)
    lightness.read(geometry, mesh, [slot.material for slot in thing.material_slots])
    geometry.scheme = "catmull-clark"
    geometry.boundary = "edges" if subdivision.boundary_smooth == "ALL" else "corners"
    if not subdivision.use_creases:
        geometry.edge_vertices, geometry.edge_sharpness = np.zeros((0, 2), np.int32), np.zeros(0)
        geometry.vertex_sharpness = None
    _keep_seams_sharp(geometry, open_edges(mesh))
    return geometry


def _keep_seams_sharp(cage: MeshArrays, edges: Any) -> None:
    """Creases `edges`, which are open: those that meet are welded before drawing.

    The modifier joins nothing. What it shows is sharp wherever faces only lie against each other.
    """
    cage.edge_vertices = np.concatenate([cage.edge_vertices, edges])
    sharpness = np.full(len(edges), INFINITELY_SHARP)
    cage.edge_sharpness = np.concatenate([cage.edge_sharpness, sharpness])
