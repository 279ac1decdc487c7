"""Settings, presets, styles: what the artist chooses and what becomes of it."""

import math
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate import native
from illustrate.running import illustration
from illustrate.running.cache import HATCHES
from illustrate.settings import native_options, styles
from illustrate.settings import scene_settings as settings
from illustrate.ui import panel, presets

import tools

NATIVE = {"PrepareOptions": native_options.PREPARE, "DrawOptions": native_options.DRAW}


def depsgraph() -> Any:
    return bpy.context.evaluated_depsgraph_get()


def option_names(kind: Any) -> set[str]:
    return {name for name in dir(kind) if not name.startswith("_")}


@pytest.mark.parametrize("kind", NATIVE)
def test_settings_mirror_the_native_options(scene: Any, kind: str) -> None:
    scene.illustrate.property_unset("triangle_budget")  # which the tests have their own of
    default = getattr(native.load(), kind)()
    rows = [option.native for option in NATIVE[kind]]
    assert len(rows) == len(set(rows))
    assert set(rows) | (set(native_options.FROM_ELSEWHERE) & option_names(default)) == (
        option_names(default)
    )
    chosen = native_options.values(NATIVE[kind], scene.illustrate, 0.0)
    own = {"cast_shadows": True} if kind == "DrawOptions" else {}  # scenes have lamps
    assert chosen == {name: getattr(default, name) for name in rows} | own
    assert set(native_options.FROM_ELSEWHERE) <= option_names(
        native.load().PrepareOptions()
    ) | option_names(native.load().DrawOptions())


def test_styles_mirror_the_native_ones(scene: Any) -> None:
    default = native.load().ObjectStyle()
    elsewhere = set(native_options.STYLES_FROM_ELSEWHERE)
    assert set(styles.OPTIONS) | elsewhere == option_names(default)
    cube = tools.cube_scene(scene)
    for owner in (cube, scene.collection):
        for name in styles.OPTIONS:
            assert getattr(owner.illustrate, name) == getattr(default, name)
    defaults = native_options.STYLE_DEFAULTS
    assert {n: getattr(default, n) for n in option_names(default)} == defaults
    material, native_material = bpy.data.materials.new("Own"), native.load().MaterialStyle()
    assert native_material.pen == 0 and not material.illustrate_material.own_pen
    for name in option_names(native_material) - {"pen"}:
        assert getattr(material.illustrate_material, name) == getattr(native_material, name)


@pytest.mark.parametrize("kind", NATIVE)
def test_every_setting_reaches_the_native_options(scene: Any, kind: str) -> None:
    chosen = scene.illustrate
    for option in NATIVE[kind]:
        before = native_options.values((option,), chosen, 0.0)[option.native]
        prop = chosen.bl_rna.properties[option.key]
        if prop.type == "BOOLEAN":
            setattr(chosen, option.key, not before)
        elif prop.type == "ENUM":
            others = [item.identifier for item in prop.enum_items if item.identifier != before]
            setattr(chosen, option.key, others[0])
        elif prop.is_array:
            setattr(chosen, option.key, (1.0, 2.0, 3.0))
        else:
            value = getattr(chosen, option.key)
            setattr(chosen, option.key, value + 1 if prop.type == "INT" else value * 0.5 + 0.29)
        after = native_options.values((option,), chosen, 0.0)[option.native]
        assert after != before, option.native
    made = getattr(native.load(), kind)(**native_options.values(NATIVE[kind], chosen, 0.0))
    for name, value in native_options.values(NATIVE[kind], chosen, 0.0).items():
        assert getattr(made, name) == value


def test_numbers_reach_the_native_options_as_they_were_typed(scene: Any) -> None:
    scene.illustrate.highlight_threshold = 0.7
    scene.illustrate.max_turn = math.radians(90)
    values = settings.draw_values(scene.illustrate, 1000)
    assert values["highlight_threshold"] == 0.7
    assert values["max_turn_deg"] == pytest.approx(90, rel=1e-6)
    scene.illustrate.hidden = True
    scene.illustrate.hidden_layers = 3
    assert settings.draw_values(scene.illustrate, 1000)["hidden_lines"] == (1, 3)


def test_millimetres_are_the_same_on_paper_at_any_resolution(scene: Any) -> None:
    chosen = scene.illustrate
    chosen.unit, chosen.page_width_mm, chosen.line_width_mm = "MILLIMETRE", 250.0, 0.5
    assert settings.draw_values(chosen, 1000)["line_width_px"] == pytest.approx(2)
    assert settings.draw_values(chosen, 4000)["line_width_px"] == pytest.approx(8)
    chosen.spacing_mm = 0.01
    assert settings.draw_values(chosen, 1000)["spacing_px"] == 1  # the least there is
    tools.cube_scene(scene)
    chosen.spacing_mm = 1.2
    small = illustration.illustrate(scene, depsgraph())
    scene.render.resolution_percentage = 200
    large = illustration.illustrate(scene, depsgraph())
    assert large.drawing.widths.max() == pytest.approx(2 * small.drawing.widths.max())


def test_twice_the_pixels_give_the_same_strokes(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [True] * 6)
    tools.subdivide(cube)
    chosen = scene.illustrate
    chosen.unit, chosen.page_width_mm, chosen.spacing_mm = "MILLIMETRE", 80.0, 1.5
    chosen.undercut_spacing_mm = 1.0
    small = illustration.illustrate(scene, depsgraph())
    scene.render.resolution_percentage = 200
    chosen.simplify_px *= 2  # in pixels, also here
    large = illustration.illustrate(scene, depsgraph())
    assert len(small.drawing.kinds) >= 20
    for name in ("offsets", "kinds", "points"):
        assert (getattr(large.drawing, name) == getattr(small.drawing, name)).all()


LETTERS = {False: 12, True: 13}
"""That fit beside the values of a side panel as wide as it is at first, and behind switches."""


def test_settings_have_tidy_texts_and_each_is_in_one_panel(scene: Any) -> None:
    properties = scene.illustrate.bl_rna.properties
    fields = set(properties.keys()) - {"rna_type", "name"}
    for name in fields:
        prop = properties[name]
        assert prop.description and not prop.description.endswith(".")
        assert prop.name == prop.name.title()
        assert len(prop.name) <= LETTERS[prop.type == "BOOLEAN"]
        if prop.type == "ENUM":
            assert [item.value for item in prop.enum_items] == list(range(len(prop.enum_items)))
    for owner in (bpy.types.Object, bpy.types.Collection):
        for prop in owner.bl_rna.properties["illustrate"].fixed_type.properties:
            assert prop.identifier in ("rna_type", "name") or prop.description
    shown = [name for each in panel.CLASSES for name in getattr(each, "fields", ())]
    millimetres = {o.key_mm for o in panel.OPTIONS.values() if o.key_mm}
    assert sorted([*shown, *millimetres]) == sorted(fields)
    assert set(panel.NEEDS) | set(panel.NEEDS.values()) <= fields


def test_the_panel_has_few_first_controls_and_closed_panels_below() -> None:
    first, *others = panel.CLASSES
    assert len(first.fields) + 2 <= 7  # with the button and live lines
    assert [each.bl_label for each in others] == [
        "Lines", "Hatching", "Light", "Surface and Field", "Hands On", "Output", "Animation",
    ]  # fmt: skip
    for each in others:
        assert "DEFAULT_CLOSED" in each.bl_options and each.bl_parent_id == first.bl_idname


def shipped() -> list[str]:
    return ["Brush", "Etching", "Facets", "Pens 0.18 0.35 0.7 mm", "Photograph", "Plain",
            "Plotter 0.3 mm", "Silhouette Drawing", "Technical",
            "Topological Picturebook"]  # fmt: skip


def test_ten_presets_are_shipped() -> None:
    assert presets.titles() == shipped()


def state(chosen: Any) -> dict[str, Any]:
    values = {name: getattr(chosen, name) for name in settings.preset_fields()}
    return {n: tuple(v) if hasattr(v, "__len__") and n.endswith("color") else v
            for n, v in values.items() if n != "default_direction"}  # fmt: skip


@pytest.mark.parametrize("name", shipped())
def test_a_shipped_preset_sets_everything_and_draws(scene: Any, name: str) -> None:
    tools.cube_scene(scene)
    choose(name)
    chosen = state(scene.illustrate)
    scene.illustrate.hatching = not scene.illustrate.hatching
    scene.illustrate.speck_px = 77
    scene.illustrate.line_color = (1, 0, 0, 1)
    scene.illustrate.unit = "MILLIMETRE"
    choose(name)
    assert state(scene.illustrate) == chosen
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def choose(name: str) -> None:
    path = presets.find(name)
    assert path
    menu = presets.ILLUSTRATE_MT_presets.bl_idname
    assert bpy.ops.script.execute_preset(filepath=path, menu_idname=menu) == {"FINISHED"}


def test_the_artists_own_preset(scene: Any, tmp_path: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(bpy.utils, "user_resource", lambda *_, **__: str(tmp_path))
    monkeypatch.setattr(bpy.utils, "preset_paths", lambda _folder: [str(tmp_path)])
    scene.illustrate.spacing_px = 13
    scene.illustrate.hatch_color = (0.5, 0.25, 0, 1)
    before = state(scene.illustrate)
    assert bpy.ops.illustrate.add_preset(name="My Own") == {"FINISHED"}
    assert presets.titles()[-1] == "My Own"
    choose("Technical")
    assert scene.illustrate.spacing_px == 8
    choose("My Own")
    assert state(scene.illustrate) == before


def test_settings_are_saved(scene: Any, tmp_path: Any) -> None:
    cube = tools.cube_scene(scene)
    scene.illustrate.spacing_px = 21
    cube.illustrate.use_own = True
    cube.illustrate.width_scale = 3
    path = str(tmp_path / "saved.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    tools.new_file()
    bpy.ops.wm.open_mainfile(filepath=path)
    assert bpy.context.scene.illustrate.spacing_px == 21
    assert bpy.data.objects["Box"].illustrate.width_scale == 3


def test_the_innermost_style_counts(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    outer, inner = (bpy.data.collections.new(name) for name in ("Outer", "Inner"))
    scene.collection.children.link(outer)
    outer.children.link(inner)
    inner.objects.link(cube)
    scene.collection.objects.unlink(cube)
    assert styles.style_of(cube, scene) == {}
    for owner, scale in ((outer, 2), (inner, 3), (cube, 4)):
        owner.illustrate.use_own = True
        owner.illustrate.width_scale = scale
        assert styles.style_of(cube, scene)["width_scale"] == scale
    cube.illustrate.use_own = False
    assert styles.style_of(cube, scene)["width_scale"] == 3


def test_styles_decide_what_is_drawn(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    other = tools.add_cube("Other", (-2.5, 2.5, 0))
    other.illustrate.use_own = True
    kinds = native.load().Kind

    def draw() -> tuple[set[int], set[int], Any]:
        """Objects with lines, objects with hatches, the drawing."""
        made = illustration.illustrate(scene, depsgraph())
        hatches = np.isin(made.drawing.kinds, [int(kinds[name]) for name in HATCHES])
        objects = [made.names[i] for i in made.drawing.objects]
        return (
            {name for name, hatch in zip(objects, hatches, strict=True) if not hatch},
            {name for name, hatch in zip(objects, hatches, strict=True) if hatch},
            made.drawing,
        )

    both = {cube.name, other.name}
    assert draw()[:2] == (both, both)
    other.illustrate.hatching = False
    assert draw()[:2] == (both, {cube.name})
    other.illustrate.hatching, other.illustrate.lines = True, False
    assert draw()[:2] == ({cube.name}, both)
    other.illustrate.lines, other.illustrate.occlude_only = True, True
    assert draw()[:2] == ({cube.name}, {cube.name})
    other.illustrate.occlude_only, other.illustrate.width_scale = False, 3.0
    drawing = draw()[2]
    widest = [drawing.widths[drawing.offsets[i] : drawing.offsets[i + 1]].max()
              for i in range(len(drawing.kinds))]  # fmt: skip
    by_object = [max(w for w, o in zip(widest, drawing.objects, strict=True) if o == k)
                 for k in (0, 1)]  # fmt: skip
    assert by_object[1] == pytest.approx(3 * by_object[0], rel=1e-4)
    other.illustrate.ignore = True
    assert illustration.illustrate(scene, depsgraph()).names == [cube.name]
    cube.illustrate.use_own = cube.illustrate.ignore = True
    assert not bpy.ops.illustrate.illustrate.poll()
