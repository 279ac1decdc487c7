"""Hands on the drawing: a stroke under the mouse, what it is of, and what can be done with it."""

# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native
from ..messages import IllustrateError
from ..output.hiding import hide_stroke
from .inspect import INSPECTOR
from .live import LIVE, WHOLE
from .live_view import VIEW
from .shown import Shown

REACH_PX = 14.0
NEAR_EDGES = 6.0  # of triangles, within which singularities count as one
COLOUR, WIDTH_PX = (1.0, 0.45, 0.0, 1.0), 3.0


@dataclass(frozen=True)
class Picked:
    """A stroke of a drawing."""

    kind: str  # a name of illustrate_native.Kind
    thing: str  # the object's name
    layers: int  # of surface in front
    points: Any  # (n, 3) world


def nearest(drawing: Any, names: list[str], matrix: Any, size: Any, mouse: Any) -> Picked | None:
    """The stroke nearest to the mouse within REACH_PX, seen ones before hidden ones; or None.

    matrix: (4, 4) clip from world. size, mouse: px of the region, origin bottom left.
    """
    points = np.asarray(drawing.points)
    clip = np.c_[points, np.ones(len(points))] @ np.asarray(matrix, float).T
    is_before = clip[:, 3] > 1e-9
    w = np.where(is_before, clip[:, 3], 1.0)[:, None]
    places = (clip[:, :2] / w + 1) / 2 * np.asarray(size, float)
    offsets = np.asarray(drawing.offsets)
    stroke = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    follows = np.flatnonzero((stroke[1:] == stroke[:-1]) & is_before[1:] & is_before[:-1])
    if not len(follows):
        return None
    distance = _distances(places[follows], places[follows + 1], np.asarray(mouse, float))
    is_hidden = np.asarray(drawing.invisibility)[stroke[follows]] > 0
    best = np.argmin(distance + np.where(is_hidden, REACH_PX, 0.0))
    if distance[best] > REACH_PX:
        return None
    number = stroke[follows[best]]
    return Picked(
        native.load().Kind(int(drawing.kinds[number])).name,
        names[int(drawing.objects[number])],
        int(drawing.invisibility[number]),
        points[offsets[number] : offsets[number + 1]].copy(),
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
            self.report({"WARNING"}, "There is no drawing to pick from: press Illustrate or Live")
            return {"CANCELLED"}
        size = context.region.width, context.region.height
        matrix = np.array(view.perspective_matrix, float)
        PICKER.pick(nearest(made.drawing, made.names, matrix, size, (self.x, self.y)))
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
        """In the illustration."""
        assert PICKER.picked is not None
        if not hide_stroke(context.scene, PICKER.picked.points):
            self.report({"ERROR"}, "The illustration has no such stroke: press Keep or Illustrate")
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
            self.report({"ERROR"}, "The object of the stroke is gone: draw anew")
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


def joined(places: Any, turns: Any, near: float) -> tuple[Any, Any]:
    """Singularities (n, 3), (n,) with those nearer than `near` as one; what cancels out is gone.

    The field cannot keep apart what lies within few triangles; on each part the sum stays.
    """
    places, turns = np.array(places, float), np.array(turns)
    while len(turns) > 1:
        apart = np.linalg.norm(places[:, None] - places[None], axis=2)
        np.fill_diagonal(apart, np.inf)
        i, j = np.unravel_index(np.argmin(apart), apart.shape)
        if apart[i, j] >= near:
            break
        kept = i if abs(turns[i]) >= abs(turns[j]) else j
        gone = j if kept == i else i
        turns[kept] += turns[gone]
        wanted = np.arange(len(turns)) != gone
        if turns[kept] == 0:
            wanted[kept] = False
        places, turns = places[wanted], turns[wanted]
    return places, turns


def _near(surface: Any) -> float:
    """Some edges of the surface's triangles."""
    corners = np.asarray(surface.positions)[np.asarray(surface.triangles)[:, :2]]
    return NEAR_EDGES * float(np.median(np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1)))


def hold_singularities(scene: Any, field: Any, near: float = 0.0) -> list[Any]:
    """Empties in the guides at the field's singularities, to be dragged; raises IllustrateError."""
    places, turns = joined(field.singular_positions, field.singular_indices, near)
    if not len(turns):
        raise IllustrateError("The field has no singularities")
    guides = collection_of_guides(scene)
    size = 0.03 * float(np.linalg.norm(np.ptp(places, axis=0))) or 0.1
    made = []
    for place, turn in zip(places, turns, strict=True):
        empty = bpy.data.objects.new("Turn", None)
        empty.empty_display_type, empty.empty_display_size = "SPHERE", size
        empty.location = place
        empty.illustrate_guide.turns = int(turn)
        guides.objects.link(empty)
        made.append(empty)
    return made


def collection_of_guides(scene: Any) -> Any:
    """The scene's collection of guides, made where there is none."""
    if scene.illustrate.guides is None:
        scene.illustrate.guides = bpy.data.collections.new("Guides")
        scene.collection.children.link(scene.illustrate.guides)
    return scene.illustrate.guides


class ILLUSTRATE_OT_hold_singularities(bpy.types.Operator):
    """Makes them draggable."""

    bl_idname = "illustrate.hold_singularities"
    bl_label = "Hold Singularities"
    bl_description = (
        "Put an empty among the guides at each point that hatches turn round: drag one, and they "
        "turn where it is"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a field, and none of its points is held yet."""
        guides = context.scene.illustrate.guides
        is_held = guides is not None and any(t.type == "EMPTY" for t in guides.all_objects)
        return _prepared() is not None and not is_held

    def execute(self, context: Any) -> set[str]:
        """Puts them there."""
        try:
            prepared = _prepared()
            hold_singularities(context.scene, prepared.field, _near(prepared.surface))
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def _prepared() -> Any:
    if LIVE.prepared is not None:
        return LIVE.prepared
    return INSPECTOR.made.prepared if INSPECTOR.made is not None else None


def is_drawing_guide(context: Any) -> bool:
    """True in the mode that Draw Guide begins."""
    guides, thing = context.scene.illustrate.guides, context.view_layer.objects.active
    is_drawing = context.mode in ("PAINT_GPENCIL", "PAINT_GREASE_PENCIL")
    return bool(is_drawing and guides is not None and thing.name in guides.all_objects)


class ILLUSTRATE_OT_draw_guide(bpy.types.Operator):
    """Lets the artist draw guides, and go back to what was at hand."""

    bl_idname = "illustrate.draw_guide"
    bl_label = "Draw Guide"
    bl_description = (
        "Draw strokes on the surfaces that hatches are to follow; once more: back to the object "
        "that was active before"
    )
    bl_options = {"REGISTER", "UNDO"}

    _before = ""  # the name of the object that was active

    @classmethod
    def poll(cls, context: Any) -> bool:
        """Nothing else is being edited."""
        return bool(context.mode == "OBJECT") or is_drawing_guide(context)

    def execute(self, context: Any) -> set[str]:
        """A Grease Pencil object among the guides, and the mode that draws on surfaces; or back."""
        if is_drawing_guide(context):
            self._leave(context)
        else:
            self._enter(context)
        return {"FINISHED"}

    @classmethod
    def _enter(cls, context: Any) -> None:
        scene, objects = context.scene, context.view_layer.objects
        guide = _guide_pencil(collection_of_guides(scene))
        scene.tool_settings.gpencil_stroke_placement_view3d = "SURFACE"
        if objects.active is not None and objects.active != guide:
            cls._before = objects.active.name
        objects.active = guide
        is_new = guide.type == "GREASEPENCIL"
        bpy.ops.object.mode_set(mode="PAINT_GREASE_PENCIL" if is_new else "PAINT_GPENCIL")

    @classmethod
    def _leave(cls, context: Any) -> None:
        bpy.ops.object.mode_set(mode="OBJECT")
        objects = context.view_layer.objects
        if cls._before in objects:
            objects.active = objects[cls._before]


def _guide_pencil(guides: Any) -> Any:
    """The Grease Pencil object among the guides that is drawn into."""
    kinds = ("GPENCIL", "GREASEPENCIL")
    found = next((thing for thing in guides.all_objects if thing.type in kinds), None)
    if found is not None:
        return found
    store = getattr(bpy.data, "grease_pencils_v3", bpy.data.grease_pencils)
    data = store.new("Guide")
    layer = data.layers.new("Guide")
    layer.frames.new(bpy.context.scene.frame_current)
    thing = bpy.data.objects.new("Guide", data)
    guides.objects.link(thing)
    return thing


@persistent
def _before_load(*_: Any) -> None:
    PICKER.pick(None)


CLASSES = (
    ILLUSTRATE_OT_pick,
    ILLUSTRATE_OT_hide_stroke,
    ILLUSTRATE_OT_hide_hatches,
    ILLUSTRATE_OT_hold_singularities,
    ILLUSTRATE_OT_draw_guide,
)


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
