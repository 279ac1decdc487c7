"""Hands on the drawing: picking, hiding, guides and singularities, and the gallery of presets."""

import pathlib
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate import output
from illustrate.messages import IllustrateError
from illustrate.output.hiding import hide_stroke
from illustrate.running import illustration
from illustrate.ui import gallery, panel, presets
from illustrate.viewport.guiding import hold_singularities, joined
from illustrate.viewport.hidden_strokes import hidden_in, hide_in, name_of
from illustrate.viewport.inspect import INSPECTOR
from illustrate.viewport.live import LIVE, WHOLE
from illustrate.viewport.live_strokes import inks_of, strokes_as_ribbons
from illustrate.viewport.pick import PICKER, nearest, thing_of
from test_live import drawn
from test_ui import draw

import tools

SIZE = (320, 240)


@pytest.fixture(autouse=True)
def _nothing_is_picked() -> Any:
    PICKER.picked = None
    LIVE.forget()
    yield
    PICKER.picked = None
    LIVE.forget()


def made_cube(scene: Any) -> Any:
    """Fine, so that first segments of hidden lines are not halfway along, behind others."""
    tools.cube_scene(scene)
    scene.illustrate.property_unset("triangle_budget")
    scene.illustrate.hidden = True
    bpy.ops.illustrate.illustrate()
    return INSPECTOR.made


def pick_at(made: Any, number: Any, without: Any = ()) -> Any:
    """What is picked in the middle of a stroke's first segment."""
    drawing, camera = made.drawing, made.arrays.camera
    first = drawing.offsets[number]
    x, y = drawing.image[first : first + 2].mean(axis=0)
    matrix = camera.projection @ camera.view
    return nearest(drawing, made.names, matrix, SIZE, (x, SIZE[1] - y), without)


def test_every_visible_line_is_picked_where_it_is(scene: Any) -> None:
    made = made_cube(scene)
    drawing = made.drawing
    for number in np.flatnonzero(np.asarray(drawing.invisibility) == 0):
        picked = pick_at(made, int(number))
        assert picked is not None and picked.thing == "Box" and picked.layers == 0
    camera = made.arrays.camera
    matrix = camera.projection @ camera.view
    assert nearest(drawing, made.names, matrix, SIZE, (2, 2)) is None


def test_hidden_lines_are_picked_where_no_other_is(scene: Any) -> None:
    scene.illustrate.hatching = False
    made = made_cube(scene)
    hidden = np.flatnonzero(np.asarray(made.drawing.invisibility) > 0)
    picked = [pick_at(made, int(number)) for number in hidden]
    assert any(p is not None and p.layers == 1 and p.kind == "CREASE" for p in picked)


def seen_strokes() -> int:
    thing = next(t for t in bpy.data.objects if t.type == tools.pencil_type())
    count = 0
    for layer in thing.data.layers:
        for frame in layer.frames:
            is_full = tools.V3 and frame.drawing.attributes.get("opacity") is None
            for stroke in frame.drawing.strokes if tools.V3 else frame.strokes:
                name = "opacity" if tools.V3 else "strength"
                count += is_full or any(getattr(point, name) > 0 for point in stroke.points)
    return count


def test_a_stroke_is_hidden_and_no_other(scene: Any) -> None:
    made = made_cube(scene)
    drawing, before = made.drawing, seen_strokes()
    assert before == len(drawing.kinds)
    for number in (0, len(drawing.kinds) - 1):
        PICKER.picked = pick_at(made, int(number))
        points = drawing.points[drawing.offsets[number] : drawing.offsets[number + 1]]
        assert hide_stroke(scene, points)
    assert seen_strokes() == before - 2
    assert not hide_stroke(scene, drawing.points[:3] + 100)
    output.clear(scene)
    assert not hide_stroke(scene, drawing.points[:3])


def corners_of_ribbons(scene: Any, seen: Any) -> int:
    """Corners of what is shown of the lines of a live drawing."""
    drawing = seen.made[WHOLE].drawing
    hidden = hidden_in(scene, drawing)
    return len(
        strokes_as_ribbons(
            drawing, seen.view, inks_of(scene.illustrate), False, None, hidden
        ).points
    )


def test_a_stroke_of_the_live_drawing_is_hidden_and_kept_so(scene: Any) -> None:
    tools.cube_scene(scene)
    seen = drawn()
    made, before = seen.made[WHOLE], corners_of_ribbons(scene, seen)
    assert made is not None
    lines = np.flatnonzero((made.drawing.kinds < 4) & (made.drawing.invisibility == 0))
    PICKER.picked = first = pick_at(made, int(lines[0]))
    assert bpy.ops.illustrate.hide_stroke() == {"FINISHED"}
    assert hidden_in(scene, made.drawing) == [first.number]
    assert corners_of_ribbons(scene, seen) < before
    again = pick_at(made, int(lines[0]), hidden_in(scene, made.drawing))
    assert again is None or again.number != first.number
    assert bpy.ops.illustrate.keep_live() == {"FINISHED"}
    assert seen_strokes() == len(made.drawing.kinds) - 1


def test_curves_have_no_hidden_strokes(scene: Any, capfd: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.output = "CURVES"
    drawing = drawn().made[WHOLE].drawing
    hide_in(scene, name_of(drawing), 0, {name_of(drawing)})
    assert bpy.ops.illustrate.keep_live() == {"FINISHED"}
    tools.flush()
    assert "hidden strokes are there again" in capfd.readouterr().out


def test_another_drawing_has_all_its_strokes(scene: Any) -> None:
    tools.cube_scene(scene)
    first = drawn().made[WHOLE].drawing
    hide_in(scene, name_of(first), 3, {name_of(first)})
    scene.illustrate.spacing_px *= 2
    second = drawn().made[WHOLE].drawing
    assert hidden_in(scene, first) == [3] and hidden_in(scene, second) == []
    scene.illustrate.spacing_px /= 2
    assert hidden_in(scene, drawn().made[WHOLE].drawing) == [3], "made again it is the same"
    hide_in(scene, name_of(second), 1, {name_of(second)})
    assert hidden_in(scene, first) == [], "nobody sees it any more"


def test_the_hatches_of_an_object_go(scene: Any) -> None:
    made = made_cube(scene)
    PICKER.picked = pick_at(made, 0)
    assert thing_of(scene).name == "Box"
    assert bpy.ops.illustrate.hide_hatches() == {"FINISHED"}
    assert not scene.objects["Box"].illustrate.hatching
    assert not {4, 5, 6} & set(INSPECTOR.made.drawing.kinds.tolist())
    assert not bpy.ops.illustrate.hide_hatches.poll()


def test_the_panel_says_what_is_picked_and_the_operator_hides_it(scene: Any) -> None:
    scene.illustrate.hatching = False
    made = made_cube(scene)
    assert "illustrate.hide_stroke" not in draw(panel.ILLUSTRATE_PT_hands)
    picked = [pick_at(made, int(n)) for n in np.flatnonzero(made.drawing.invisibility)]
    PICKER.picked = next(p for p in picked if p is not None and p.layers == 1)
    shown = draw(panel.ILLUSTRATE_PT_hands)
    assert {"illustrate.hide_stroke", "illustrate.hide_hatches", "use_own"} <= set(shown)
    assert " of Box, behind 1 surface" in " ".join(shown)
    before = seen_strokes()
    assert bpy.ops.illustrate.hide_stroke() == {"FINISHED"}
    assert seen_strokes() == before - 1
    assert not bpy.ops.illustrate.hide_stroke.poll()


def test_what_was_picked_may_be_gone(scene: Any) -> None:
    PICKER.picked = pick_at(made_cube(scene), 0)
    output.clear(scene)
    with pytest.raises(RuntimeError, match="no such stroke: press Keep or Illustrate"):
        bpy.ops.illustrate.hide_stroke()
    scene.camera = None  # the hatches go with the next drawing that can be made
    assert bpy.ops.illustrate.hide_hatches() == {"FINISHED"}
    assert not scene.objects["Box"].illustrate.hatching
    PICKER.picked = pick_at(INSPECTOR.made, 0)
    bpy.data.objects.remove(scene.objects["Box"])
    with pytest.raises(RuntimeError, match="is gone: draw anew"):
        bpy.ops.illustrate.hide_hatches()


def test_held_singularities_lead_the_hatches(scene: Any) -> None:
    tools.add_camera(scene)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=12)
    bpy.ops.object.shade_smooth()
    bpy.ops.illustrate.illustrate()
    assert bpy.ops.illustrate.hold_singularities() == {"FINISHED"}
    guides = scene.illustrate.guides
    assert sum(thing.illustrate_guide.turns for thing in guides.objects) == 8
    assert not bpy.ops.illustrate.hold_singularities.poll()
    moved = guides.objects[0]
    moved.location = (0.6, -0.6, 0.529)
    bpy.context.view_layer.update()
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    places = np.asarray(made.prepared.field.singular_positions)
    assert np.linalg.norm(places - np.array(moved.location), axis=1).min() < 0.15


def test_singularities_too_near_to_be_kept_apart_are_one() -> None:
    places = [[0, 0, 0], [0.1, 0, 0], [5, 0, 0], [5.1, 0, 0], [9, 0, 0]]
    kept, turns = joined(places, [1, -1, 1, 1, -1], 0.5)
    assert turns.tolist() == [2, -1] and kept[:, 0].tolist() == [5, 9]
    kept, turns = joined(places, [1, -1, 1, 1, -1], 0.01)
    assert len(turns) == 5 and turns.sum() == 1


def test_a_field_without_singularities_says_so(scene: Any) -> None:
    class Field:
        singular_positions, singular_indices = np.zeros((0, 3)), np.zeros(0, int)

    with pytest.raises(IllustrateError, match="no singularities"):
        hold_singularities(scene, Field())


def test_guides_are_drawn_among_the_guides(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    objects = bpy.context.view_layer.objects
    objects.active = cube
    for _ in range(2):  # the second time into the same one
        assert bpy.ops.illustrate.draw_guide() == {"FINISHED"}
        active = objects.active
        assert active.type == tools.pencil_type() and active.mode.startswith("PAINT")
        assert list(scene.illustrate.guides.objects) == [active]
        assert bpy.ops.illustrate.draw_guide() == {"FINISHED"}
        assert objects.active == cube and bpy.context.mode == "OBJECT"
    bpy.ops.object.mode_set(mode="EDIT")
    assert not bpy.ops.illustrate.draw_guide.poll()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_the_object_before_a_guide_may_be_gone(scene: Any) -> None:
    bpy.context.view_layer.objects.active = tools.cube_scene(scene)
    bpy.ops.illustrate.draw_guide()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    assert bpy.ops.illustrate.draw_guide() == {"FINISHED"}
    assert bpy.context.mode == "OBJECT"


def test_every_preset_has_a_small_picture() -> None:
    shown = {path.stem for path in gallery.pictures().values()}
    files = pathlib.Path(presets.shipped_folder())
    assert shown == {path.stem for path in files.glob("*.py")} and len(shown) >= 5
    for path in gallery.pictures().values():
        data = path.read_bytes()
        assert data.startswith(b"\x89PNG") and len(data) < 20_000


def test_the_gallery_applies_presets(scene: Any) -> None:
    manager = bpy.context.window_manager
    names = list(gallery.pictures())
    gallery._listed(manager, bpy.context)
    gallery._choose(manager, names.index("Silhouette_Drawing"))
    assert not scene.illustrate.hatching
    assert manager.illustrate_gallery == "Silhouette_Drawing"
    gallery._choose(manager, names.index("Etching"))
    assert scene.illustrate.hatching and scene.illustrate.spacing_px == 4.5
