"""Hands on the drawing: a stroke under the mouse, what it is of, and what can be done with it."""

# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native
from ..messages import said
from ..output.hiding import hide_stroke, points_of
from .hidden_strokes import hidden_in, hide_in, name_of
from .inspect import INSPECTOR
from .live import LIVE, WHOLE
from .live_view import VIEW
from .shown import Shown

REACH_PX = 14.0
COLOUR, WIDTH_PX = (1.0, 0.45, 0.0, 1.0), 3.0


@dataclass(frozen=True)
class Picked:
    """A stroke of a drawing."""

    kind: str  # a name of illustrate_native.Kind
    thing: str  # the object's name
    layers: int  # of surface in front
    points: Any  # (n, 3) world
    number: int  # in its drawing
    drawing: str  # its name


def nearest(
    drawing: Any,
    names: list[str],
    matrix: Any,
    size: Any,
    mouse: Any,
    without: Sequence[int] = (),
) -> Picked | None:
    """The stroke nearest to the mouse within REACH_PX, seen ones before hidden ones; or None.

    matrix: (4, 4) clip from world. size, mouse: px of the region, origin bottom left. without:
    numbers of strokes that are out of sight.
    """
    points = np.asarray(drawing.points)
    clip = np.c_[points, np.ones(len(points))] @ np.asarray(matrix, float).T
    is_before = clip[:, 3] > 1e-9
    w = np.where(is_before, clip[:, 3], 1.0)[:, None]
    places = (clip[:, :2] / w + 1) / 2 * np.asarray(size, float)
    offsets = np.asarray(drawing.offsets)
    stroke = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    is_shown = is_before & ~np.isin(stroke, without)
    follows = np.flatnonzero((stroke[1:] == stroke[:-1]) & is_shown[1:] & is_shown[:-1])
    if not len(follows):
        return None
    distance = _distances(places[follows], places[follows + 1], np.asarray(mouse, float))
    is_hidden = np.asarray(drawing.invisibility)[stroke[follows]] > 0
    best = np.argmin(distance + np.where(is_hidden, REACH_PX, 0.0))
    if distance[best] > REACH_PX:
        return None
    number = int(stroke[follows[best]])
    return Picked(
        native.load().Kind(int(drawing.kinds[number])).name,
        names[int(drawing.objects[number])],
        int(drawing.invisibility[number]),
        points_of(drawing, number),
        number,
        name_of(drawing),
    )


def _distances(a: Any, b: Any, mouse: Any) -> Any:
    """(m,) of the mouse from segments a (m, 2) to b (m, 2)."""
    along, to = b - a, mouse - a
    lengths = np.maximum((along**2).sum(axis=1), 1e-12)
    share = np.clip((along * to).sum(axis=1) / lengths, 0, 1)
    return np.linalg.norm(to - share[:, None] * along, axis=1)


class Picker(Shown):
    """The stroke that is picked, and the handler that shows which."""

    def __init__(self) -> None:
        self.picked: Picked | None = None

    def pick(self, picked: Picked | None) -> None:
        """Shows another stroke, or none."""
        self.picked = picked
        self._switch(picked is not None)

    def _draw(self) -> None:
        from . import overlay

        if self.picked is None:
            return
        points = np.asarray(self.picked.points, np.float32)
        ends = np.repeat(points, 2, axis=0)[1:-1]
        marks = [overlay.Marks("LINES", np.ascontiguousarray(ends), COLOUR, WIDTH_PX)]
        overlay.draw(marks, bpy.context.region, bpy.context.region_data, in_front=True)


PICKER = Picker()
"""The picker of this Blender."""


def _drawing_of(context: Any) -> Any:
    """The live drawing of the viewport, else the last illustration; None where there is neither."""
    seen = LIVE.views.get(context.region.as_pointer()) if VIEW.is_on else None
    return seen.drawing_of(WHOLE) if seen is not None else INSPECTOR.made


class ILLUSTRATE_OT_pick(bpy.types.Operator):
    """Picks a stroke."""

    bl_idname = "illustrate.pick"
    bl_label = "Pick Stroke"
    bl_description = "Click a stroke of the drawing to see what it is, and to change it"
    bl_options = {"REGISTER"}

    x: bpy.props.IntProperty(options={"SKIP_SAVE", "HIDDEN"})
    y: bpy.props.IntProperty(options={"SKIP_SAVE", "HIDDEN"})

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a drawing in a 3D viewport."""
        return context.area is not None and context.area.type == "VIEW_3D"

    def invoke(self, context: Any, _event: Any) -> set[str]:
        """Waits for the click."""
        context.window.cursor_modal_set("EYEDROPPER")
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        """Takes the first click; ESC ends."""
        if event.type in {"ESC", "RIGHTMOUSE"}:
            context.window.cursor_modal_restore()
            return {"CANCELLED"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return {"PASS_THROUGH"}
        context.window.cursor_modal_restore()
        region = next(r for r in context.area.regions if r.type == "WINDOW")
        self.x, self.y = event.mouse_x - region.x, event.mouse_y - region.y
        with context.temp_override(region=region):
            return self.execute(bpy.context)

    def execute(self, context: Any) -> set[str]:
        """Picks what is at x, y of the viewport."""
        made, view = _drawing_of(context), context.region_data
        if made is None:
            missing = said("There is no drawing to pick from: press Illustrate or Live")
            self.report({"WARNING"}, missing)
            return {"CANCELLED"}
        size = context.region.width, context.region.height
        matrix = np.array(view.perspective_matrix, float)
        hidden = hidden_in(context.scene, made.drawing)
        PICKER.pick(nearest(made.drawing, made.names, matrix, size, (self.x, self.y), hidden))
        return {"FINISHED"}


class _OfPicked:
    """What is done with the picked stroke."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context: Any) -> bool:
        """A stroke is picked."""
        return PICKER.picked is not None


class ILLUSTRATE_OT_hide_stroke(_OfPicked, bpy.types.Operator):
    """Hides it."""

    bl_idname = "illustrate.hide_stroke"
    bl_label = "Hide Stroke"
    bl_description = "Make the picked stroke invisible until the next drawing is made"

    def execute(self, context: Any) -> set[str]:
        """In the live drawing, and in the illustration where it has the same stroke."""
        picked = PICKER.picked
        assert picked is not None
        live = {name_of(made.drawing) for made in LIVE.wholes()}
        if picked.drawing in live:
            hide_in(context.scene, picked.drawing, picked.number, live)
        if not hide_stroke(context.scene, picked.points) and picked.drawing not in live:
            missing = said("The illustration has no such stroke: press Keep or Illustrate")
            self.report({"ERROR"}, missing)
            return {"CANCELLED"}
        PICKER.pick(None)
        return {"FINISHED"}


class ILLUSTRATE_OT_hide_hatches(_OfPicked, bpy.types.Operator):
    """Takes the hatches of its object away."""

    bl_idname = "illustrate.hide_hatches"
    bl_label = "Hide Hatches"
    bl_description = "Draw the object of the picked stroke without hatches from now on"

    def execute(self, context: Any) -> set[str]:
        """By a style of its own; the illustration is drawn anew where there is no live one."""
        thing = thing_of(context.scene)
        if thing is None:
            self.report({"ERROR"}, said("The object of the stroke is gone: draw anew"))
            return {"CANCELLED"}
        thing.illustrate.use_own, thing.illustrate.hatching = True, False
        if not VIEW.is_on:
            try:
                bpy.ops.illustrate.illustrate()
            except RuntimeError as error:
                self.report({"WARNING"}, str(error))
        PICKER.pick(None)
        return {"FINISHED"}


def thing_of(scene: Any) -> Any:
    """The object of the picked stroke, or None."""
    return scene.objects.get(PICKER.picked.thing) if PICKER.picked is not None else None


@persistent
def _before_load(*_: Any) -> None:
    PICKER.pick(None)


CLASSES = (ILLUSTRATE_OT_pick, ILLUSTRATE_OT_hide_stroke, ILLUSTRATE_OT_hide_hatches)


def register() -> None:
    """Registers the operators."""
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.app.handlers.load_pre.append(_before_load)


def unregister() -> None:
    """Shows nothing any more, and takes the operators away."""
    PICKER.pick(None)
    bpy.app.handlers.load_pre.remove(_before_load)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
