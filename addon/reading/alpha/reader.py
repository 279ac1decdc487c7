"""Cuts the meshes of a scene by the alpha of their materials, each once while nothing changes."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from ...messages import said
from ...running.cache import digest
from ..kept_images import CHANGING, IMAGES
from ..lightness import look_of, mapped_uv, uv_layer
from ..mesh_arrays import MeshArrays
from ..mesh_parts import faces_alone, hanging_together
from ..pictures import read_alpha, read_image
from .cut import cut_by_alpha
from .image import AlphaImage
from .looks import ALPHA, AlphaLook, alpha_look

Parts = tuple[list[MeshArrays], bool]
"""Meshes, and whether they are cut coarsely."""


class KeptCuts:
    """What was cut in this reading of a scene and the one before."""

    def __init__(self) -> None:
        self._before: dict[str, Parts] = {}
        self._now: dict[str, Parts] = {}

    def begin(self) -> None:
        """Another reading begins: what was not asked for in the last one is forgotten."""
        self._before, self._now = self._now, {}

    def of(self, key: str, make: Callable[[], Parts]) -> Parts:
        """What `make` makes of what the key is the digest of, or made before."""
        made = self._now.get(key) or self._before.get(key) or make()
        self._now[key] = made
        return made


WHOLE = AlphaImage([[1.0]])
CUTS = KeptCuts()
"""The cuts of this Blender."""


class AlphaReader:
    """Cuts meshes; notes what is not cut, and what is coarsely."""

    def __init__(self) -> None:
        self.is_on = True
        self.unfollowed: list[str] = []  # names of materials whose nodes are not followed
        self.uncut: dict[str, str] = {}  # why materials are not cut, by their names
        self.coarse: list[str] = []  # names of objects
        self._found: dict[Any, tuple[AlphaLook, AlphaImage] | None] = {}
        CUTS.begin()

    def cuts(self, materials: list[Any]) -> bool:
        """True where any of the materials is cut out."""
        return any(self._of(material) is not None for material in materials)

    def cut(self, arrays: MeshArrays, mesh: Any, materials: list[Any]) -> list[MeshArrays]:
        """What is left of a Blender mesh that was read: parts that are cut, and all others."""
        found = [self._of(material) for material in materials]
        if not any(found) or not len(arrays.face_sizes):
            return [arrays]
        of_faces = np.clip(arrays.face_materials, 0, len(found) - 1)
        uv = np.zeros((len(arrays.corner_vertices), 2))
        images = np.full(len(found), -1)
        for i, each in enumerate(found):
            layer = uv_layer(mesh, each[0].image.uv_map) if each is not None else None
            if layer is not None and each is not None:
                images[i] = i
                chosen = np.repeat(of_faces == i, arrays.face_sizes)
                uv[chosen] = mapped_uv(layer, each[0].image)[chosen]
            elif each is not None:
                problem = said('"{name}" has no UV map', name=arrays.name)
                self.uncut.setdefault(materials[i].name, problem)
        return self._parts(arrays, uv, images[of_faces], [each and each[1] for each in found])

    def _parts(
        self, arrays: MeshArrays, uv: Any, face_images: Any, images: list[Any]
    ) -> list[MeshArrays]:
        keys = [image.key if image is not None else "" for image in images]
        shape = replace(arrays.shape, name="")  # objects may share it
        key = digest(shape, arrays.look, uv, face_images, keys)
        parts, is_coarse = CUTS.of(key, lambda: cut_parts(arrays, uv, face_images, images))
        if is_coarse and arrays.name not in self.coarse:
            self.coarse.append(arrays.name)
        return [replace(part, name=arrays.name) for part in parts]

    def _of(self, material: Any) -> tuple[AlphaLook, AlphaImage] | None:
        if not self.is_on or material is None:
            return None
        if material not in self._found:
            self._found[material] = self._read(material) if look_of(material).is_cut_out else None
        return self._found[material]

    def _read(self, material: Any) -> tuple[AlphaLook, AlphaImage] | None:
        look = alpha_look(material)
        if look is None:
            self.unfollowed.append(material.name)
            return None
        image = look.image.image
        try:
            return look, IMAGES.of(image, repr((look, "alpha")), lambda: _image_of(look))
        except ValueError as error:
            told = said('image "{name}": {problem}', name=image.name, problem=error)
            self.uncut[material.name] = told
            return None


def _image_of(look: AlphaLook) -> AlphaImage:
    image = look.image.image
    if image.source == "TILED" or image.source in CHANGING:
        raise ValueError(said("tiles, sequences and movies are not read, give it a single image"))
    values = read_alpha(image) if look.channel == ALPHA else read_image(image)
    if look.is_below:
        return AlphaImage(1 - values, look.image.wrap, 1 - look.threshold)
    return AlphaImage(values, look.image.wrap, look.threshold)


def cut_parts(mesh: MeshArrays, uv: Any, face_images: Any, images: list[Any]) -> Parts:
    """What hangs together with faces that are cut as a mesh of its own, drawn as it is.

    The rest stays what it was, such as the trunk of a tree: a smooth surface.
    """
    touched = hanging_together(mesh, face_images >= 0)
    if not touched.any():
        return [mesh], False
    part = mesh if touched.all() else faces_alone(mesh, touched, with_loose=False)
    chosen = np.repeat(touched, mesh.face_sizes)
    used = [image or WHOLE for image in images]
    cut = cut_by_alpha(part, uv[chosen], face_images[touched], used)
    if cut.mesh is part:
        return [mesh], False
    rest = [] if part is mesh else [faces_alone(mesh, ~touched, with_loose=True)]
    parts = [replace(cut.mesh, scheme="none"), *rest]
    return [each for each in parts if len(each.face_sizes) or len(each.loose_edges)], cut.is_coarse
