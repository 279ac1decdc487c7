"""The presets that come with the add-on, as a gallery of pictures (examples/thumbnails.py)."""

import pathlib
from typing import Any

import bpy
import bpy.utils.previews

from . import presets

DEFAULT = "Plain"  # what the settings of a new scene draw
SCALE = 5.0  # of the pictures that open, in units of the interface

_pictures: Any = None
_items: list[tuple[str, str, str, int, int]] = []  # kept: Blender keeps no texts of its own
_chosen = [DEFAULT]


def pictures() -> dict[str, pathlib.Path]:
    """The picture of each preset, by the name of its file."""
    found = sorted(pathlib.Path(presets.shipped_folder()).glob("*.png"))
    return {path.stem: path for path in found}


def _listed(_manager: Any, _context: Any) -> list[tuple[str, str, str, int, int]]:
    """The presets with their pictures, which are read when they are first shown."""
    if not _items and _pictures is not None:
        for number, (name, path) in enumerate(pictures().items()):
            icon = _pictures.load(name, str(path), "IMAGE").icon_id
            title = bpy.path.display_name(name)
            _items.append((name, title, f"Draw in the style {title}", icon, number))
    return _items


def _choose(_manager: Any, number: int) -> None:
    name, title = _items[number][:2]
    _chosen[0] = name
    presets.apply(name)
    bpy.ops.ed.undo_push(message=title)


def show(layout: Any, context: Any) -> None:
    """Shows the gallery."""
    layout.template_icon_view(
        context.window_manager, "illustrate_gallery", show_labels=True, scale_popup=SCALE
    )


def register() -> None:
    """Registers the choice."""
    global _pictures
    _pictures = bpy.utils.previews.new()
    bpy.types.WindowManager.illustrate_gallery = bpy.props.EnumProperty(
        name="Style",
        items=_listed,
        description="Set all settings of the drawing to those of a preset",
        get=lambda _manager: list(pictures()).index(_chosen[0]),
        set=_choose,
    )


def unregister() -> None:
    """Takes the choice away, and forgets the pictures."""
    global _pictures
    del bpy.types.WindowManager.illustrate_gallery
    bpy.utils.previews.remove(_pictures)
    _pictures = None
    _items.clear()
