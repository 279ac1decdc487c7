"""Live lines: silhouettes and feature curves over the viewport while the view moves.

The surface is read and prepared again when the scene changes, in a thread; what is drawn until then
is the last one. Whatever the way it ends (switch, file, add-on), nothing stays behind.
"""

import time
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native, settings
from ..messages import IllustrateError
from ..preferences import preference
from ..scene import CameraArrays, read_scene
from ..worker import Worker
from .view_lines import ViewLines, eye_of

TICK_S = 0.1
TIMES_KEPT = 200
EYES = [
    ("VIEW", "View", "The lines of the view itself", 0),
    ("CAMERA", "Camera", "The lines that the scene's camera sees, looked at from anywhere", 1),
]


class LiveLines:
    """The switch and all that belongs to it."""

    def __init__(self) -> None:
        self.lines: ViewLines | None = None
        self.problem = ""
        self.seconds: list[float] = []  # of the last redraws, our part
        self._handle: Any = None
        self._worker: Worker | None = None
        self._is_stale = False
        self._seen: Any = None

    @property
    def is_on(self) -> bool:
        """True while lines are shown."""
        return self._handle is not None

    def switch(self, on: bool) -> None:
        """Shows lines, or stops."""
        if on and not self.is_on:
            self._start()
        elif not on and self.is_on:
            self._stop()
        _redraw()

    def _start(self) -> None:
        self._is_stale, self.seconds = True, []
        view = bpy.types.SpaceView3D
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
        if self._worker is not None:
            self._worker.cancel()
        self.lines, self._worker, self._seen, self.problem = None, None, None, ""

    def mark_stale(self) -> None:
        """The scene is other than when it was read."""
        self._is_stale = True

    def look_at(self, scene: Any, depsgraph: Any) -> None:
        """Marks the lines as stale when an update was one of meshes, or of what is seen."""
        seen = _what_is_seen(scene)
        if seen != self._seen or any(map(_changes_lines, depsgraph.updates)):
            self._seen = seen
            self._is_stale = True

    def tick(self) -> None:
        """Takes over what a thread has made, and starts the next when the scene changed."""
        if self._worker is not None and self._worker.is_done:
            worker, self._worker = self._worker, None
            if worker.error is None:
                self.lines, self.problem = worker.result, ""
            else:
                self.lines, self.problem = None, str(worker.error)
            _redraw()
        if self._is_stale and self._worker is None:
            self._is_stale = False
            self._read()

    def _tick_again(self) -> float | None:
        if not self.is_on:
            return None
        self.tick()
        return TICK_S

    def _read(self) -> None:
        context = bpy.context
        self._seen = _what_is_seen(context.scene)
        try:
            arrays = read_scene(
                context.scene,
                context.evaluated_depsgraph_get(),
                use_lights=False,
                camera=_any_camera(context),
            )
        except IllustrateError as error:
            self.lines, self.problem = None, str(error)
            return
        values = settings.prepare_values(context.scene.illustrate)
        values["level"] = -1  # as fine as the view needs, within the budget
        values["triangle_budget"] = min(values["triangle_budget"], preference("live_triangles"))
        self._worker = Worker(lambda progress: _prepare(arrays.meshes, values, progress))

    def _draw(self) -> None:
        """Called by Blender for each viewport."""
        from . import overlay

        if self.lines is None:
            return
        start = time.perf_counter()
        context = bpy.context
        eye = _eye(context.scene, context.region_data)
        colour = preference("live_color")
        width = preference("live_width")
        marks = [
            overlay.Marks("LINES", self.lines.silhouettes(eye), colour, width),
            overlay.Marks("LINES", self.lines.features, colour, 0.7 * width),
        ]
        overlay.draw(marks, context.region, context.region_data)
        self.seconds = [*self.seconds[1 - TIMES_KEPT :], time.perf_counter() - start]


LIVE = LiveLines()
"""The live lines of this Blender."""


def _prepare(meshes: list[Any], values: dict[str, Any], progress: Any) -> ViewLines:
    ill = native.load()
    prepared = ill.prepare(
        [ill.PolygonMesh(**vars(mesh)) for mesh in meshes],
        ill.PrepareOptions(**values, field=False),
        progress=progress,
    )
    return ViewLines(prepared.surface)


def _eye(scene: Any, view: Any) -> Any:
    """(4,) whose lines are shown."""
    if scene.camera is not None and bpy.context.window_manager.illustrate_live_eye == "CAMERA":
        world = scene.camera.matrix_world.normalized()
        is_parallel = scene.camera.data.type == "ORTHO"
        projection = np.diag([1.0, 1.0, 1.0, 1.0 if is_parallel else 0.0])
        return eye_of(projection, world.inverted())
    return eye_of(view.window_matrix, view.view_matrix)


def _any_camera(context: Any) -> CameraArrays:
    """The view of the first 3D viewport, which says how fine surfaces must be."""
    for area in _viewports(context):
        view, region = area.spaces.active.region_3d, area.regions[-1]
        projection = np.array(view.window_matrix)
        if np.linalg.det(projection):
            return CameraArrays(
                projection, np.array(view.view_matrix), max(region.width, 1), max(region.height, 1)
            )
    return CameraArrays(np.diag([0.1, 0.1, -0.01, 1.0]), np.eye(4), 1000, 1000)


def _viewports(context: Any) -> list[Any]:
    windows = context.window_manager.windows
    return [area for w in windows for area in w.screen.areas if area.type == "VIEW_3D"]


def _redraw() -> None:
    for area in _viewports(bpy.context):
        area.tag_redraw()


def _what_is_seen(scene: Any) -> Any:
    return scene.name, tuple((t.name, t.hide_render, t.visible_get()) for t in scene.objects)


def _changes_lines(update: Any) -> bool:
    if not (update.is_updated_geometry or update.is_updated_transform):
        return False
    kind = getattr(update.id, "type", "")
    is_mesh = isinstance(update.id, bpy.types.Mesh | bpy.types.Curve | bpy.types.MetaBall)
    return is_mesh or kind in ("MESH", "CURVE", "SURFACE", "FONT", "META", "EMPTY")


@persistent
def _after_update(scene: Any, depsgraph: Any = None) -> None:
    if depsgraph is not None and scene == bpy.context.scene:
        LIVE.look_at(scene, depsgraph)


@persistent
def _after_undo(*_: Any) -> None:
    LIVE.mark_stale()


@persistent
def _before_load(*_: Any) -> None:
    LIVE.switch(False)


HANDLERS = (
    (bpy.app.handlers.depsgraph_update_post, _after_update),
    (bpy.app.handlers.undo_post, _after_undo),
    (bpy.app.handlers.redo_post, _after_undo),
)


class ILLUSTRATE_OT_toggle_live(bpy.types.Operator):
    """The switch for menus and shortcuts."""

    bl_idname = "illustrate.toggle_live"
    bl_label = "Live Lines"
    bl_description = "Show silhouettes and creases over the viewport while the view moves"

    def execute(self, _context: Any) -> set[str]:
        """Turns them on or off."""
        LIVE.switch(not LIVE.is_on)
        return {"FINISHED"}


def register() -> None:
    """Registers the switch."""
    bpy.app.handlers.load_pre.append(_before_load)
    bpy.utils.register_class(ILLUSTRATE_OT_toggle_live)
    manager = bpy.types.WindowManager
    manager.illustrate_live = bpy.props.BoolProperty(
        name="Live Lines",
        description=ILLUSTRATE_OT_toggle_live.bl_description,
        get=lambda _manager: LIVE.is_on,
        set=lambda _manager, on: LIVE.switch(on),
    )
    manager.illustrate_live_eye = bpy.props.EnumProperty(
        name="Live Lines From",
        items=EYES,
        default="VIEW",
        description="Whose lines are shown",
        update=lambda _manager, _context: _redraw(),
    )


def unregister() -> None:
    """Turns live lines off and takes the switch away."""
    LIVE.switch(False)
    bpy.app.handlers.load_pre.remove(_before_load)
    del bpy.types.WindowManager.illustrate_live_eye
    del bpy.types.WindowManager.illustrate_live
    bpy.utils.unregister_class(ILLUSTRATE_OT_toggle_live)
