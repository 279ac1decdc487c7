"""Single strokes out of sight: they stay where they are, with nothing to be seen of them."""

from typing import Any

import numpy as np

from . import PENCIL_API, pencil

NEAR = 1e-4  # of the size of a stroke: positions are kept as singles


def points_of(drawing: Any, number: int) -> Any:
    """(n, 3) the points of a stroke of a drawing, in the world."""
    first, end = drawing.offsets[number : number + 2]
    return np.array(drawing.points[first:end], float)


def hide_stroke(scene: Any, points: Any) -> bool:
    """Hides the stroke of the illustration with these points (n, 3); False where there is none.

    The next drawing shows it again.
    """
    found = False
    illustration = pencil.find(scene, PENCIL_API)
    if illustration is None:
        return False
    for layer in PENCIL_API.our_layers(illustration.data).values():
        for frame in _shown(layer, scene.frame_current):
            found |= _hide(frame, np.asarray(points, float))
    illustration.data.update_tag()
    return found


def _shown(layer: Any, number: int) -> list[Any]:
    """The keyframe that is in force at a frame, if there is one."""
    frames = [frame for frame in layer.frames if frame.frame_number <= number]
    return [max(frames, key=lambda frame: int(frame.frame_number))] if frames else []


def _hide(frame: Any, points: Any) -> bool:
    is_new = hasattr(frame, "drawing")
    strokes = frame.drawing.strokes if is_new else frame.strokes
    same = [stroke for stroke in strokes if _is_same(stroke, points)]
    if same and is_new and frame.drawing.attributes.get("opacity") is None:
        # Made by the first value that is set, it would be 0 everywhere.
        opacity = frame.drawing.attributes.new("opacity", "FLOAT", "POINT")
        opacity.data.foreach_set("value", np.ones(len(opacity.data), np.float32))
    for stroke in same:
        for point in stroke.points:
            setattr(point, "opacity" if is_new else "strength", 0.0)
    return bool(same)


def _is_same(stroke: Any, points: Any) -> bool:
    if len(stroke.points) != len(points):
        return False
    size = max(float(np.ptp(points, axis=0).max()), 1e-9)
    ends = [_place(stroke.points[i]) for i in (0, len(points) // 2, -1)]
    wanted = [points[i] for i in (0, len(points) // 2, -1)]
    return bool(np.abs(np.array(ends) - np.array(wanted)).max() <= NEAR * size)


def _place(point: Any) -> Any:
    return tuple(point.position if hasattr(point, "position") else point.co)
