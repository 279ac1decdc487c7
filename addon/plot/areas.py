"""What is seen of each object and material, as areas in the colours of the materials."""

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .. import native
from ..messages import IllustrateError, said
from ..output.png import hex_of
from ..reading.scene import colour_of


@dataclass(frozen=True)
class Area:
    """A region and what it is filled with."""

    region: Any  # illustrate_native.plot.Region, px, with name and colour
    ink: str  # name of the material, or of the object where it has none
    colour: tuple[float, ...]  # linear


@contextmanager
def _explained() -> Iterator[None]:
    try:
        yield
    except native.load_part("plot").PlotError as error:
        raise IllustrateError(said("Nothing is filled: {error}", error=error)) from error


def check_fills(scene: Any) -> None:
    """Raises IllustrateError where the settings ask for fills that cannot be made."""
    if _fills(scene):
        check_areas()


def check_areas() -> None:
    """Raises IllustrateError where no areas can be found."""
    with _explained():
        native.load_part("plot").check_regions()


def fills_of(scene: Any, made: Any) -> list[Area]:
    """The areas that are to be filled below the strokes in the scene: none, or all."""
    return areas_of(scene, made) if _fills(scene) else []


def _fills(scene: Any) -> bool:
    return bool(scene.illustrate.fill_regions and scene.illustrate.output == "GREASE_PENCIL")


def areas_of(scene: Any, made: Any) -> list[Area]:
    """Areas of an Illustration of the scene. Raises IllustrateError without shapely."""
    if made.regions is None:
        with _explained():
            made.regions = _regions(scene, made)
    counts = Counter(region.object for region in made.regions)
    return [_area(scene, made, region, counts[region.object] > 1) for region in made.regions]


def _regions(scene: Any, made: Any) -> list[Any]:
    """Regions of what hides something and is drawn."""
    plot, camera = native.load_part("plot"), made.arrays.camera
    size = camera.width_px, camera.height_px
    styles = made.arrays.styles or [{} for _ in made.names]
    clear = [i for i, style in enumerate(styles) if style.get("see_through")]
    painted = _slots_of_triangles(scene, made)
    surface = made.prepared.surface
    seen = plot.seen_from(surface, camera.projection, camera.view, *size, painted, clear)
    found = plot.regions_of(made.drawing.graph, seen, *size)
    return [region for region in found if not styles[region.object].get("occlude_only")]


def _area(scene: Any, made: Any, region: Any, is_one_of_several: bool) -> Area:
    name = made.names[region.object]
    material = _material(scene, name, region.material)
    colour = colour_of(material)
    ink = material.name if material is not None else name
    title = f"{name} {ink}" if is_one_of_several and material is not None else name
    return Area(replace(region, name=title, colour=hex_of(colour)), ink, colour)


def materials_of_strokes(scene: Any, made: Any) -> Any:
    """(s,) the name of the material that most of each stroke's points lie on; '' for none."""
    drawing = made.drawing
    triangles = np.asarray(drawing.triangles)
    slots = _slots_of_triangles(scene, made)
    at = np.where(triangles < 0, 0, slots[triangles])
    owners = np.repeat(np.arange(len(drawing.kinds)), np.diff(np.asarray(drawing.offsets)))
    pairs, counts = np.unique(np.c_[owners, at], axis=0, return_counts=True)
    order = np.lexsort((-pairs[:, 1], counts))  # of as many points, that of the first slot
    slot = np.zeros(len(drawing.kinds), np.intp)
    slot[pairs[order, 0]] = pairs[order, 1]
    found, which = np.unique(np.c_[drawing.objects, slot], axis=0, return_inverse=True)
    names = [_name(scene, made, thing, number) for thing, number in found.tolist()]
    return np.array([*names, ""], dtype=np.str_)[which.ravel()]


def _name(scene: Any, made: Any, thing: int, slot: int) -> str:
    material = _material(scene, made.names[thing], slot) if thing >= 0 else None
    return material.name if material is not None else ""


def _slots_of_triangles(scene: Any, made: Any) -> Any:
    """(t,) the first slot of each triangle's object that has the triangle's material."""
    surface, meshes = made.prepared.surface, made.arrays.meshes
    slots = [_first_slots(scene, mesh) for mesh in meshes]
    starts = np.cumsum([0, *map(len, slots)])
    objects = np.asarray(surface.objects)[np.asarray(surface.triangles)[:, 0]]
    faces = np.maximum(np.asarray(surface.triangle_faces), 0)
    return np.concatenate([*slots, np.zeros(1, np.intp)])[starts[objects] + faces]


def _first_slots(scene: Any, mesh: Any) -> Any:
    """(f,) of each face."""
    materials = _materials(scene, mesh.name)
    first = [materials.index(material) for material in materials] or [0]
    chosen = np.asarray(mesh.face_materials, np.intp).clip(0, len(first) - 1)
    return np.array(first, np.intp)[chosen]


def _material(scene: Any, name: str, slot: int) -> Any:
    materials = _materials(scene, name)
    return materials[slot] if slot < len(materials) else None


def _materials(scene: Any, name: str) -> list[Any]:
    """The materials of an object's slots."""
    thing = scene.objects.get(name)
    return [slot.material for slot in thing.material_slots] if thing is not None else []
