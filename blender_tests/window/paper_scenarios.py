"""The drawing on paper, in a window: what is seen, and what the viewport is like afterwards."""

import pathlib
from typing import Any

import bpy
import hands
import illustrate
import numpy as np
from illustrate.running import tasks
from illustrate.viewport import fine_strokes
from illustrate.viewport.live import LIVE, WHOLE
from illustrate.viewport.live_view import VIEW
from illustrate.viewport.paper import PAPER, PENCILS
from staging import Steps, new_scene, pencils

EDIT_PENCIL = "EDIT" if bpy.app.version >= (4, 3, 0) else "EDIT_GPENCIL"


def space() -> Any:
    return hands.viewport().spaces.active


def all_settings(owner: Any) -> dict[str, Any]:
    """Every setting of a viewport that is a value, those of its parts too."""
    found: dict[str, Any] = {}
    for prop in owner.bl_rna.properties:
        value = getattr(owner, prop.identifier)
        if prop.identifier == "view_matrix":  # that which rotation, location and distance make
            continue
        if prop.identifier in ("shading", "overlay", "region_3d"):
            found |= {f"{prop.identifier}.{k}": v for k, v in all_settings(value).items()}
        elif prop.type != "POINTER" and prop.type != "COLLECTION" and not prop.is_readonly:
            is_plain = isinstance(value, str | int | float | set)
            found[prop.identifier] = value if is_plain else np.array(value).tolist()
    return found


def upset() -> dict[str, Any]:
    """A viewport with settings of its own; all of them."""
    shading, view = space().shading, space().region_3d
    shading.type, shading.light, shading.color_type = "SOLID", "MATCAP", "RANDOM"
    shading.single_color, shading.background_color = (0.2, 0.5, 0.7), (0.1, 0.4, 0.3)
    shading.show_xray, shading.show_cavity, shading.show_object_outline = True, True, True
    view.view_perspective, view.view_distance = "ORTHO", 7.25
    view.view_rotation = (0.5, 0.5, 0.5, 0.5)
    space().overlay.show_overlays, space().show_gizmo = True, True
    hands.redraw()
    return all_settings(space())


def differing(before: dict[str, Any]) -> dict[str, Any]:
    """Settings that are other than before."""
    hands.redraw()  # some are made from others then
    after = all_settings(space())
    return {name: (value, after[name]) for name, value in before.items() if after[name] != value}


def toggle() -> None:
    with hands.override():
        assert bpy.ops.illustrate.toggle_paper("INVOKE_DEFAULT") == {"FINISHED"}


def ink_and_paper(path: pathlib.Path) -> tuple[float, float]:
    """Shares of the 3D view that are dark, and white."""
    seen = hands.pixels(hands.picture(path))
    return float((seen.max(axis=2) < 0.3).mean()), float((seen.min(axis=2) > 0.99).mean())


def the_drawing_is_shown_on_paper(out: pathlib.Path) -> Steps:
    """Strokes, then the live drawing, on white and on the world's colour; then as it was."""
    scene = new_scene()
    hands.show_side_panel(False)
    yield 0.3
    with hands.override():
        bpy.ops.illustrate.illustrate()
    before = upset()
    toggle()
    yield 0.2
    ink, white = ink_and_paper(out / "30_on_paper.png")
    assert 0.002 < ink < 0.2 and white > 0.3, (ink, white)
    hands.manager().illustrate_live = True
    hands.redraw()
    yield lambda: any(s.drawing_of(WHOLE) for s in LIVE.views.values()) and LIVE.is_idle()
    ink, white = ink_and_paper(out / "31_live_on_paper.png")
    assert 0.002 < ink < 0.2 and white > 0.3, (ink, white)
    scene.world = bpy.data.worlds.new("Grey")
    scene.world.color = (0.2, 0.4, 0.6)
    scene.illustrate.paper = "WORLD"
    seen = hands.pixels(hands.picture(out / "32_worlds_paper.png"))
    middle = seen[seen.shape[0] // 2, seen.shape[1] // 2 - 200]
    spread = np.abs(seen - middle).max(axis=2)
    assert (spread < 0.02).mean() > 0.3 and middle.max() < 0.95
    scene.illustrate.paper = "WHITE"
    space().region_3d.view_perspective = "PERSP"
    space().region_3d.view_rotation = (0.8, 0.5, 0.2, 0.2)
    ink, white = ink_and_paper(out / "35_turned_on_paper.png")
    assert 0.001 < ink < 0.1 and white > 0.8, (ink, white)
    hands.manager().illustrate_live = False
    toggle()
    yield 0.2
    assert not differing(before), differing(before)
    hands.picture(out / "33_off_paper.png")


def thin_strokes_are_whole_on_paper(out: pathlib.Path) -> Steps:
    """Far thinner than a pixel they are as grey as the live drawing; under an artist's hand too."""
    scene = new_scene()
    scene.render.resolution_x = scene.render.resolution_y = 2600
    hands.show_side_panel(False)
    yield 0.3
    with hands.override():
        bpy.ops.illustrate.illustrate()
    toggle()
    yield 0.2
    grey = 1 - hands.pixels(hands.picture(out / "36_thin_on_paper.png")).mean()
    (pencil,) = pencils()
    hands.window().view_layer.objects.active = pencil
    with hands.override():
        bpy.ops.object.mode_set(mode=EDIT_PENCIL)
    hands.redraw()
    assert getattr(space(), PENCILS)
    with hands.override():
        bpy.ops.object.mode_set(mode="OBJECT")
    hands.redraw()
    assert getattr(space(), PENCILS) == (not fine_strokes.IS_NEEDED)
    again = 1 - hands.pixels(hands.picture(out / "36_thin_on_paper_again.png")).mean()
    pencil.hide_set(True)
    empty = 1 - hands.pixels(hands.picture(out / "36_nothing_on_paper.png")).mean()
    hands.manager().illustrate_live = True
    hands.redraw()
    yield lambda: any(s.drawing_of(WHOLE) for s in LIVE.views.values()) and LIVE.is_idle()
    live = 1 - hands.pixels(hands.picture(out / "37_thin_and_live.png")).mean()
    print(f"grey of thin strokes: {grey - empty:.4f}, live {live - empty:.4f}", flush=True)
    assert abs(again - grey) < 1e-3
    assert abs(grey - live) < 0.2 * (live - empty)
    hands.manager().illustrate_live = False
    toggle()


def paper_is_left_whatever_happens(out: pathlib.Path) -> Steps:
    """A file saved and loaded, undo, a job that fails, the end of the add-on."""
    scene = new_scene()
    before = upset()
    path = str(out / "paper.blend")
    toggle()
    with hands.override():
        bpy.ops.wm.save_as_mainfile(filepath=path, check_existing=False)
    assert PAPER.is_on(space()) and not space().show_object_viewport_mesh
    with hands.override():
        bpy.ops.ed.undo_push(message="One")
        bpy.data.objects["Suzanne"].location.x += 1
        bpy.ops.ed.undo_push(message="Two")
        bpy.ops.ed.undo()
    yield 0.2
    assert PAPER.is_on(space())
    toggle()
    assert not differing(before), differing(before)
    toggle()
    hands.manager().illustrate_live = True
    for vertex in bpy.data.objects["Suzanne"].data.vertices:
        vertex.co = (float("nan"),) * 3
    bpy.data.objects["Suzanne"].data.update()
    hands.redraw()
    yield lambda: LIVE.problem or LIVE.is_idle()
    hands.manager().illustrate_live = False
    toggle()
    assert not differing(before), differing(before)
    toggle()
    with hands.override():
        bpy.ops.wm.open_mainfile(filepath=path, load_ui=True)
    yield 0.5
    assert not PAPER.is_on_anywhere()
    assert not differing(before), differing(before)
    toggle()
    illustrate.unregister()
    assert not differing(before), differing(before)
    illustrate.register()
    pathlib.Path(path).unlink()
    assert scene is not None and not VIEW.is_on


def paper_is_offered_once(out: pathlib.Path) -> Steps:
    """After the first click in a window; not by scripts."""
    new_scene()
    PAPER.was_offered = False
    yield 0.2
    with hands.override():
        bpy.ops.illustrate.illustrate()
    assert not PAPER.was_offered
    with hands.override():
        bpy.ops.illustrate.illustrate("INVOKE_DEFAULT")
    yield lambda: not tasks.is_running()
    assert PAPER.was_offered
    yield 0.3
    hands.picture(out / "34_offer.png")
    hands.press("ESC")
    yield 0.3
    assert not PAPER.is_on_anywhere()


ALL = [
    the_drawing_is_shown_on_paper,
    thin_strokes_are_whole_on_paper,
    paper_is_left_whatever_happens,
    paper_is_offered_once,
]
