"""What need not be computed again: the last prepared scene and the last drawings.

A digest of the bytes that something was made from decides whether it is still good. A moved camera
takes the prepared surface and field over; other widths take the whole drawing over.
"""

import hashlib
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native
from ..settings import native_options
from ..settings.native_options import WIDTHS

MOST_DRAWINGS = 2
MOST_STRETCH = 4.0  # of widths: strokes are simplified for the width that they were drawn with
OUTLINES = ("SILHOUETTE", "BOUNDARY")
HATCHES = ("HATCH", "CROSS_HATCH", "UNDERCUT")


class Cache:
    """Keeps one prepared scene and a few of its drawings."""

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forgets everything."""
        self._prepared: tuple[str, str, Any] = ("", "", None)
        self._drawings: dict[str, tuple[Any, dict[str, Any]]] = {}

    def has(self, key: str) -> bool:
        """True when `prepared` has it."""
        return self._prepared[0] == key

    def prepared(self, key: str) -> Any:
        """What was prepared for `key`, or None."""
        return self._prepared[2] if self.has(key) else None

    def last_prepared(self, surface_key: str, follows: bool = False) -> Any:
        """What the next may be made from: the last, where it has the same surface; or None.

        follows: the last is of the frame before, and handed on whatever its surface: it may be the
        same in another pose. What cannot be used is forgotten: two would need twice the memory.
        """
        if self._prepared[1] != surface_key and not follows:
            self.clear()
        return self._prepared[2]

    def keep_prepared(self, key: str, surface_key: str, prepared: Any) -> None:
        """Keeps what was prepared, in place of the last."""
        self._prepared = (key, surface_key, prepared)
        self._drawings = {}

    def drawing(self, key: str, widths: dict[str, Any]) -> Any:
        """The drawing for `key`, as wide as `widths` say, or None."""
        drawn, drawn_widths = self._drawings.pop(key, (None, {}))
        if drawn is None or not _can_stretch(drawn_widths, widths):
            return None
        self._drawings[key] = (drawn, drawn_widths)
        return drawn if widths == drawn_widths else RestyledDrawing(drawn, drawn_widths, widths)

    def keep_drawing(self, key: str, widths: dict[str, Any], drawn: Any) -> None:
        """Keeps a drawing, and forgets the one that was looked at longest ago."""
        self._drawings[key] = (drawn, widths)
        for old in list(self._drawings)[:-MOST_DRAWINGS]:
            self._drawings.pop(old, None)


CACHE = Cache()
"""The cache of this Blender."""


class RestyledDrawing:
    """An `illustrate_native.Drawing` with other widths."""

    def __init__(self, drawing: Any, drawn: dict[str, Any], wanted: dict[str, Any]) -> None:
        self.original = self._drawing = drawing
        counts = np.diff(drawing.offsets)
        factors = _stroke_widths(drawing, wanted) / _stroke_widths(drawing, drawn)
        self.widths = (drawing.widths * np.repeat(factors, counts)).astype(np.float32)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._drawing, name)


def _stroke_widths(drawing: Any, widths: dict[str, Any]) -> Any:
    """(s,) width of each stroke before light and tapers."""
    kind = native.load().Kind
    base = np.full(len(drawing.kinds), widths["feature_width_px"], float)
    base[np.isin(drawing.kinds, [int(kind[name]) for name in OUTLINES])] = widths["line_width_px"]
    hatched = np.isin(drawing.kinds, [int(kind[name]) for name in HATCHES])
    base[hatched] = widths["hatch_width_px"]
    base[~hatched & (drawing.invisibility > 0)] *= widths["hidden_width_scale"]
    return base * np.asarray(widths["width_scale"])[drawing.objects]


def _can_stretch(drawn: dict[str, Any], wanted: dict[str, Any]) -> bool:
    pairs = np.array([(_flat(drawn)[i], w) for i, w in enumerate(_flat(wanted))])
    if (pairs <= 0).any():
        return bool((pairs[:, 0] == pairs[:, 1]).all())
    return bool(np.abs(np.log(pairs[:, 1] / pairs[:, 0])).max() <= np.log(MOST_STRETCH))


def _flat(widths: dict[str, Any]) -> list[float]:
    return [*(widths[name] for name in WIDTHS), *widths["width_scale"]]


def split_widths(
    values: dict[str, Any], styles: list[dict[str, Any]]
) -> tuple[dict[str, Any], list[Any]]:
    """Widths of draw options and styles, and all that decides about the drawing besides them."""
    widths = {name: values[name] for name in WIDTHS}
    widths["width_scale"] = [style.get("width_scale", 1.0) for style in styles]
    others = [sorted((k, v) for k, v in values.items() if k not in (*WIDTHS, "threads"))]
    others += [sorted((k, v) for k, v in _full(s).items() if k != "width_scale") for s in styles]
    return widths, others


def _full(style: dict[str, Any]) -> dict[str, Any]:
    return {**native_options.STYLE_DEFAULTS, **style}


def digest(*things: Any) -> str:
    """A name for arrays, numbers, texts, dataclasses and lists and dictionaries of them."""
    state = hashlib.blake2b(digest_size=20)
    for thing in things:
        _feed(state, thing)
    return state.hexdigest()


def _feed(state: Any, thing: Any) -> None:
    if isinstance(thing, np.ndarray):
        state.update(f"{thing.dtype}{thing.shape}".encode())
        state.update(np.ascontiguousarray(thing).data if thing.size else b"")
    elif isinstance(thing, list | tuple):
        state.update(f"list {len(thing)}".encode())
        for part in thing:
            _feed(state, part)
    elif isinstance(thing, dict):
        _feed(state, sorted(thing.items()))
    elif hasattr(thing, "__dataclass_fields__"):
        _feed(state, vars(thing))
    else:
        state.update(f"{type(thing).__name__} {thing!r};".encode())


@persistent
def _before_load(*_: Any) -> None:
    CACHE.clear()


def register() -> None:
    """Forgets what belongs to a file when another is loaded."""
    bpy.app.handlers.load_pre.append(_before_load)


def unregister() -> None:
    """Forgets everything."""
    bpy.app.handlers.load_pre.remove(_before_load)
    CACHE.clear()
