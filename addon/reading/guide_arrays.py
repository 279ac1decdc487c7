"""Guides of the hatching as arrays: curves, Grease Pencil of whatever version, and empties."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import bpy
import numpy as np

from ..ownership import is_ours


@dataclass
class GuideArrays:
    """What the field of directions is to follow; world space."""

    strokes: list[Any] = field(default_factory=list)  # (k, 3) polylines
    weights: list[float] = field(default_factory=list)  # of the strokes, shares of the scene's
    turn_places: list[Any] = field(default_factory=list)  # (3,) where hatches turn round a point
    turns: list[int] = field(default_factory=list)  # right angles

    def __bool__(self) -> bool:
        return bool(self.strokes or self.turns)


def read_guides(collection: Any, frame: int) -> GuideArrays:
    """Strokes of all curve and Grease Pencil objects of a collection, and its empties.

    Those of its child collections count, hidden objects too; closed strokes end where they began.
    frame: that of the Grease Pencil drawings.
    """
    readers = {
        "CURVE": _splines,
        "CURVES": _hair,
        "GPENCIL": _strokes_v2,
        "GREASEPENCIL": _strokes_v3,
    }
    guides = GuideArrays()
    for thing in list(collection.all_objects):  # reading curves makes and removes objects
        matrix, said = np.array(thing.matrix_world, float), thing.illustrate_guide
        if thing.type == "EMPTY" and said.turns:
            guides.turn_places.append(matrix[:3, 3])
            guides.turns.append(said.turns)
        if thing.type not in readers or is_ours(thing):
            continue
        for points in readers[thing.type](thing, frame):
            if len(points) > 1:
                guides.strokes.append(points @ matrix[:3, :3].T + matrix[:3, 3])
                guides.weights.append(said.weight)
    return guides


def _splines(thing: Any, _frame: int) -> Iterator[Any]:
    """Splines of a curve object as they run, without thickness."""
    data = thing.data.copy()
    data.bevel_depth = data.extrude = data.offset = 0.0
    data.bevel_object = data.taper_object = None
    bare = bpy.data.objects.new("illustrate guide", data)
    try:
        mesh = bare.to_mesh()
        points = np.zeros(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", points)
        edges = np.zeros(2 * len(mesh.edges), np.int32)
        mesh.edges.foreach_get("vertices", edges)
    finally:
        bare.to_mesh_clear()
        bpy.data.objects.remove(bare)
        bpy.data.curves.remove(data)
    yield from _chains(points.reshape(-1, 3).astype(float), edges.reshape(-1, 2))


def _chains(points: Any, edges: Any) -> Iterator[Any]:
    """Polylines of edges that follow each other; the last of a closed one leads to its first."""
    following = {min(edge): max(edge) for edge in edges.tolist() if abs(edge[0] - edge[1]) == 1}
    closing = {max(edge): min(edge) for edge in edges.tolist() if abs(edge[0] - edge[1]) > 1}
    starts = sorted(set(following) - set(following.values()))
    for start in starts:
        chain = [start]
        while chain[-1] in following:
            chain.append(following[chain[-1]])
        if closing.get(chain[-1]) == start:
            chain.append(start)
        yield points[chain]


def _hair(thing: Any, _frame: int) -> Iterator[Any]:
    positions = thing.data.attributes["position"].data
    flat = np.zeros(3 * len(positions), np.float32)
    positions.foreach_get("vector", flat)
    points = flat.reshape(-1, 3).astype(float)
    for curve in thing.data.curves:
        yield points[curve.first_point_index : curve.first_point_index + curve.points_length]


def _strokes_v2(thing: Any, frame: int) -> Iterator[Any]:
    for layer in thing.data.layers:
        past = [drawn for drawn in layer.frames if drawn.frame_number <= frame]
        if layer.hide or not past:
            continue
        matrix = np.array(layer.matrix_layer, float)
        for stroke in max(past, key=lambda drawn: int(drawn.frame_number)).strokes:
            flat = np.zeros(3 * len(stroke.points), np.float32)
            stroke.points.foreach_get("co", flat)
            points = flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
            yield _closed(points, stroke.use_cyclic)


def _strokes_v3(thing: Any, frame: int) -> Iterator[Any]:
    for layer in thing.data.layers:
        drawn = None if layer.hide else layer.get_frame_at(frame)
        if drawn is None:
            continue
        matrix = np.array(layer.matrix_local, float)
        for stroke in drawn.drawing.strokes:
            points = np.array([point.position for point in stroke.points], float).reshape(-1, 3)
            yield _closed(points @ matrix[:3, :3].T + matrix[:3, 3], stroke.cyclic)


def _closed(points: Any, is_closed: bool) -> Any:
    return np.concatenate([points, points[:1]]) if is_closed and len(points) > 2 else points
