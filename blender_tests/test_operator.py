"""The button: what it makes, what it replaces, what it says."""

from typing import Any

import bpy
import pytest

import tools


def click() -> None:
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def pencils() -> list[Any]:
    return [thing for thing in bpy.data.objects if thing.type == tools.pencil_type()]


def test_first_click_makes_one_grease_pencil_object(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    assert [thing.name for thing in pencils()] == ["Illustration"]
    layers = tools.read_pencil(pencils()[0])
    assert "Silhouette" in layers or "Crease" in layers
    assert all(layers.values())


def test_second_click_replaces_the_first(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    click()
    first, before = tools.read_pencil(pencils()[0]), tools.snapshot()
    click()
    assert tools.snapshot() == before
    again = tools.read_pencil(pencils()[0])
    assert {k: len(v) for k, v in again.items()} == {k: len(v) for k, v in first.items()}
    cube.location.x += 0.5
    click()
    moved = tools.read_pencil(pencils()[0])
    name = next(name for name in first if first[name])
    assert len(pencils()) == 1
    assert moved[name][0]["points"].tolist() != first[name][0]["points"].tolist()


def test_second_click_on_another_frame_leaves_one_drawing(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    count = {k: len(v) for k, v in tools.read_pencil(pencils()[0]).items()}
    scene.frame_set(10)
    click()
    assert {k: len(v) for k, v in tools.read_pencil(pencils()[0]).items()} == count
    assert {f.frame_number for layer in pencils()[0].data.layers for f in layer.frames} == {10}


def test_artists_work_in_the_illustration_stays(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    data = pencils()[0].data
    own = data.layers.new("Notes")
    tools.add_artists_stroke(own)
    ours = next(layer for layer in data.layers if layer != own)
    tools.add_artists_stroke(ours)
    ours.opacity = 0.5
    count = {k: len(v) for k, v in tools.read_pencil(pencils()[0]).items()}
    click()
    layers = tools.read_pencil(pencils()[0])
    assert {k: len(v) for k, v in layers.items()} == count
    assert sum(tools.is_artists(s) for strokes in layers.values() for s in strokes) == 2
    assert ours.opacity == pytest.approx(0.5)


def test_artists_own_illustration_stays(scene: Any) -> None:
    tools.cube_scene(scene)
    store = bpy.data.grease_pencils
    if tools.V3 and hasattr(bpy.data, "grease_pencils_v3"):
        store = bpy.data.grease_pencils_v3
    data = store.new("Illustration")
    theirs = bpy.data.objects.new("Illustration", data)
    scene.collection.objects.link(theirs)
    tools.add_artists_stroke(data.layers.new("Silhouette"))
    click()
    click()
    assert len(pencils()) == 2
    assert [len(v) for v in tools.read_pencil(theirs).values()] == [1]


def test_a_deleted_illustration_is_made_again(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    bpy.data.objects.remove(pencils()[0])
    click()
    assert len(pencils()) == 1


def test_change_of_output_takes_the_other_away(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    scene.illustrate.output = "CURVES"
    click()
    assert not pencils()
    curves = [thing.name for thing in scene.objects if thing.type == "CURVE"]
    assert curves
    assert all(name.startswith("Illustration ") for name in curves)
    click()
    assert [thing.name for thing in scene.objects if thing.type == "CURVE"] == curves
    scene.illustrate.output = "GREASE_PENCIL"
    click()
    assert not [thing for thing in bpy.data.objects if thing.type == "CURVE"]
    assert not bpy.data.curves and "Illustration" not in bpy.data.collections


def test_change_of_output_keeps_the_artists_strokes(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    tools.add_artists_stroke(pencils()[0].data.layers.new("Notes"))
    scene.illustrate.output = "CURVES"
    click()
    assert {k: len(v) for k, v in tools.read_pencil(pencils()[0]).items()} == {"Notes": 1}


def test_only_the_selection_is_drawn(scene: Any) -> None:
    tools.cube_scene(scene)
    other = tools.add_cube("Other", (2.5, 0, 0))
    scene.illustrate.source = "SELECTION"
    for thing in scene.objects:
        thing.select_set(thing == other)
    click()
    points = [s["points"] for v in tools.read_pencil(pencils()[0]).values() for s in v]
    assert min(p[:, 0].min() for p in points) > 1.4


def test_says_what_it_did(scene: Any, capfd: Any) -> None:
    tools.cube_scene(scene)
    click()
    tools.flush()
    assert "Illustrated 1 object: " in capfd.readouterr().out


def test_warns_of_mended_and_skipped_meshes(scene: Any, capfd: Any) -> None:
    cube = tools.cube_scene(scene)
    broken = tools.add_cube("Broken", (-2.5, 0, 0))
    broken.data.vertices[0].co.x = float("nan")
    tools.add_mesh("Cloud", [(0, 0, 0), (1, 0, 0)], [])
    click()
    tools.flush()
    said = capfd.readouterr().out
    assert 'Mended 1 mesh, "Broken": 1 vertices that are not finite' in said
    assert 'Left out 1 object without faces ("Cloud")' in said
    assert cube.name not in said
    points = [s["points"] for v in tools.read_pencil(pencils()[0]).values() for s in v]
    assert min(p[:, 0].min() for p in points) < -3.4


def test_settings_reach_the_drawing(scene: Any) -> None:
    tools.cube_scene(scene)
    click()
    hatching = {"Hatch", "Cross-hatch", "Undercut"}
    assert hatching & tools.read_pencil(pencils()[0]).keys()
    scene.illustrate.hatching = False
    click()
    layers = tools.read_pencil(pencils()[0])
    assert not any(layers.get(name) for name in hatching)
    assert any(layers.values())


def test_tones_go_by_brightness_or_by_area(scene: Any) -> None:
    from illustrate.settings import scene_settings as settings

    chosen = scene.illustrate
    chosen.highlight_share, chosen.shadow_threshold = 0.2, 0.3
    by_light = settings.draw_values(chosen, 1000)
    assert by_light["highlight_share"] is None and by_light["shadow_threshold"] == 0.3
    chosen.tones = "AREA"
    assert settings.draw_values(chosen, 1000)["highlight_share"] == 0.2


def test_light_comes_from_where_it_is_set_to(scene: Any) -> None:
    from illustrate.running.illustration import illustrate

    tools.cube_scene(scene)
    lamp = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "SUN"))
    lamp.rotation_euler.x = 2.0
    scene.collection.objects.link(lamp)
    drawn = []
    for lighting in ("SCENE", "HEADLIGHT", "SIDE"):
        scene.illustrate.lighting = lighting
        tone = illustrate(scene, bpy.context.evaluated_depsgraph_get()).drawing.tone
        drawn.append(tone.brightness.tobytes())
    assert len(set(drawn)) == 3


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        ("no camera", ['"Scene"', "no camera", "add one"]),
        ("not a camera", ['"Box"', "not a camera"]),
        ("panoramic", ['"Eye"', "panoramic", "Perspective or Orthographic"]),
        ("flat camera", ['"Eye"', "scale"]),
        ("no mesh", ['"Scene"', "can be drawn", "add a mesh"]),
        ("no faces", ['"Cloud"', "no faces"]),
        ("nothing selected", ["selected", '"Scene"', "set Draw to Scene"]),
    ],
)
def test_an_error_names_the_way_out_and_changes_nothing(
    scene: Any, spoil: str, words: list[str]
) -> None:
    cube = tools.cube_scene(scene)
    if spoil == "no camera":
        scene.camera = None
    elif spoil == "not a camera":
        scene.camera = cube
    elif spoil == "panoramic":
        scene.camera.data.type = "PANO"
    elif spoil == "flat camera":
        scene.camera.scale = (0, 0, 0)
    elif spoil == "nothing selected":
        scene.illustrate.source = "SELECTION"
        cube.select_set(False)
    else:
        bpy.data.meshes.remove(cube.data)
    if spoil == "no faces":
        tools.add_mesh("Cloud", [(0, 0, 0), (1, 0, 0)], [])
    bpy.context.view_layer.update()
    before = tools.snapshot()
    with pytest.raises(RuntimeError) as error:
        bpy.ops.illustrate.illustrate()
    for word in words:
        assert word in str(error.value)
    assert tools.snapshot() == before


def test_a_missing_native_module_is_explained(scene: Any, monkeypatch: Any, tmp_path: Any) -> None:
    import importlib
    import sys

    from illustrate import native

    tools.cube_scene(scene)
    native.load.cache_clear()
    for name in [n for n in sys.modules if n.partition(".")[0] == native.NAME]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(native, "__file__", str(tmp_path / "native.py"))
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    importlib.invalidate_caches()
    with pytest.raises(RuntimeError, match="native module of Illustrate is missing"):
        bpy.ops.illustrate.illustrate()


def test_registers_again_after_unregister(scene: Any) -> None:
    import illustrate

    def classes() -> set[str]:
        return {name for name in dir(bpy.types) if name.startswith("ILLUSTRATE_")}

    before = classes()
    assert {"ILLUSTRATE_OT_illustrate", "ILLUSTRATE_PT_main"} <= before
    illustrate.unregister()
    assert not classes()
    assert not hasattr(scene, "illustrate")
    illustrate.register()
    assert classes() == before
