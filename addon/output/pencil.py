"""What both versions of Grease Pencil share: the object "Illustration" and its pens."""

from typing import Any

import bpy

from ..ownership import is_ours, mark

NAME = "Illustration"


def find(scene: Any, object_type: str) -> Any:
    """The add-on's Grease Pencil object in the scene, or None."""
    mine = (thing for thing in scene.objects if thing.type == object_type and is_ours(thing))
    return next(mine, None)


def create(scene: Any, data: Any) -> Any:
    """Links a new object with `data` to the scene and marks both as the add-on's own."""
    illustration = bpy.data.objects.new(NAME, data)
    illustration.show_in_front = True  # strokes lie on the surfaces that they draw
    scene.collection.objects.link(illustration)
    mark(illustration, data)
    return illustration


def pen(data: Any, is_hatching: bool) -> int:
    """Index of the material for lines or for hatches; it is made where it is missing."""
    name = "Illustration Hatch" if is_hatching else "Illustration Line"
    for index, material in enumerate(data.materials):
        if material is not None and is_ours(material) and material["illustrate_pen"] == name:
            return index
    material = bpy.data.materials.new(name)
    mark(material)
    material["illustrate_pen"] = name
    bpy.data.materials.create_gpencil_data(material)
    material.grease_pencil.color = (0.0, 0.0, 0.0, 1.0)
    data.materials.append(material)
    return len(data.materials) - 1


def our_pens(data: Any) -> set[int]:
    """Indices of the materials that the add-on made."""
    return {i for i, material in enumerate(data.materials) if material and is_ours(material)}


def remove(illustration: Any, store: Any) -> None:
    """Removes the object with its data and those of its materials that nothing else uses."""
    data = illustration.data
    materials = [material for material in data.materials if material and is_ours(material)]
    bpy.data.objects.remove(illustration)
    if not data.users:
        store.remove(data)
    for material in materials:
        if not material.users:
            bpy.data.materials.remove(material)
