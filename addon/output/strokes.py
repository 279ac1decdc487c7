"""The strokes of a drawing as the writers take them: groups, points and radii in the world."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .. import native

OUTLINES = ("Silhouette", "Boundary")  # titles of groups


@dataclass(frozen=True)
class StrokeGroup:
    """The strokes of one layer, one after another."""

    title: str
    pen: str  # a key of pens.PENS; of fills no pen
    points: Any  # (p, 3) float32 world
    radii: Any  # (p,) float32 world, half the width of the stroke
    sizes: Any  # (s,) int32 points of each stroke
    closed: Any  # (s,) bool
    kinds: Any  # (s,) int32 illustrate_native.Kind
    objects: Any  # (s,) int32 index of the mesh
    invisibility: Any  # (s,) int32 layers of surface in front
    ids: Any  # (s,) int32 number through the frames of a sequence; -1: unknown
    starts: Any  # (s,) float32 px along the stroke that its first point counts as
    inks: tuple[tuple[str, tuple[float, ...]], ...] = ()  # (s) of fills: name and linear colour


@dataclass(frozen=True)
class Sheet:
    """What is drawn at one frame."""

    frame: int
    groups: list[StrokeGroup]  # lowest layer first
    names: list[str]  # of the meshes

    def renumbered(self, names: list[str]) -> "Sheet":
        """The same with the objects of its strokes counted in `names`, which gets what it lacks."""
        names.extend(name for name in dict.fromkeys(self.names) if name not in names)
        numbers = np.array([names.index(name) for name in self.names], np.int32)
        groups = [replace(group, objects=numbers[group.objects]) for group in self.groups]
        return Sheet(self.frame, groups, names)


def stroke_groups(drawing: Any, camera: Any) -> list[StrokeGroup]:
    """Groups of a `illustrate_native.Drawing`, lowest layer first, seen by `camera` (CameraArrays).

    A stroke is as wide in the world as its width in pixels looks from the camera.
    """
    points = np.asarray(drawing.points, float).reshape(-1, 3)
    radii = np.asarray(drawing.widths, float) / 2 * camera.pixel_size(points)
    groups = native.load_part("line_groups").line_groups(drawing)
    return [_gather(drawing, group, points, radii) for group in groups]


def _gather(drawing: Any, group: Any, points: Any, radii: Any) -> StrokeGroup:
    chosen, sizes = native.load_part("line_groups").points_of(drawing, group.strokes)

    def of_strokes(values: Any, dtype: Any) -> Any:
        return np.asarray(values)[group.strokes].astype(dtype)

    kinds = of_strokes(drawing.kinds, np.int32)
    return StrokeGroup(
        group.title,
        pen_of(group),
        points[chosen].astype(np.float32),
        radii[chosen].astype(np.float32),
        sizes.astype(np.int32),
        of_strokes(drawing.closed, bool),
        kinds,
        of_strokes(drawing.objects, np.int32),
        of_strokes(drawing.invisibility, np.int32),
        of_strokes(drawing.stroke_ids, np.int32),
        of_strokes(drawing.stroke_starts, np.float32),
    )


def pen_of(group: Any) -> str:
    """The pen that draws a group of lines: a key of pens.PENS."""
    if group.title == native.load_part("line_groups").HIDDEN:
        return "Hidden"
    if group.is_hatching:
        return "Hatch"
    return "Line" if group.title in OUTLINES else "Feature"
