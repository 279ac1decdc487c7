"""What a render shows: every mesh at every place, and what it shows that has no surface."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np

from ..settings.styles import Surface, style_of, surface_of
from .alpha.reader import AlphaReader
from .cages import mesh_of, read_cages, trailing_subdivision
from .lightness import LightnessReader
from .mesh_arrays import MeshArrays, read_mesh
from .seen_as import seen_as, with_materials

WITHOUT_SURFACE = {"POINTCLOUD": "point cloud", "VOLUME": "volume", "CURVES": "hair object"}
STRANDS = "object with particle hair"
WITHOUT_FACES = "object without faces"


@dataclass
class Placed:
    """One mesh at one place."""

    name: str
    style: dict[str, Any]  # arguments of ObjectStyle; empty: the scene's
    surface: Surface
    matrix: Any  # (4, 4)
    geometry: MeshArrays  # in its own space


@dataclass
class Shown:
    """All that a render shows of the objects that are to be drawn."""

    placed: list[Placed] = field(default_factory=list)
    left_out: dict[str, list[str]] = field(default_factory=dict)  # names by kind, in words
    lightness: LightnessReader = field(default_factory=LightnessReader)
    alpha: AlphaReader = field(default_factory=AlphaReader)

    def leave_out(self, kind: str, name: str) -> None:
        """Notes what cannot be drawn."""
        self.left_out.setdefault(kind, []).append(name)


_Pending = tuple[tuple[str, dict[str, Any], Surface, Any], Any, MeshArrays | None, list[Any]]
"""What `Placed` has first, the original object, its mesh (None: its cage is to be read), and its
materials."""


def read_shown(scene: Any, depsgraph: Any, is_wanted: Callable[[Any], bool]) -> Shown:
    """Every mesh and instance that a render shows, in the depsgraph's order.

    Curves, surfaces, texts and metaballs come as instances of meshes. is_wanted: asked of original
    objects; False leaves them out, and with them what they instance.
    """
    shown = Shown()
    shown.alpha.is_on = scene.illustrate.cut_by_alpha
    reader = _Reader(depsgraph, shown)
    chosen = cache(lambda owner: (style_of(owner, scene), surface_of(owner, scene)))
    seen = cache(lambda thing, owner: seen_as(thing, owner, depsgraph.view_layer))
    pending: list[_Pending] = []
    instancers: set[str] = set()
    for instance, owner in _rendered(depsgraph):
        style, surface = chosen(owner)
        if style.get("ignore") or not is_wanted(owner):
            continue
        thing = instance.object
        style = {**style, **seen(thing.original, owner)}
        if style.get("ignore"):
            continue
        if thing.type == "MESH" and shown.lightness.is_clear(_materials(thing)):
            style = {**style, "see_through": True}
        if instance.is_instance:
            instancers.add(owner.name)
        for kind in _without_surface(thing, instance.is_instance):
            shown.leave_out(kind, thing.name)
        # A curve, surface, text or metaball comes twice: as itself, and as the mesh that counts.
        if thing.type == "MESH":
            place = (thing.name, style, surface, np.array(instance.matrix_world, float))
            materials = _materials(thing)
            pending += [
                (place, thing.original, mesh, materials) for mesh in reader.read(thing, surface)
            ]
    _place(pending, instancers, shown, scene)
    return shown


def _materials(thing: Any) -> list[Any]:
    """Of an evaluated object or instance."""
    slots = [slot.material for slot in thing.material_slots]
    return slots or list(thing.data.materials)


def _place(pending: list[_Pending], instancers: set[str], shown: Shown, scene: Any) -> None:
    """Adds meshes at their places; those that are still to be read are cages.

    instancers: names of objects whose instances are drawn; nothing is missed of them where their
    own mesh has no faces.
    """
    named = instancers | {name for listed in shown.left_out.values() for name in listed}
    cages = read_cages(
        [original for _, original, mesh, _ in pending if mesh is None], scene, shown.lightness
    )
    for (name, style, surface, matrix), original, mesh, materials in pending:
        style, geometry = with_materials(style, mesh or cages[original], materials)
        if style.get("ignore"):
            continue
        place = (name, style, surface, matrix)
        draws_loose = scene.illustrate.loose_edges or place[1].get("loose_edges", False)
        if len(geometry.face_sizes) or (draws_loose and len(geometry.loose_edges)):
            shown.placed.append(Placed(*place, geometry))
        elif place[0] not in named:
            shown.leave_out(WITHOUT_FACES, place[0])


# --- What is there ------------------------------------------------------------------------------


def _rendered(depsgraph: Any) -> Iterator[tuple[Any, Any]]:
    """Instances of the depsgraph that a render shows too, and the original objects they belong to.

    An instance is valid until the next one is asked for.
    """
    # The depsgraph is the viewport's, in the background too: it lists what a render hides.
    hidden = _hidden_with_collections(depsgraph.view_layer.layer_collection)
    for instance in depsgraph.object_instances:
        owner = (instance.parent if instance.is_instance else instance.object).original
        if not owner.hide_render and owner not in hidden and _is_rendered(instance, owner):
            yield instance, owner


def _is_rendered(instance: Any, owner: Any) -> bool:
    """What is hidden itself is still instanced, but by the collection that it is in."""
    thing = instance.object
    if instance.is_instance:
        is_hidden = owner.instance_type == "COLLECTION" and thing.original.hide_render
        return bool(instance.show_self) and not is_hidden
    if owner.is_instancer or len(owner.particle_systems):
        return bool(owner.show_instancer_for_render)
    return bool(instance.show_self)


def _hidden_with_collections(root: Any) -> set[Any]:
    """Objects whose collections are all hidden from renders. root: a layer collection."""
    shown: set[Any] = set()
    hidden: set[Any] = set()

    def visit(layer: Any, is_hidden: bool) -> None:
        is_hidden = is_hidden or layer.collection.hide_render
        if not layer.exclude:
            (hidden if is_hidden else shown).update(layer.collection.objects)
        for child in layer.children:
            visit(child, is_hidden)

    visit(root, False)
    return hidden - shown


def _without_surface(thing: Any, is_instance: bool) -> Iterator[str]:
    """Kinds of what a render shows of an evaluated object that cannot be drawn."""
    if thing.type in WITHOUT_SURFACE and not _is_empty(thing.data):
        yield WITHOUT_SURFACE[thing.type]
    if not is_instance and any(map(_is_strands, thing.modifiers)):
        yield STRANDS


def _is_empty(data: Any) -> bool:
    """True for hair and point clouds without points; volumes are not looked into."""
    points = getattr(data, "points", None)
    return points is not None and len(points) == 0


def _is_strands(modifier: Any) -> bool:
    if modifier.type != "PARTICLE_SYSTEM" or not modifier.show_render:
        return False
    particles = modifier.particle_system.settings
    return bool(particles.type == "HAIR" and particles.render_type == "PATH")


# --- Meshes -------------------------------------------------------------------------------------


class _Reader:
    """Reads evaluated meshes, each once, at however many places it stands."""

    def __init__(self, depsgraph: Any, shown: Shown) -> None:
        self._depsgraph = depsgraph
        self._shown = shown
        self._read: dict[Any, list[MeshArrays]] = {}

    def read(self, thing: Any, surface: Surface) -> Sequence[MeshArrays | None]:
        """The mesh of an evaluated object or instance; None where its cage is to be read.

        Parts that alpha cuts are a mesh of their own: they are drawn as they are, never as a cage.
        """
        own = thing.original.evaluated_get(self._depsgraph)
        is_own = own.type == "MESH" and own.data == thing.data
        is_cut = self._shown.alpha.cuts(_materials(own if is_own else thing))
        subdivision = trailing_subdivision(thing.original) if is_own else None
        is_smoothed = subdivision is not None and subdivision.subdivision_type == "CATMULL_CLARK"
        if is_smoothed and surface.form != "MESH" and not is_cut:
            return [None]
        is_cage = surface.form == "CAGE" and not is_cut
        key = (thing.original, thing.data.as_pointer(), is_cage)
        if key not in self._read:
            read = _read_evaluated(thing, own if is_own else None, is_cage, self._shown)
            if subdivision is not None and not is_smoothed:
                for each in read:
                    each.scheme = "none"  # the artist wants facets
            self._read[key] = read
        return self._read[key]


def _read_evaluated(thing: Any, own: Any, is_cage: bool, shown: Shown) -> list[MeshArrays]:
    """own: the evaluated object itself where the mesh is its own and not generated."""
    if own is None:
        return _read_mesh(thing.data, thing.name, is_cage, list(thing.data.materials), shown)
    with mesh_of(own) as mesh:
        materials = [slot.material for slot in own.material_slots]
        return _read_mesh(mesh, thing.name, is_cage, materials, shown)


def _read_mesh(
    mesh: Any, name: str, is_cage: bool, materials: list[Any], shown: Shown
) -> list[MeshArrays]:
    arrays = read_mesh(mesh, name, is_cage)
    shown.lightness.read(arrays, mesh, materials)
    if is_cage:
        arrays.boundary = "edges"  # as a Subdivision modifier has it at first
        return [arrays]
    return shown.alpha.cut(arrays, mesh, materials)
