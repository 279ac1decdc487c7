"""Strokes of live drawings that are out of sight.

A live drawing is nobody's data. The scene says which of its strokes are hidden, as a text, so that
undo and redo have them; it counts for the drawings that it names, however often they are made.
"""

import json
from typing import Any

import bpy
import numpy as np

from ..running.cache import digest

COMPARED_POINTS = 2000  # by which drawings are told apart


def name_of(drawing: Any) -> str:
    """The same for the same drawing made again."""
    points = np.asarray(drawing.points)
    return digest(np.asarray(drawing.offsets), points[:: len(points) // COMPARED_POINTS + 1])


def hidden_in(scene: Any, drawing: Any) -> list[int]:
    """Numbers of the strokes that are out of sight."""
    told = _told(scene)
    return told.get(name_of(drawing), []) if told else []


def hide_in(scene: Any, name: str, number: int, known: set[str]) -> None:
    """Hides a stroke of the drawing of this name; what is said of unknown ones is forgotten."""
    told = {each: numbers for each, numbers in _told(scene).items() if each in known}
    told.setdefault(name, []).append(number)
    scene.illustrate_hidden_strokes = json.dumps(told)


def _told(scene: Any) -> dict[str, list[int]]:
    text = scene.illustrate_hidden_strokes
    return dict(json.loads(text)) if text else {}


def register() -> None:
    """Gives scenes the text."""
    bpy.types.Scene.illustrate_hidden_strokes = bpy.props.StringProperty(options={"HIDDEN"})


def unregister() -> None:
    """Takes it away."""
    del bpy.types.Scene.illustrate_hidden_strokes
