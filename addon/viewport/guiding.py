"""Guides made by hand: points that hatches turn round, to be dragged, and strokes they follow."""

from typing import Any

import bpy
import numpy as np

from ..messages import IllustrateError, said
from .inspect import INSPECTOR
from .live import LIVE

NEAR_EDGES = 6.0  # of triangles, within which singularities count as one


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
        raise IllustrateError(said("The field has no singularities"))
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


CLASSES = (ILLUSTRATE_OT_hold_singularities, ILLUSTRATE_OT_draw_guide)


def register() -> None:
    """Registers the operators."""
    for each in CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    """Takes them away."""
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
