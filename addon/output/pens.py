"""Materials: one for each pen, for Grease Pencil and for curves.

A pen gets the colour of the scene's settings when it is made and when the setting changes; what the
artist makes of its material meanwhile stays.
"""

from typing import Any

import bpy

from ..ownership import is_ours, mark

PENS = {
    "Line": "line_color",
    "Feature": "feature_color",
    "Hatch": "hatch_color",
    "Hidden": "hidden_color",
}
"""Pens, and the settings that hold their colours."""

PEN = "illustrate_pen"


def of_data(data: Any) -> dict[str, int]:
    """The add-on's pens among the materials of an object's data: their indices."""
    return {
        material[PEN]: index
        for index, material in enumerate(data.materials)
        if material is not None and is_ours(material) and PEN in material
    }


def index_of(data: Any, pen: str, settings: Any, for_pencil: bool) -> int:
    """Index of a pen's material in the data; it is made where it is missing."""
    index = of_data(data).get(pen)
    if index is None:
        data.materials.append(_new(pen, settings, for_pencil))
        index = len(data.materials) - 1
    return index


def _new(pen: str, settings: Any, for_pencil: bool) -> Any:
    material = bpy.data.materials.new(f"Illustration {pen}" + ("" if for_pencil else " Ink"))
    mark(material)
    material[PEN] = pen
    if for_pencil:
        bpy.data.materials.create_gpencil_data(material)
    else:
        material.specular_intensity = 0.0
    colour(material, settings)
    return material


def colour(material: Any, settings: Any) -> None:
    """Gives a pen's material its colour."""
    ink = getattr(settings, PENS[material[PEN]])
    if material.is_grease_pencil:
        material.grease_pencil.color = ink
    else:
        material.diffuse_color = ink


def colour_of(material: Any) -> Any:
    """The colour of a pen's material as it is now."""
    if material.is_grease_pencil:
        return material.grease_pencil.color
    return material.diffuse_color


def colour_all(data: Any, settings: Any) -> None:
    """Gives all pens of an object's data their colours."""
    for index in of_data(data).values():
        colour(data.materials[index], settings)


def remove_unused(materials: list[Any]) -> None:
    """Removes the pens and fills among `materials` that nothing uses."""
    for material in materials:
        if material is not None and is_ours(material) and not material.users:
            bpy.data.materials.remove(material)
