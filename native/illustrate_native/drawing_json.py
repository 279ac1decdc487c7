"""A drawing as JSON, and back: strokes with kind, object, layers in front, points and widths.

Needs numpy only. Numbers are written so that reading gives the same floats again.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .line_groups import KIND_NAMES, DrawingArrays

FORMAT = "illustrate-drawing"
VERSION = 1


@dataclass(frozen=True)
class StoredDrawing:
    """A drawing read from JSON: the arrays of `illustrate_native.Drawing` about its strokes."""

    width_px: int
    height_px: int
    object_names: list[str]
    points: NDArray[np.float64]  # (p, 3) world
    image: NDArray[np.float64]  # (p, 2) px
    widths: NDArray[np.float32]  # (p,) px
    offsets: NDArray[np.int32]  # (s + 1,)
    kinds: NDArray[np.uint8]  # (s,) illustrate_native.Kind
    closed: NDArray[np.bool_]  # (s,)
    objects: NDArray[np.int32]  # (s,)
    invisibility: NDArray[np.int32]  # (s,)
    made_by: dict[str, Any] = field(default_factory=dict)  # as given to `to_json`
    # (s,) as in `illustrate_native.Drawing`; -1 and 0 where the text does not tell.
    stroke_ids: NDArray[np.int32] = field(default_factory=lambda: np.zeros(0, np.int32))
    stroke_starts: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0, np.float64))


def to_json(
    drawing: DrawingArrays,
    width_px: int,
    height_px: int,
    object_names: Sequence[str] = (),
    made_by: Mapping[str, Any] | None = None,
    tracks: bool = False,
) -> str:
    """JSON text of a drawing made for an image of width_px by height_px; one stroke a line.

    object_names: what drawing.objects number, in that order. made_by: what the file is to say of
    its making, of JSON's types. tracks: strokes get "id" and "start", by which they are followed
    through the frames of a sequence.
    Raises ValueError for numbers that are not finite.
    """
    head: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "width_px": int(width_px),
        "height_px": int(height_px),
        "objects": list(object_names),
    }
    if made_by is not None:
        head["made_by"] = dict(made_by)
    strokes = ",\n".join(
        json.dumps(_stroke(drawing, i, tracks), allow_nan=False) for i in range(len(drawing.kinds))
    )
    return f'{json.dumps(head)[:-1]}, "strokes": [\n{strokes}\n]}}\n'


def _stroke(drawing: DrawingArrays, index: int, tracks: bool) -> dict[str, Any]:
    span = slice(int(drawing.offsets[index]), int(drawing.offsets[index + 1]))
    told: dict[str, Any] = {}
    if tracks:
        told["id"] = int(drawing.stroke_ids[index])
        told["start"] = float(drawing.stroke_starts[index])
    return told | {
        "kind": KIND_NAMES[int(drawing.kinds[index])],
        "object": int(drawing.objects[index]),
        "invisibility": int(drawing.invisibility[index]),
        "closed": bool(drawing.closed[index]),
        "image": np.asarray(drawing.image[span], float).tolist(),
        "widths": np.asarray(drawing.widths[span], float).tolist(),
        "points": np.asarray(drawing.points[span], float).tolist(),
    }


def from_json(text: str) -> StoredDrawing:
    """The drawing that `to_json` wrote. Raises ValueError where the text is something else."""
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise ValueError(f"not a drawing: {error}") from error
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise ValueError(f'not a drawing: "format" is not "{FORMAT}"')
    if data.get("version") != VERSION:
        raise ValueError(f"a drawing of version {data.get('version')}, not {VERSION}")
    try:
        return _from_strokes(data, data["strokes"])
    except (KeyError, TypeError) as error:
        raise ValueError(f"a drawing with parts missing: {error}") from error


def _from_strokes(data: dict[str, Any], strokes: list[dict[str, Any]]) -> StoredDrawing:
    def joined(name: str, columns: int) -> NDArray[np.float64]:
        rows = list(chain.from_iterable(s[name] for s in strokes))
        return np.array(rows, float).reshape(len(rows), columns)  # at once: a fifth of the time

    def each(name: str, dtype: type[np.generic]) -> NDArray[Any]:
        return np.array([s[name] for s in strokes], dtype)

    sizes = [len(s["image"]) for s in strokes]
    for i, stroke in enumerate(strokes):
        if {len(stroke["widths"]), len(stroke["points"])} != {sizes[i]}:
            raise ValueError(
                f"stroke {i} has {sizes[i]} image points, {len(stroke['widths'])} "
                f"widths and {len(stroke['points'])} points"
            )
        if stroke["kind"] not in KIND_NAMES:
            raise ValueError(f"stroke {i} is of unknown kind {stroke['kind']!r}")
    return StoredDrawing(
        data["width_px"],
        data["height_px"],
        data["objects"],
        points=joined("points", 3),
        image=joined("image", 2),
        widths=joined("widths", 1).ravel().astype(np.float32),
        offsets=np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32),
        kinds=np.array([KIND_NAMES.index(s["kind"]) for s in strokes], np.uint8),
        closed=each("closed", np.bool_),
        objects=each("object", np.int32),
        invisibility=each("invisibility", np.int32),
        made_by=dict(data.get("made_by", {})),
        stroke_ids=np.array([s.get("id", -1) for s in strokes], np.int32),
        stroke_starts=np.array([s.get("start", 0.0) for s in strokes], np.float64),
    )
