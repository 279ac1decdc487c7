"""Lines, points and triangles over the viewport, with Blender's own shaders of any version.

Only to be called while a viewport is drawn: in the background there is no graphics card.
"""

from collections.abc import Iterable
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

# Blender 4 took the prefix off the names of its shaders.
PREFIX = "" if bpy.app.version >= (4, 0, 0) else "3D_"
NEARER = 4e-3  # of the distance to the eye: lines on a surface are not swallowed by it

_shaders: dict[str, Any] = {}


@dataclass(frozen=True)
class Marks:
    """What is shown in one colour."""

    shape: str  # 'LINES', 'POINTS', 'TRIS'
    points: Any  # (n, 3) float32 world: ends of segments, points, corners of triangles
    colour: tuple[float, float, float, float]
    size: float = 1.5  # px, of lines and points


def draw(marks: Iterable[Marks], region: Any, view_data: Any, in_front: bool = False) -> None:
    """Draws marks into the region, hidden by what is before them unless in_front."""
    with _state(_nearer(view_data.window_matrix), in_front):
        for mark in marks:
            if len(mark.points):
                _draw(mark, region)


@dataclass(frozen=True)
class Rough:
    """Lines of a view that moves."""

    marks: list[Marks]
    hidden: Any  # the colour of those behind surfaces, or None where they are not shown
    hidden_scale: float  # of their width


def draw_rough(rough: Rough, region: Any, view_data: Any) -> None:
    """Draws what is seen of rough lines, and what is hidden of them."""
    draw(rough.marks, region, view_data)
    if rough.hidden is None:
        return
    scale = rough.hidden_scale
    behind = [
        Marks(m.shape, m.points, rough.hidden, m.size * scale) for m in rough.marks if len(m.points)
    ]
    with _state(_nearer(view_data.window_matrix), False):
        gpu.state.depth_test_set("GREATER")
        for mark in behind:
            _draw(mark, region)


def surface_batch(positions: Any, triangles: Any) -> Any:
    """What the graphics card keeps of a surface: (n, 3) world, (t, 3) corners."""
    points = np.ascontiguousarray(positions, np.float32)
    corners = np.ascontiguousarray(triangles, np.int32)
    return batch_for_shader(_shader("UNIFORM_COLOR"), "TRIS", {"pos": points}, indices=corners)


def draw_depth(batch: Any) -> None:
    """Lets a surface hide what is drawn after it, and shows nothing of it."""
    gpu.state.color_mask_set(False, False, False, False)
    gpu.state.depth_mask_set(True)
    gpu.state.depth_test_set("LESS_EQUAL")
    batch.draw(_shader("UNIFORM_COLOR"))
    gpu.state.depth_test_set("NONE")
    gpu.state.color_mask_set(True, True, True, True)


def ribbon_batch(ribbons: Any) -> Any:
    """What the graphics card keeps of `ribbons.Ribbons`; None where there are none."""
    if not len(ribbons.triangles):
        return None
    shader = _shader("SMOOTH_COLOR")
    values = {"pos": ribbons.points, "color": ribbons.colours}
    return batch_for_shader(shader, "TRIS", values, indices=ribbons.triangles)


def draw_ribbons(batch: Any, region: Any) -> None:
    """Draws ribbons over a region, in its own pixels, hidden by what is before their depths."""
    width, height = region.width, region.height
    pixels = Matrix(((2 / width, 0, 0, -1), (0, 2 / height, 0, -1), (0, 0, 1, 0), (0, 0, 0, 1)))
    with _state(pixels, False), gpu.matrix.push_pop():
        gpu.matrix.load_matrix(Matrix.Identity(4))
        batch.draw(_shader("SMOOTH_COLOR"))


def _draw(mark: Marks, region: Any) -> None:
    is_line = mark.shape == "LINES"
    shader = _shader("POLYLINE_UNIFORM_COLOR" if is_line else "UNIFORM_COLOR")
    batch = batch_for_shader(shader, mark.shape, {"pos": mark.points})
    shader.bind()
    shader.uniform_float("color", mark.colour)
    if is_line:
        shader.uniform_float("viewportSize", (region.width, region.height))
        shader.uniform_float("lineWidth", mark.size * bpy.context.preferences.system.ui_scale)
    elif mark.shape == "POINTS":
        gpu.state.point_size_set(mark.size)
    batch.draw(shader)


def _shader(name: str) -> Any:
    if name not in _shaders:
        _shaders[name] = gpu.shader.from_builtin(PREFIX + name)
    return _shaders[name]


@contextmanager
def _state(projection: Any, in_front: bool) -> Any:
    """Blending and depth for what lies on surfaces."""
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("NONE" if in_front else "LESS_EQUAL")
    gpu.state.depth_mask_set(False)
    gpu.matrix.push_projection()
    gpu.matrix.load_projection_matrix(projection)
    try:
        yield
    finally:
        gpu.matrix.pop_projection()
        gpu.state.depth_test_set("NONE")
        gpu.state.depth_mask_set(True)
        gpu.state.blend_set("NONE")


def _nearer(projection: Any) -> Any:
    """The projection with all depths NEARER; for parallel views, by that share of the width."""
    moved = projection.copy()
    if projection[3][3] == 0:
        moved[2][3] *= 1 + NEARER
    else:
        moved[2][3] += NEARER * projection[2][2] / abs(projection[0][0])
    return moved
