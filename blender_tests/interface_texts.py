"""All that the add-on shows: labels and tooltips of operators, panels, menus and properties."""

import ast
import pathlib
from collections.abc import Iterator
from typing import Any

import bpy
import illustrate

GROUPS = ("PropertyGroup", "AddonPreferences")
ON_MANAGER = "illustrate_"
SHOWN_BY_CODE = {"text", "title", "heading"}


def registered() -> Iterator[Any]:
    """The classes of the add-on that Blender knows."""
    for name in dir(bpy.types):
        if name.startswith("ILLUSTRATE_"):
            yield getattr(bpy.types, name)
    for base in (bpy.types.PropertyGroup, bpy.types.AddonPreferences):  # not listed there
        for kind in base.__subclasses__():
            if kind.__name__.startswith("ILLUSTRATE_") and kind.is_registered:
                yield kind


def properties() -> Iterator[tuple[str, Any]]:
    """The settings, with the names of their owners."""
    for kind in registered():
        if any(base.__name__ in (*GROUPS, "Operator") for base in kind.__mro__):
            for prop in kind.bl_rna.properties:
                if prop.identifier not in ("rna_type", "name") and _is_own(kind, prop.identifier):
                    yield kind.__name__, prop
    for prop in bpy.types.WindowManager.bl_rna.properties:
        if prop.identifier.startswith(ON_MANAGER):
            yield "WindowManager", prop


def _is_own(kind: Any, name: str) -> bool:
    return any(name in getattr(base, "__annotations__", {}) for base in kind.__mro__)


def labels() -> Iterator[str]:
    """Texts of code: what `text=` says to a layout, without what has figures in it."""
    folder = pathlib.Path(illustrate.__file__).parent
    for path in folder.rglob("*.py"):
        if "illustrate_native" in path.parts:
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.keyword) and node.arg in SHOWN_BY_CODE:
                value = node.value
                if isinstance(value, ast.Constant) and isinstance(value.value, str):
                    yield value.value


def all_texts() -> set[str]:
    """Every text that Blender would translate."""
    found: set[str] = set(labels())
    for kind in registered():
        if issubclass(kind, bpy.types.Menu) and hasattr(kind, "preset_subdir"):
            continue  # Blender labels the menu after the preset that was chosen last
        found |= {getattr(kind, name, "") for name in ("bl_label", "bl_description")}
    for _, prop in properties():
        if prop.is_hidden:
            continue
        found |= {prop.name, prop.description}
        items = getattr(prop, "enum_items_static", ()) if prop.type == "ENUM" else ()
        found |= {text for item in items for text in (item.name, item.description)}
    return {text for text in found if any(letter.isalpha() for letter in text)}
