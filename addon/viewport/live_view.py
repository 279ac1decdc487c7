"""The switch of the live drawing, and what it shows over the viewports.

Whatever the way it ends (switch, file, add-on), nothing stays behind.
"""

import time
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native, output
from ..messages import IllustrateError, amount, said
from ..output.hiding import hide_stroke, points_of
from ..plot.areas import fills_of
from ..reading.cages import is_sculpted
from ..reading.kept_images import IMAGES
from ..reading.mesh_arrays import positions_of
from ..reading.scene import CameraArrays, camera_problem, read_camera
from ..running.cache import digest
from ..running.illustration import Illustration
from ..settings.guides import is_guide
from ..settings.scene_settings import draw_values
from .hidden_strokes import hidden_in
from .live import LINES, LIVE, WHOLE, Seen
from .live_strokes import has_others, inks_of, strokes_as_ribbons
from .shown import redraw, viewports
from .views import View, view_of

TIMES_KEPT = 2000
SHAPED = ("MESH", "CURVE", "SURFACE", "FONT", "META", "EMPTY", "ARMATURE", "LATTICE")
DATA = (bpy.types.Mesh, bpy.types.Curve, bpy.types.MetaBall)
EYES = [
    ("VIEW", "View", "What the view itself sees", 0),
    ("CAMERA", "Camera", "The lines that the scene's camera sees, looked at from anywhere", 1),
]


class LiveView:
    """The handlers that show the live drawing, and what they keep for the graphics card."""

    def __init__(self) -> None:
        self.seconds: list[float] = []  # of the last redraws, our part
        self.blocks: list[float] = []  # of the last looks at the scene
        self._handle: Any = None
        self._batches: dict[tuple[int, bool], tuple[Any, Any, Any]] = {}
        self._depth: tuple[Any, Any] = (None, None)
        self._seen: Any = None
        self.when_switched: list[Any] = []  # called when it is turned on or off

    @property
    def is_on(self) -> bool:
        """True while the drawing is shown."""
        return self._handle is not None

    def switch(self, on: bool) -> None:
        """Shows the drawing, or stops."""
        if on and not self.is_on:
            self._start()
        elif not on and self.is_on:
            self._stop()
        for function in self.when_switched:
            function()
        redraw()

    def _start(self) -> None:
        self.seconds, self.blocks = [], []
        view = bpy.types.SpaceView3D
        # Before gizmos and texts, which stay on top.
        self._handle = view.draw_handler_add(self._draw, (), "WINDOW", "POST_VIEW")
        for handlers, function in HANDLERS:
            handlers.append(function)
        bpy.app.timers.register(self._tick_again, first_interval=0.0)

    def _stop(self) -> None:
        bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
        self._handle = None
        for handlers, function in HANDLERS:
            if function in handlers:
                handlers.remove(function)
        if bpy.app.timers.is_registered(self._tick_again):
            bpy.app.timers.unregister(self._tick_again)
        LIVE.forget()
        self._batches, self._depth, self._seen = {}, (None, None), None

    def look_at(self, scene: Any, depsgraph: Any) -> None:
        """Marks what an update has made stale: shapes, or only lights."""
        seen = _what_is_seen(scene)
        if any(isinstance(update.id, bpy.types.Image) for update in depsgraph.updates):
            IMAGES.forget()
        if seen != self._seen or any(map(_changes_shapes, depsgraph.updates)):
            self._seen = seen
            LIVE.shapes_are_stale = True
        elif any(map(_changes_light, depsgraph.updates)):
            LIVE.look_is_stale = True

    def tick(self) -> None:
        """One look at the job and at what is stale."""
        start = time.perf_counter()
        regions = {r.as_pointer() for area in viewports(bpy.context) for r in area.regions}
        LIVE.views = {pointer: v for pointer, v in LIVE.views.items() if pointer in regions}
        self._batches = {key: v for key, v in self._batches.items() if key[0] in regions}
        if LIVE.tick(bpy.context):
            redraw()
        _note(self.blocks, start)

    def _tick_again(self) -> float | None:
        if not self.is_on:
            return None
        self.tick()
        return LIVE.next_look_s()

    def _view(self, context: Any) -> View | None:
        depsgraph = context.evaluated_depsgraph_get()
        return view_of(context.scene, depsgraph, context.region, context.region_data)

    def _draw(self) -> None:
        """Called by Blender for each viewport."""
        start, context = time.perf_counter(), bpy.context
        view = self._view(context)
        if view is None:
            return
        seen, eye = LIVE.look(context.region.as_pointer(), view), _seen_from(context)
        if LIVE.prepared is not None and (seen.drawing_of(LINES) is None or eye is not None):
            self._draw_lines(context, view, eye)
        if eye is None:
            self._draw_strokes(context, seen)
        _note(self.seconds, start)

    def _draw_lines(self, context: Any, view: View, eye: CameraArrays | None) -> None:
        """Rough lines, where there are no exact ones yet."""
        from . import overlay

        if not context.space_data.show_object_viewport_mesh:
            overlay.draw_depth(self._surface())
        overlay.draw_rough(_rough(context, view, eye), context.region, context.region_data)

    def _draw_strokes(self, context: Any, seen: Seen) -> None:
        """What is drawn of a view."""
        from . import overlay

        for made, hatches in ((seen.hatched(), True), (seen.drawing_of(LINES), False)):
            batch = None if made is None else self._batch(context, seen, made, hatches)
            if batch is not None:
                overlay.draw_ribbons(batch, context.region)

    def _batch(self, context: Any, seen: Seen, made: Illustration, hatches: bool) -> Any:
        """The hatches of a drawing, or all else, made once; None where there are none."""
        from . import overlay

        inks = inks_of(context.scene.illustrate)
        hiding = context.region_data if has_others(context.scene, set(made.names)) else None
        hidden = hidden_in(context.scene, made.drawing)
        place = tuple(seen.view.origin), seen.view.zoom
        look = (*place, repr(inks), hiding is None, hidden)
        key = context.region.as_pointer(), hatches
        known, known_look, batch = self._batches.get(key, (None, None, None))
        if known is not made or known_look != look:
            ribbons = strokes_as_ribbons(made.drawing, seen.view, inks, hatches, hiding, hidden)
            batch = overlay.ribbon_batch(ribbons)
            self._batches[key] = (made, look, batch)
        return batch

    def _surface(self) -> Any:
        """The surface, where the viewport itself shows none that could hide lines."""
        from . import overlay

        prepared = LIVE.prepared
        if self._depth[0] is not prepared:
            surface = prepared.surface
            self._depth = prepared, overlay.surface_batch(surface.positions, surface.triangles)
        return self._depth[1]


VIEW = LiveView()
"""The live view of this Blender."""


def _note(times: list[float], start: float) -> None:
    """Keeps how long it took since `start`, beside the last of its kind."""
    times.append(time.perf_counter() - start)
    del times[:-TIMES_KEPT]


def _rough(context: Any, view: View, eye: CameraArrays | None) -> Any:
    """Rough lines of a view as the settings have lines; of another eye where there is one.

    The region's own matrices, since they reach beyond the frame of a camera.
    """
    from . import overlay

    ill, chosen, data = native.load(), context.scene.illustrate, context.region_data
    camera = eye or CameraArrays(
        np.array(data.window_matrix, float),
        np.array(data.view_matrix, float),
        context.region.width,
        context.region.height,
    )
    widths = draw_values(chosen, view.camera.width_px)
    inks, zoom = inks_of(chosen), view.zoom
    ends = ill.rough_silhouettes(LIVE.prepared, ill.Camera(**vars(camera)))
    return overlay.Rough(
        [
            overlay.Marks(
                "LINES", LIVE.features, inks["Feature"], widths["feature_width_px"] * zoom
            ),
            overlay.Marks("LINES", ends, inks["Line"], widths["line_width_px"] * zoom),
        ],
        inks["Hidden"] if chosen.hidden else None,
        chosen.hidden_width_scale,
    )


def _seen_from(context: Any) -> CameraArrays | None:
    """The camera whose lines are looked at from anywhere, where that was chosen."""
    if context.window_manager.illustrate_live_eye != "CAMERA" or camera_problem(context.scene):
        return None
    return read_camera(context.scene, context.evaluated_depsgraph_get())


def _what_is_seen(scene: Any) -> Any:
    by_selection = scene.illustrate.source == "SELECTION"
    return scene.name, tuple(
        (t.name, t.hide_render, t.visible_get(), by_selection and t.select_get(), _sculpted(t))
        for t in scene.objects
    )


def _sculpted(thing: Any) -> str:
    """A digest of a shape that changes without a word from Blender; empty for all others."""
    if thing.type != "MESH" or not is_sculpted(thing):
        return ""
    return digest(positions_of(thing.data))


def _changes_shapes(update: Any) -> bool:
    """Of meshes, or of what they are made of."""
    if isinstance(update.id, bpy.types.Material | bpy.types.Image):
        return True
    if not (update.is_updated_geometry or update.is_updated_transform):
        return False
    is_data = isinstance(update.id, DATA)
    if isinstance(update.id, bpy.types.Object) and is_guide(update.id, bpy.context.scene):
        return True
    return is_data or getattr(update.id, "type", "") in SHAPED


def _changes_light(update: Any) -> bool:
    is_data = isinstance(update.id, bpy.types.Light | bpy.types.World)
    return is_data or getattr(update.id, "type", "") == "LIGHT"


@persistent
def _after_update(scene: Any, depsgraph: Any = None) -> None:
    if depsgraph is not None and scene == bpy.context.scene:
        VIEW.look_at(scene, depsgraph)


@persistent
def _after_frame(*_: Any) -> None:
    LIVE.shapes_are_stale = True


@persistent
def _after_undo(*_: Any) -> None:
    IMAGES.forget()  # they are other datablocks now
    LIVE.shapes_are_stale = True


@persistent
def _before_load(*_: Any) -> None:
    VIEW.switch(False)


HANDLERS = (
    (bpy.app.handlers.depsgraph_update_post, _after_update),
    (bpy.app.handlers.frame_change_post, _after_frame),
    (bpy.app.handlers.undo_post, _after_undo),
    (bpy.app.handlers.redo_post, _after_undo),
)


class ILLUSTRATE_OT_toggle_live(bpy.types.Operator):
    """The switch for menus and shortcuts."""

    bl_idname = "illustrate.toggle_live"
    bl_label = "Live"
    bl_description = (
        "Draw in the viewports while you work: lines while a view moves, hatches when it rests"
    )

    def execute(self, _context: Any) -> set[str]:
        """Turns it on or off."""
        VIEW.switch(not VIEW.is_on)
        return {"FINISHED"}


class ILLUSTRATE_OT_keep_live(bpy.types.Operator):
    """Turns what is seen into strokes."""

    bl_idname = "illustrate.keep_live"
    bl_label = "Keep"
    bl_description = "Turn the live drawing of this viewport into strokes, and end it"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a whole drawing of the largest viewport."""
        is_whole = _kept(context) is not None
        if not is_whole:
            cls.poll_message_set(said("The live drawing is not whole yet: let the view rest"))
        return is_whole

    def execute(self, context: Any) -> set[str]:
        """Writes it as Illustrate does."""
        made, scene = _kept(context), context.scene
        chosen, camera = scene.illustrate, made.arrays.camera
        try:
            areas = fills_of(scene, made)
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        output.write_drawing(scene, made.drawing, camera, chosen.output, made.names, areas)
        for number in hidden_in(scene, made.drawing):
            if not hide_stroke(scene, points_of(made.drawing, number)):
                what = said("Curves are seen whole: hidden strokes are there again")
                self.report({"WARNING"}, what)
                break
        VIEW.switch(False)
        strokes = amount(len(made.drawing.kinds), "stroke")
        self.report({"INFO"}, said("Kept {strokes}", strokes=strokes))
        return {"FINISHED"}


def _kept(context: Any) -> Any:
    """The whole drawing of the viewport that the mouse is in, else of the only one drawn."""
    area = context.area
    regions = [r for r in area.regions if r.type == "WINDOW"] if area is not None else []
    seen = [LIVE.views[r.as_pointer()] for r in regions if r.as_pointer() in LIVE.views]
    found = seen or list(LIVE.views.values())
    return found[0].drawing_of(WHOLE) if len(found) == 1 else None


CLASSES = (ILLUSTRATE_OT_toggle_live, ILLUSTRATE_OT_keep_live)


def register() -> None:
    """Registers the switch."""
    bpy.app.handlers.load_pre.append(_before_load)
    for each in CLASSES:
        bpy.utils.register_class(each)
    manager = bpy.types.WindowManager
    manager.illustrate_live = bpy.props.BoolProperty(
        name="Live",
        description=ILLUSTRATE_OT_toggle_live.bl_description,
        get=lambda _manager: VIEW.is_on,
        set=lambda _manager, on: VIEW.switch(on),
    )
    manager.illustrate_live_eye = bpy.props.EnumProperty(
        name="Live From",
        items=EYES,
        default="VIEW",
        description="Whose lines are shown",
        update=lambda _manager, _context: redraw(),
    )


def unregister() -> None:
    """Turns the live drawing off and takes the switch away."""
    VIEW.switch(False)
    bpy.app.handlers.load_pre.remove(_before_load)
    del bpy.types.WindowManager.illustrate_live_eye
    del bpy.types.WindowManager.illustrate_live
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
