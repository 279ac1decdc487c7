"""Stamps: what a file says of its making, so that it is known whether another would be the same.

A stamp is a dictionary: "version" of the native module, "settings" (a digest), "frame", "exposure".
SVG, PNG and JSON have a place for it; a .blend gets it at its end, in a form that readers of both
plain and compressed files pass over.
"""

import json
import os
import struct
from typing import Any

import bpy

from .. import native
from ..running.cache import digest

_LOOK = ("resolution_x", "resolution_y", "resolution_percentage", "pixel_aspect_x",
         "pixel_aspect_y", "film_transparent")  # fmt: skip
_NO_LOOK = {"frame_start", "frame_end", "frame_step", "use_scene_range", "keep_frames", "threads",
            "rna_type", "pens", "active_pen"}  # fmt: skip
_SKIPPED = 0x184D2A50  # begins a frame that Zstandard passes over; plain files have ended before it
_TITLE = b"illustrate-stamp "
_MOST = 4096  # bytes of a stamp in a .blend


def stamp_of(
    scene: Any, width_mm: float, svg_style: str, is_plotted: bool = False
) -> dict[str, Any]:
    """What all frames of a scene's drawing have in their stamps; of plots, page and pens too.

    Settings that are animated count as they are now: in a file just opened, as it was saved.
    """
    render = [getattr(scene.render, name) for name in _LOOK]
    owners = [*scene.objects, *scene.collection.children_recursive]
    styles = sorted(
        (type(owner).__name__, owner.name, _values(owner.illustrate))
        for owner in owners
        if owner.illustrate.use_own
    )
    styles += sorted(
        ("Material", material.name_full, _values(material.illustrate_material))
        for material in bpy.data.materials
        if material.illustrate_material.use_own
    )
    told: tuple[Any, ...] = (_values(scene.illustrate), render, styles, float(width_mm), svg_style)
    told += _plot_values(scene.illustrate_plot) if is_plotted else ()
    return {"version": native.load().__version__, "settings": digest(told)}


def _plot_values(chosen: Any) -> tuple[Any, ...]:
    return _values(chosen), [_values(pen) for pen in chosen.pens]


def _values(settings: Any) -> list[tuple[str, str]]:
    """Names and values of a group of properties, as text."""
    names = {prop.identifier for prop in settings.bl_rna.properties} - _NO_LOOK
    return [(name, _text(getattr(settings, name))) for name in sorted(names)]


def _text(value: Any) -> str:
    if isinstance(value, bpy.types.ID):
        return str(value.name_full)
    if isinstance(value, set):
        return repr(sorted(value))
    return repr(value if isinstance(value, str | int | float | None) else tuple(value))


def read_stamp(path: str) -> dict[str, Any]:
    """The stamp of a whole file. Raises ValueError where it has none or is damaged, OSError."""
    extension = os.path.splitext(path)[1]
    if extension == ".blend":
        return _read_end(path)
    with open(path, "rb") as file:
        data = file.read()
    if extension == ".png":
        return dict(native.load_part("png").read_made_by(data))
    if extension in (".pdf", ".dxf"):
        return dict(native.load_part("plot").read_made_by(extension[1:], data))
    if extension == ".svg":
        return dict(native.load_part("svg").read_made_by(data.decode()))
    return dict(native.load_part("drawing_json").from_json(data.decode()).made_by)


def read_if_same(path: str, wanted: dict[str, Any]) -> dict[str, Any] | None:
    """The stamp of a whole file that says all that is wanted, else None."""
    try:
        stamp = read_stamp(path)
    except (OSError, ValueError):
        return None
    return stamp if stamp.items() >= wanted.items() else None


def append_stamp(path: str, stamp: dict[str, Any]) -> None:
    """Adds a stamp to the end of a .blend."""
    told = _TITLE + json.dumps(stamp).encode()
    with open(path, "ab") as file:
        file.write(struct.pack("<II", _SKIPPED, len(told)) + told)


def _read_end(path: str) -> dict[str, Any]:
    with open(path, "rb") as file:
        file.seek(max(os.path.getsize(path) - _MOST, 0))
        head, title, told = file.read().rpartition(_TITLE)
    if head[-8:] != struct.pack("<II", _SKIPPED, len(title + told)):
        raise ValueError("not a whole file that says how it was made")
    return dict(json.loads(told))
