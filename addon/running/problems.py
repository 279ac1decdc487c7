"""What would stop or slow a drawing, found before the click and quickly enough for every redraw."""

from collections.abc import Iterator
from typing import Any

from ..messages import said
from ..ownership import is_ours
from ..reading.scene import camera_problem, nothing_to_draw
from ..reading.shown import shown_objects
from ..settings.styles import style_of

SECONDS_PER_TRIANGLE = 15e-6  # measured, with hatching, two cores
LONG_S = 10.0
MIGHT_HAVE_FACES = {"CURVE", "SURFACE", "FONT", "META", "CURVES", "VOLUME", "POINTCLOUD"}


def stopping_problem(scene: Any, view_layer: Any) -> str:
    """Why no drawing can be made of the scene, and the way out; empty when one can."""
    problem = camera_problem(scene)
    if problem:
        return problem
    selected_only = scene.illustrate.source == "SELECTION"
    if next(drawable(scene, view_layer, selected_only), None) is None:
        empty = [thing.name for thing in view_layer.objects if thing.type == "MESH"]
        return nothing_to_draw(scene, selected_only, [] if selected_only else empty)
    return ""


def slowing_problem(scene: Any, view_layer: Any) -> str:
    """A word about scenes that take long, with the way out; empty for others."""
    counts = {
        thing.name: len(thing.data.polygons)
        for thing in drawable(scene, view_layer, scene.illustrate.source == "SELECTION")
        if thing.type == "MESH"
    }
    seconds = SECONDS_PER_TRIANGLE * 2 * sum(counts.values())
    if seconds < LONG_S:
        return ""
    heaviest = max(counts, key=lambda name: counts[name])
    return said(
        '"{name}" has {count:,} faces: the first drawing takes about {seconds:.0f} s. Give it '
        "fewer with a Decimate modifier, or set its style to Ignore",
        name=heaviest,
        count=counts[heaviest],
        seconds=seconds,
    )


def drawable(scene: Any, view_layer: Any, selected_only: bool) -> Iterator[Any]:
    """Objects of the view layer that may be drawn; instances are not unfolded."""
    guides = scene.illustrate.guides
    for thing in shown_objects(view_layer):
        if selected_only and not thing.select_get(view_layer=view_layer):
            continue
        if thing.hide_render or is_ours(thing):
            continue
        if guides is not None and thing.name in guides.all_objects:
            continue
        if _may_have_faces(thing) and not style_of(thing, scene).get("ignore"):
            yield thing


def _may_have_faces(thing: Any) -> bool:
    if thing.type == "MESH":
        return bool(len(thing.data.polygons) or len(thing.modifiers) or thing.mode == "EDIT")
    return thing.type in MIGHT_HAVE_FACES or thing.is_instancer
