"""What a scene lacks to be drawn, made with one click: something to draw, a camera, a light."""

import math
from collections.abc import Iterator
from typing import Any

import bpy
from mathutils import Matrix, Vector

from ..messages import IllustrateError, said
from ..reading.scene import camera_problem
from .problems import drawable, stopping_problem

SIDE = Vector((0.5, -1.0, 0.4))  # from which a camera looks where no viewport says it
SUN_TILT = (math.radians(35), math.radians(30), 0.0)
MARGIN = 1.15  # of the distance at which everything just fits


def missing(scene: Any, view_layer: Any) -> list[str]:
    """What `make_missing` would make, in words; empty when nothing stands in a drawing's way."""
    return [words for words, _ in _lacks(scene, view_layer)]


def make_missing(scene: Any, view_layer: Any, view: Any = None) -> list[str]:
    """Makes what is missing; in words. view: the matrix of a viewport that the camera takes over.

    Raises IllustrateError when something else stands in the way.
    """
    made = []
    for words, make in list(_lacks(scene, view_layer)):  # all, before the first is made
        make(scene, view_layer, view)
        view_layer.update()
        made.append(words)
    problem = stopping_problem(scene, view_layer)
    if problem:
        raise IllustrateError(problem)
    return made


def _lacks(scene: Any, view_layer: Any) -> Iterator[tuple[str, Any]]:
    if not any(drawable(scene, view_layer, False)):
        yield said("an object"), _add_monkey
    elif scene.illustrate.source == "SELECTION" and not any(drawable(scene, view_layer, True)):
        yield said("a selection"), _select_all
    if camera_problem(scene):
        yield said("a camera"), _add_camera
        if not any(thing.type == "LIGHT" for thing in view_layer.objects):
            yield said("a light"), _add_sun


def _link(scene: Any, name: str, data: Any) -> Any:
    thing = bpy.data.objects.new(name, data)
    scene.collection.objects.link(thing)
    return thing


def _add_monkey(scene: Any, _layer: Any, _view: Any) -> None:
    """Suzanne, as a surface of subdivision."""
    import bmesh  # type: ignore[import-not-found]

    # Not by the operator that adds one, which needs a window's context and changes what is
    # selected.
    mesh = bpy.data.meshes.new("Suzanne")
    shape = bmesh.new()
    bmesh.ops.create_monkey(shape)
    for face in shape.faces:
        face.smooth = True
    shape.to_mesh(mesh)
    shape.free()
    monkey = _link(scene, "Suzanne", mesh)
    monkey.modifiers.new("Subdivision", "SUBSURF").levels = 2


def _select_all(scene: Any, view_layer: Any, _view: Any) -> None:
    for thing in drawable(scene, view_layer, False):
        thing.select_set(True, view_layer=view_layer)


def _add_camera(scene: Any, view_layer: Any, view: Any) -> None:
    """A camera that sees all that can be drawn, from where the viewport looks."""
    camera = _link(scene, "Camera", bpy.data.cameras.new("Camera"))
    scene.camera = camera
    view_layer.update()
    corners = [
        thing.matrix_world @ Vector(corner)
        for thing in drawable(scene, view_layer, False)
        for corner in thing.bound_box
    ]
    turned = view.to_3x3().inverted() if view is not None else _towards(SIDE)
    camera.matrix_world = turned.to_4x4()
    view_layer.update()
    flat = [number for corner in corners for number in corner]
    place, _ = camera.camera_fit_coords(view_layer.depsgraph, flat)
    middle = sum(corners, Vector()) / len(corners)
    camera.location = middle + (place - middle) * MARGIN
    distance = (camera.location - middle).length
    camera.data.clip_end = max(camera.data.clip_end, 3 * distance)


def _towards(side: Any) -> Matrix:
    """The turn of a camera that looks from a side at the origin."""
    return side.to_track_quat("Z", "Y").to_matrix()


def _add_sun(scene: Any, _layer: Any, _view: Any) -> None:
    sun = _link(scene, "Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.rotation_euler = SUN_TILT


class ILLUSTRATE_OT_set_up(bpy.types.Operator):
    """Makes what is missing."""

    bl_idname = "illustrate.set_up"
    bl_label = "Set Up Scene"
    bl_description = (
        "Make what a drawing needs and the scene lacks: an object, a camera that sees everything "
        "from where you look, a light"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """Something is missing."""
        return bool(missing(context.scene, context.view_layer))

    def execute(self, context: Any) -> set[str]:
        """Makes it, as one step of undo."""
        view = getattr(context, "region_data", None)
        try:
            made = make_missing(
                context.scene, context.view_layer, view.view_matrix if view is not None else None
            )
        except IllustrateError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, said("Made {things}", things=", ".join(made)))
        return {"FINISHED"}


class ILLUSTRATE_OT_reset(bpy.types.Operator):
    """Sets the settings back."""

    bl_idname = "illustrate.reset"
    bl_label = "Reset"
    bl_description = "Set all settings of the drawing to what they are in a new scene"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        """All that presets hold; what is drawn, guides and frames stay."""
        context.scene.illustrate.restore_defaults()
        return {"FINISHED"}


register, unregister = bpy.utils.register_classes_factory(
    (ILLUSTRATE_OT_set_up, ILLUSTRATE_OT_reset)
)
