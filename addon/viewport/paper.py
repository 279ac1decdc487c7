"""The drawing on paper: a viewport that looks through the camera and shows nothing else.

Surfaces are hidden by their types (in Solid shading the one colour that would hide them colours
Grease Pencil too); the live drawing keeps their depth. What the viewport was like is kept while it
is on paper and comes back to the last setting, whichever way it leaves: the switch, another file,
the end of the add-on. A file that is saved has the artist's own.
"""

from collections.abc import Iterator
from typing import Any

import bpy
from bpy.app.handlers import persistent

from ..reading.scene import camera_problem
from ..settings.scene_settings import when_paper_changes
from . import fine_strokes
from .live_view import VIEW

WHITE = (1.0, 1.0, 1.0)
LOOK = (
    "view_perspective",
    "view_location",
    "view_rotation",
    "view_distance",
    "view_camera_zoom",
    "view_camera_offset",
)

PENCILS = "show_object_viewport_grease_pencil"

Kept = list[tuple[str, str, Any]]  # owner, name, value


def paper_colour(scene: Any) -> tuple[float, ...]:
    """White, or the colour of the scene's world."""
    if scene.illustrate.paper == "WORLD" and scene.world is not None:
        return tuple(scene.world.color)
    return WHITE


def _wanted(colour: tuple[float, ...], shows_pencils: bool) -> Kept:
    """Settings of a viewport on paper, those first on which others depend."""
    flat = {
        "type": "SOLID",
        "color_type": "MATERIAL",
        "background_type": "VIEWPORT",
        "background_color": colour,
        "show_xray": False,
        "show_shadows": False,
        "show_cavity": False,
        "show_object_outline": False,
        "use_dof": False,
    }
    return [
        *(("shading", name, value) for name, value in flat.items()),
        ("overlay", "show_overlays", False),
        ("", "show_gizmo", False),
        *(("", name, shows_pencils and name == PENCILS) for name in _types()),
        ("region_3d", "view_perspective", "CAMERA"),
    ]


def _types() -> list[str]:
    """The settings of a viewport that show types of objects."""
    names = bpy.types.SpaceView3D.bl_rna.properties.keys()
    return [name for name in names if name.startswith("show_object_viewport_")]


def _owner(space: Any, path: str) -> Any:
    return getattr(space, path) if path else space


def _value(owner: Any, name: str) -> Any:
    value = getattr(owner, name)
    return value if isinstance(value, str | int | float) else tuple(value)


def _settings(space: Any) -> Kept:
    """What a viewport on paper has otherwise, as it is."""
    names = [(path, name) for path, name, _ in _wanted(WHITE, True)]
    names += [("region_3d", name) for name in LOOK if ("region_3d", name) not in names]
    return [(path, name, _value(_owner(space, path), name)) for path, name in names]


def _set(space: Any, values: Kept) -> None:
    for path, name, value in values:
        setattr(_owner(space, path), name, value)


def _spaces() -> Iterator[tuple[Any, Any]]:
    """All 3D views of all screens, shown or not, with their areas."""
    for screen in bpy.data.screens:
        for area in screen.areas:
            for space in area.spaces:
                if space.type == "VIEW_3D":
                    yield area, space


class Paper:
    """Which viewports are on paper, and what they were like before."""

    def __init__(self) -> None:
        self._kept: dict[int, Kept] = {}
        self._handle: Any = None
        self._strokes: dict[int, tuple[Any, Any]] = {}  # by region: of which view, and the batch
        self.was_offered = False

    def is_on(self, space: Any) -> bool:
        """True while a viewport is on paper."""
        return space.as_pointer() in self._kept

    def is_on_anywhere(self) -> bool:
        """True while any viewport is."""
        return bool(self._kept)

    def enter(self, space: Any, scene: Any) -> None:
        """Puts a viewport on paper."""
        if not self.is_on(space):
            self._kept[space.as_pointer()] = _settings(space)
        if fine_strokes.IS_NEEDED and self._handle is None:
            add = bpy.types.SpaceView3D.draw_handler_add
            self._handle = add(self._draw, (), "WINDOW", "POST_VIEW")
        _set(space, _wanted(paper_colour(scene), _shows_pencils()))

    def leave(self, space: Any) -> None:
        """Gives a viewport back what it had."""
        kept = self._kept.pop(space.as_pointer(), None)
        if kept is not None:
            _set(space, [k for k in kept if k[1] != "view_perspective"])
            _set(space, [k for k in kept if k[1] == "view_perspective"])
        self._stop_drawing_unless_on()

    def leave_all(self) -> list[Any]:
        """The same for all; the viewports that were on paper."""
        left = [space for _, space in _spaces() if self.is_on(space)]
        for space in left:
            self.leave(space)
        self._kept.clear()  # of windows that are gone
        self._stop_drawing_unless_on()
        return left

    def _stop_drawing_unless_on(self) -> None:
        if self._handle is not None and not self._kept:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
            self._handle, self._strokes = None, {}

    def refresh(self, scene: Any) -> None:
        """Follows the colour of the paper, and whether strokes or the live drawing are shown."""
        for _, space in _spaces():
            if self.is_on(space):
                _set(space, _wanted(paper_colour(scene), _shows_pencils())[:-1])

    def follow_pencils(self) -> None:
        """After a change of anything: strokes are drawn anew, by Blender where it must."""
        self._strokes = {}
        shown = _shows_pencils()
        for _, space in _spaces():
            if self.is_on(space) and getattr(space, PENCILS) != shown:
                setattr(space, PENCILS, shown)

    def _draw(self) -> None:
        """Called by Blender for each viewport: strokes in place of its own."""
        from . import overlay

        context = bpy.context
        space, region = context.space_data, context.region
        if not self.is_on(space) or VIEW.is_on or getattr(space, PENCILS):
            return
        view = tuple(map(tuple, context.region_data.perspective_matrix))
        known, batch = self._strokes.get(region.as_pointer(), (None, None))
        if known != (view, region.width, region.height):
            ribbons = fine_strokes.ribbons_on_paper(context)
            batch = None if ribbons is None else overlay.ribbon_batch(ribbons)
            self._strokes[region.as_pointer()] = ((view, region.width, region.height), batch)
        if batch is not None:
            overlay.draw_ribbons(batch, region)


def _shows_pencils() -> bool:
    """Whether Blender itself draws the strokes on paper."""
    return not VIEW.is_on and not fine_strokes.can_show(bpy.context.view_layer)


PAPER = Paper()
"""The paper of this Blender."""


class ILLUSTRATE_OT_toggle_paper(bpy.types.Operator):
    """Puts a viewport on paper, or takes it off."""

    bl_idname = "illustrate.toggle_paper"
    bl_label = "Paper"
    bl_description = (
        "Look through the camera at paper with the drawing alone; once more: as it was before"
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        """It is a viewport, and there is a camera to look through."""
        space = context.space_data
        if space is None or space.type != "VIEW_3D":
            return False
        problem = "" if PAPER.is_on(space) else camera_problem(context.scene)
        if problem:
            cls.poll_message_set(problem)
        return not problem

    def execute(self, context: Any) -> set[str]:
        """Turns it on or off."""
        space = context.space_data
        if PAPER.is_on(space):
            PAPER.leave(space)
        else:
            PAPER.enter(space, context.scene)
        return {"FINISHED"}


def offer(context: Any) -> None:
    """Once, after the first drawing in a window: the way to paper."""
    if PAPER.was_offered or PAPER.is_on_anywhere() or bpy.app.background:
        return
    PAPER.was_offered = True

    def draw(menu: Any, _context: Any) -> None:
        menu.layout.operator(ILLUSTRATE_OT_toggle_paper.bl_idname, text="Show on Paper")

    context.window_manager.popup_menu(draw, title="The drawing is made for the camera", icon="INFO")


@persistent
def _before_load(*_: Any) -> None:
    PAPER.leave_all()


_on_paper_when_saved: list[Any] = []


@persistent
def _before_save(*_: Any) -> None:
    _on_paper_when_saved[:] = PAPER.leave_all()


@persistent
def _after_save(*_: Any) -> None:
    while _on_paper_when_saved:
        PAPER.enter(_on_paper_when_saved.pop(), bpy.context.scene)


def _after_switch() -> None:
    PAPER.refresh(bpy.context.scene)


@persistent
def _after_update(*_: Any) -> None:
    if fine_strokes.IS_NEEDED and PAPER.is_on_anywhere():
        PAPER.follow_pencils()


HANDLERS = (
    (bpy.app.handlers.load_pre, _before_load),
    (bpy.app.handlers.save_pre, _before_save),
    (bpy.app.handlers.save_post, _after_save),
    (bpy.app.handlers.depsgraph_update_post, _after_update),
    (bpy.app.handlers.frame_change_post, _after_update),
    (VIEW.when_switched, _after_switch),
    (when_paper_changes, PAPER.refresh),
)


def register() -> None:
    """Registers the switch."""
    bpy.utils.register_class(ILLUSTRATE_OT_toggle_paper)
    for handlers, function in HANDLERS:
        handlers.append(function)


def unregister() -> None:
    """Takes all viewports off paper, and the switch away."""
    PAPER.leave_all()
    for handlers, function in HANDLERS:
        handlers.remove(function)
    bpy.utils.unregister_class(ILLUSTRATE_OT_toggle_paper)
