"""Panels, menus, preferences and translations, drawn into a layout that checks what it is given."""

import contextlib
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import addon_utils
import bpy
import illustrate
import installed
import pytest
from illustrate import preferences
from illustrate.running import problems
from illustrate.settings import styles
from illustrate.ui import menus, panel, style_panel

import tools


class Layout:
    """Takes what a panel draws; wrong names are errors, as Blender would only print them."""

    def __init__(self, shown: list[str]) -> None:
        self.shown = shown

    def row(self, **_: object) -> "Layout":
        return Layout(self.shown)

    column = row

    def prop(self, data: Any, name: str, **_: Any) -> None:
        getattr(data, name)
        self.shown.append(name)

    def operator(self, name: str, **_: Any) -> None:
        group, verb = name.split(".")
        getattr(getattr(bpy.ops, group), verb).get_rna_type()
        self.shown.append(name)

    def label(self, text: str, **_: Any) -> None:
        self.shown.append(text)

    def menu(self, name: str, **_: Any) -> None:
        assert hasattr(bpy.types, name)
        self.shown.append(name)

    def template_icon_view(self, data: Any, name: str, **_: Any) -> None:
        self.prop(data, name)

    def separator(self) -> None:
        pass


def context(**more: Any) -> Any:
    return SimpleNamespace(
        scene=bpy.context.scene,
        view_layer=bpy.context.view_layer,
        window_manager=bpy.context.window_manager,
        preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=1.0)),
        region=SimpleNamespace(width=250),
        mode=bpy.context.mode,
        space_data=SimpleNamespace(as_pointer=lambda: 0),
        **more,
    )


def draw(kind: Any, **more: Any) -> list[str]:
    """What a panel or menu shows."""
    shown: list[str] = []
    this = SimpleNamespace(
        layout=Layout(shown),
        fields=getattr(kind, "fields", ()),
        style=getattr(kind, "style", None),
    )
    kind.draw(this, context(**more))
    return shown


@pytest.mark.parametrize("unit", ["PIXEL", "MILLIMETRE"])
def test_panels_show_their_settings(scene: Any, unit: str) -> None:
    tools.cube_scene(scene)
    chosen = scene.illustrate
    chosen.unit = unit
    shown = {kind.bl_label: draw(kind) for kind in panel.CLASSES}
    assert shown["Illustrate"][0] == "illustrate.illustrate"
    assert ("spacing_mm" if unit == "MILLIMETRE" else "spacing_px") in shown["Illustrate"]
    assert "illustrate_inspect" in shown["Surface and Field"]
    assert "frame_start" not in shown["Animation"]
    chosen.use_scene_range = False
    assert "frame_start" in draw(panel.ILLUSTRATE_PT_animation)
    assert shown["Output"][-1] == "illustrate.clear"


def test_a_problem_is_shown_before_the_click(scene: Any, monkeypatch: Any) -> None:
    cube = tools.cube_scene(scene)
    count = len(draw(panel.ILLUSTRATE_PT_main))
    camera, scene.camera = scene.camera, None
    assert "has no camera" in " ".join(draw(panel.ILLUSTRATE_PT_main))
    assert not bpy.ops.illustrate.illustrate.poll() and not bpy.ops.illustrate.bake.poll()
    scene.camera = camera
    cube.hide_render = True
    assert "add a mesh" in " ".join(draw(panel.ILLUSTRATE_PT_main))
    cube.hide_render = False
    monkeypatch.setattr(problems, "SECONDS_PER_TRIANGLE", 2.0)
    assert '"Box" has 6 faces: the first drawing takes about 24 s' in problems.slowing_problem(
        scene, bpy.context.view_layer
    )
    monkeypatch.undo()
    assert len(draw(panel.ILLUSTRATE_PT_main)) == count
    assert bpy.ops.illustrate.illustrate.poll()


def test_what_is_hidden_cannot_be_drawn(scene: Any) -> None:
    cube, view_layer = tools.cube_scene(scene), bpy.context.view_layer
    inside = bpy.data.collections.new("Inside")
    scene.collection.children.link(inside)
    scene.collection.objects.unlink(cube)
    inside.objects.link(cube)
    layer = view_layer.layer_collection.children["Inside"]
    for owner, name in (
        (cube, "hide_viewport"),
        (cube, "hide_render"),
        (inside, "hide_viewport"),
        (layer, "hide_viewport"),
        (layer, "exclude"),
    ):
        assert not problems.stopping_problem(scene, view_layer)
        setattr(owner, name, True)
        view_layer.update()
        assert problems.stopping_problem(scene, view_layer), (owner, name)
        setattr(owner, name, False)
        view_layer.update()
    cube.hide_set(True)
    assert problems.stopping_problem(scene, view_layer)


def test_what_one_viewport_hides_can_be_drawn(scene: Any) -> None:
    """As the panel asks it, which is drawn in a viewport: that may be on paper."""
    tools.cube_scene(scene)
    view_layer = bpy.context.view_layer
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    space = area.spaces.active
    with bpy.context.temp_override(window=window, area=area):
        space.show_object_viewport_mesh = False
        found = problems.stopping_problem(scene, view_layer)
        space.show_object_viewport_mesh = True
    assert not found


@pytest.mark.parametrize("kind", ["EMPTY", "CURVE", "META"])
def test_what_may_have_faces_is_let_through(scene: Any, kind: str) -> None:
    tools.add_camera(scene)
    assert problems.stopping_problem(scene, bpy.context.view_layer)
    if kind == "EMPTY":
        inside = bpy.data.collections.new("Inside")
        inside.objects.link(tools.add_mesh("Flat", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
        scene.collection.objects.unlink(inside.objects[0])
        owner = bpy.data.objects.new("Owner", None)
        owner.instance_type, owner.instance_collection = "COLLECTION", inside
        scene.collection.objects.link(owner)
    elif kind == "CURVE":
        bpy.ops.curve.primitive_bezier_circle_add()
        bpy.context.object.data.bevel_depth = 0.2
    else:
        bpy.ops.object.metaball_add()
    bpy.context.view_layer.update()
    assert not problems.stopping_problem(scene, bpy.context.view_layer)
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def test_styles_have_panels(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    for kind in style_panel.CLASSES[:2]:
        shown = draw(kind, object=cube, collection=scene.collection)
        assert shown == [*styles.OPTIONS, *styles.SURFACE]
        assert kind.poll(context(object=cube, collection=scene.collection))
        assert not kind.poll(context(object=None, collection=None))


def test_materials_have_a_panel() -> None:
    kind, material = style_panel.ILLUSTRATE_PT_material_style, bpy.data.materials.new("Own")
    assert draw(kind, material=material) == list(kind.fields)
    assert kind.poll(context(material=material))
    assert not kind.poll(context(material=None))


def test_menus_have_an_entry() -> None:
    assert draw(menus.ILLUSTRATE_MT_main) == [
        "illustrate.illustrate", "illustrate.bake", "illustrate.import_frames",
        "illustrate.export_drawing", "illustrate.clear",
    ]  # fmt: skip
    for name in menus.MENUS:
        entries = getattr(bpy.types, name)._dyn_ui_initialize()
        assert menus._entry in entries


@contextlib.contextmanager
def addon(enabled: bool) -> Iterator[str]:
    """The name of the add-on, enabled in the preferences or registered alone; then as it was."""
    name, was_enabled = illustrate.__name__, installed.is_enabled(illustrate)
    switch(name, was_enabled, enabled)
    try:
        yield name
    finally:
        switch(name, enabled, was_enabled)


def switch(name: str, is_enabled: bool, enabled: bool) -> None:
    if is_enabled == enabled:
        return
    if is_enabled:
        addon_utils.disable(name, default_set=True)
        illustrate.register()
    else:
        illustrate.unregister()
        assert addon_utils.enable(name, default_set=True) is not None


def test_preferences_have_defaults_where_the_addon_has_none() -> None:
    with addon(enabled=False) as name:
        assert name not in bpy.context.preferences.addons
        for setting, value in preferences.DEFAULTS.items():
            assert preferences.preference(setting) == value


def test_preferences_count_where_the_addon_has_them() -> None:
    with addon(enabled=True) as name:
        own = bpy.context.preferences.addons[name].preferences
        own.live_triangles = 5_000
        assert preferences.preference("live_triangles") == 5_000
        for setting, value in preferences.DEFAULTS.items():
            setattr(own, setting, value)
