"""Plots from Blender: Export Drawing, presets, the page's overlay."""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree
from typing import Any

import bpy
import illustrate
import numpy as np
import pytest
from illustrate.messages import IllustrateError
from illustrate.plot import plots
from illustrate.plot.plots import PLANNED
from illustrate.plot.settings import KINDS
from illustrate.reading.scene import frame_corners, read_camera
from illustrate.running import illustration
from illustrate.ui import plot_panel, presets
from illustrate.viewport.page_overlay import OVERLAY, on_frame, rectangle
from test_ui import Layout, context

import tools

INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
SHIPPED = ["AxiDraw A4 Pen 0.3", "ISO 128", "Laser", "Screen Print Three Colours"]


def groups(path: pathlib.Path) -> dict[str, Any]:
    """Layers of an SVG by their names."""
    root = ElementTree.parse(path).getroot()
    return {g.get(INKSCAPE + "label", ""): g for g in root if g.tag.endswith("}g")}


def export(path: pathlib.Path, **options: Any) -> None:
    assert bpy.ops.illustrate.export_drawing(filepath=str(path), **options) == {"FINISHED"}


def test_export_writes_the_page_with_a_layer_for_each_pen(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.hidden = True
    path = tmp_path / "cube.svg"
    export(path)
    assert 'width="297mm" height="210mm" viewBox="0 0 297 210"' in path.read_text()
    layers = groups(path)
    assert list(layers) == ["1 Hidden", "2 Hatching", "3 Features"]  # a cube's edges are creases
    scale = 190 / 240  # mm for a pixel: the height of 240 px fits between the margins
    assert layers["3 Features"].get("stroke-width") == f"{1.4 * scale:.3f}"
    assert layers["1 Hidden"].get("stroke") == "#959595"
    assert len(list(tmp_path.iterdir())) == 1
    assert not bpy.data.filepath


def test_own_pens_choose_lines_objects_and_collections(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    ball = tools.add_cube("Ball", (2.5, 0, 0))
    inside = bpy.data.collections.new("Toys")
    scene.collection.children.link(inside)
    inside.objects.link(ball)
    plot = scene.illustrate_plot
    plot.pens_by = "OWN"
    for action in ("ADD", "ADD", "ADD"):
        bpy.ops.illustrate.edit_pens(action=action)
    hatches, toys, rest = plot.pens
    hatches.name, hatches.kinds, hatches.pauses = "Hatching", {"Hatch", "Cross-hatch"}, True
    toys.name, toys.collection, toys.colour = "Toys", inside, (1.0, 0.5, 0.0)
    rest.name, rest.target, rest.is_plotted = "Box", bpy.data.objects["Box"], False
    export(tmp_path / "own.svg")
    layers = groups(tmp_path / "own.svg")
    assert list(layers) == ["!1 Hatching", "2 Toys", "%3 Box"]
    assert layers["2 Toys"].get("stroke") == "#ff8000"


def test_pens_are_moved_and_removed(scene: Any) -> None:
    plot = scene.illustrate_plot
    for _ in range(3):
        bpy.ops.illustrate.edit_pens(action="ADD")
    bpy.ops.illustrate.edit_pens(action="UP")
    bpy.ops.illustrate.edit_pens(action="UP")
    bpy.ops.illustrate.edit_pens(action="UP")
    assert [pen.name for pen in plot.pens] == ["Pen 3", "Pen 1", "Pen 2"]
    bpy.ops.illustrate.edit_pens(action="DOWN")
    bpy.ops.illustrate.edit_pens(action="REMOVE")
    assert [pen.name for pen in plot.pens] == ["Pen 1", "Pen 2"]
    assert plot.active_pen == 1


def test_at_scale_a_metre_is_twenty_millimetres(scene: Any, tmp_path: Any) -> None:
    tools.add_camera(scene, (0, 0, 10), (400, 300), type="ORTHO", ortho_scale=8.0)
    bpy.ops.mesh.primitive_plane_add(size=4.0)
    plot = scene.illustrate_plot
    plot.fit, plot.scale, plot.pens_by = "scale", 50.0, "ONE"
    scene.illustrate.hatching = False
    export(tmp_path / "plan.svg")
    [layer] = groups(tmp_path / "plan.svg").values()
    start = [tuple(map(float, re.findall(r"[-.\d]+", p.get("d"))[:2])) for p in layer]
    assert all(min(abs(x - 108.5), abs(x - 188.5)) < 0.01 for x, _ in start)  # 4 m are 80 mm
    assert all(min(abs(y - 65), abs(y - 145)) < 0.01 for _, y in start)


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        ({"margins_mm": (150, 10, 150, 10)}, "no room between its margins"),
        ({"fit": "scale"}, "orthographic"),
        ({"pens_by": "OWN"}, "no pens"),
        ({"pens_by": "ONE", "pen_width_mm": 0.0}, "no width"),
    ],
)
def test_what_cannot_be_plotted_writes_nothing(
    scene: Any, tmp_path: Any, spoil: dict[str, Any], words: str
) -> None:
    tools.cube_scene(scene)
    for name, value in spoil.items():
        setattr(scene.illustrate_plot, name, value)
    with pytest.raises(RuntimeError, match=words):
        export(tmp_path / "cube.svg")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        ({"margins_mm": (150, 10, 150, 10)}, "no room between its margins"),
        ({"pens_by": "OWN"}, "no pens"),
        ({"pens_by": "ONE", "pen_width_mm": 0.0}, "no width"),
    ],
)
def test_it_is_said_once_before_any_frame_is_drawn(
    scene: Any, tmp_path: Any, spoil: dict[str, Any], words: str, capsys: Any
) -> None:
    tools.cube_scene(scene)
    for name, value in spoil.items():
        setattr(scene.illustrate_plot, name, value)
    out = tmp_path / "out"
    assert illustrate.headless.main(["--out", str(out), "--frames", "1-3", "--plot", "scene"]) == 1
    assert capsys.readouterr().err.count(words) == 1
    assert not out.exists()


def test_a_pen_without_strokes_is_said_and_has_no_layer(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    plot = scene.illustrate_plot
    plot.pens_by = "OWN"
    for name, kinds in (("Valleys", {"Valley"}), ("Rest", set())):
        bpy.ops.illustrate.edit_pens(action="ADD")
        plot.pens[-1].name, plot.pens[-1].kinds = name, kinds
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    assert plots.plot_of(scene, made).warnings == (
        "pen 'Valleys' has nothing to draw: there is no layer of it",
    )
    export(tmp_path / "cube.svg")
    assert list(groups(tmp_path / "cube.svg")) == ["2 Rest"]
    plot.pens.remove(1)
    with pytest.raises(RuntimeError, match="there is nothing to plot"):
        export(tmp_path / "none.svg")
    assert [path.name for path in tmp_path.iterdir()] == ["cube.svg"]


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("cube.png", "'png' is no format of plots"),
        ("cube.pdf", "pypdf, which is not there: install it with"),
        ("cube.dxf", "ezdxf, which is not there: install it with"),
    ],
)
def test_other_formats_and_missing_libraries_are_said_before_drawing(
    scene: Any, tmp_path: Any, name: str, words: str, monkeypatch: Any
) -> None:
    tools.cube_scene(scene)
    for library in ("pypdf", "ezdxf"):
        monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(RuntimeError, match=words):
        export(tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_other_millimetres_than_those_of_the_drawing_are_said(scene: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.unit = "MILLIMETRE"
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    width = 320 * 190 / 240
    [warning] = [w for w in plots.plot_of(scene, made).warnings if "Page Width" in w]
    assert f"{width:.1f} mm wide on the page" in warning
    scene.illustrate.page_width_mm = width
    assert not [w for w in plots.plot_of(scene, made).warnings if "Page Width" in w]


def test_regions_are_filled_below_the_lines(scene: Any, tmp_path: Any) -> None:
    pytest.importorskip("shapely", reason="shapely is not installed")
    cube = tools.cube_scene(scene)
    material = bpy.data.materials.new("Red")
    material.diffuse_color = (1.0, 0.0, 0.0, 1.0)
    cube.data.materials.append(material)
    scene.illustrate_plot.fill_regions = True
    export(tmp_path / "cube.svg")
    layers = groups(tmp_path / "cube.svg")
    assert next(iter(layers)) == "%Regions"
    [path] = layers["%Regions"]
    assert (path.get("fill"), path.get(INKSCAPE + "label")) == ("#ff0000", "Box")


def test_regions_without_shapely_are_refused(scene: Any, tmp_path: Any, monkeypatch: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate_plot.fill_regions = True
    monkeypatch.setitem(sys.modules, "shapely", None)
    with pytest.raises(RuntimeError, match="Filling regions needs the Python package shapely"):
        export(tmp_path / "cube.svg")
    assert not list(tmp_path.iterdir())


def test_a_sequence_is_animated_and_goes_back(scene: Any, tmp_path: Any) -> None:
    cube = tools.cube_scene(scene)
    cube.keyframe_insert("location", frame=1)
    cube.location.x = 2
    cube.keyframe_insert("location", frame=3)
    scene.frame_start, scene.frame_end = 1, 3
    scene.frame_set(2)
    export(tmp_path / "move.svg", sequence=True)
    text = (tmp_path / "move.svg").read_text()
    assert [f'id="frame-{i}"' in text for i in (1, 2, 3, 4)] == [True, True, True, False]
    assert 'dur="0.125s"' in text
    assert scene.frame_current == 2
    with pytest.raises(RuntimeError, match="one drawing"):
        export(tmp_path / "move.dxf", sequence=True)


def test_kinds_are_the_groups_of_lines() -> None:
    groups_module = illustrate.native.load_part("line_groups")
    titles = {
        groups_module._TITLES.get(name, name.capitalize()) for name in groups_module._BOTTOM_TO_TOP
    }
    assert set(KINDS) == {*titles, groups_module.HIDDEN}


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_presets_plot(scene: Any, tmp_path: Any, name: str) -> None:
    tools.cube_scene(scene)
    assert presets.titles(presets.PLOT_FOLDER) == SHIPPED
    presets.apply(name, presets.PLOT_FOLDER)
    export(tmp_path / "cube.svg")
    assert groups(tmp_path / "cube.svg")
    with pytest.raises(IllustrateError, match="ISO 128"):
        presets.apply("None such", presets.PLOT_FOLDER)


def test_own_presets_keep_pens(scene: Any, monkeypatch: Any, tmp_path: Any) -> None:
    monkeypatch.setattr(bpy.utils, "user_resource", lambda *_args, **_more: str(tmp_path))
    presets.apply("ISO 128", presets.PLOT_FOLDER)
    values = presets.ILLUSTRATE_OT_add_plot_preset.preset_values.fget(None)
    assert "bpy.context.scene.illustrate_plot.pens" in values
    assert "bpy.context.scene.illustrate_plot.active_pen" not in values
    scene.illustrate_plot.restore_defaults()
    assert not len(scene.illustrate_plot.pens)


def test_the_panels_show_what_counts(scene: Any) -> None:
    class Lists(Layout):
        def template_list(self, _kind: str, _id: str, *data: Any, **_: Any) -> None:
            getattr(data[0], data[1])
            getattr(data[2], data[3])
            self.shown.append(data[1])

        def row(self, **_: object) -> "Lists":
            return Lists(self.shown)

        column = row

        def operator(self, name: str, **more: Any) -> Any:
            Layout.operator(self, name, **more)
            return type("Button", (), {})()

    def shown(kind: Any) -> list[str]:
        found: list[str] = []
        this = type("Panel", (), {"layout": Lists(found), "fields": kind.fields})()
        kind.draw(this, context())
        return found

    plot = scene.illustrate_plot
    page = shown(plot_panel.ILLUSTRATE_PT_plot)
    assert "orientation" in page and "size_mm" not in page and "scale" not in page
    assert page[-1] == "illustrate.export_drawing"
    plot.paper, plot.fit = "OWN", "scale"
    page = shown(plot_panel.ILLUSTRATE_PT_plot)
    assert "orientation" not in page and "size_mm" in page and "scale" in page
    assert "pens" not in shown(plot_panel.ILLUSTRATE_PT_pens)
    plot.pens_by = "OWN"
    bpy.ops.illustrate.edit_pens(action="ADD")
    assert {"pens", "kinds", "target"} <= set(shown(plot_panel.ILLUSTRATE_PT_pens))
    assert "wet_mm" not in shown(plot_panel.ILLUSTRATE_PT_plot_order)


def test_the_overlay_lies_about_the_cameras_frame(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = read_camera(scene, depsgraph)
    found = plots.page_of(scene, camera)
    assert found
    page, placing = found
    corners = frame_corners(scene)
    matrix = camera.projection @ camera.view
    placed = on_frame(rectangle(page.inner), placing, (320, 240), corners)
    clip = np.c_[placed, np.ones(len(placed))] @ matrix.T
    pixels = (clip[:, :2] / clip[:, 3:] * (1, -1) + 1) / 2 * (320, 240)
    width = 277 * 240 / 190  # of the room between the margins, in pixels
    sides = sorted({round(float(x), 2) for x in pixels[:, 0]})
    assert sides == pytest.approx([160 - width / 2, 160 + width / 2], abs=0.02)
    assert sorted({round(float(y)) for y in pixels[:, 1]}) == [0, 240]
    OVERLAY.shows_page = OVERLAY.shows_travel = True
    assert len(OVERLAY.lines(scene, depsgraph)) == 2
    export(tmp_path / "cube.svg")
    assert len(OVERLAY.lines(scene, depsgraph)) == 2 + len(groups(tmp_path / "cube.svg"))
    OVERLAY.shows_page = OVERLAY.shows_travel = False


def test_the_overlay_waits_for_a_page_that_can_be_told(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    OVERLAY.shows_page = True
    scene.illustrate_plot.fit = "lines"  # the page depends on what will be drawn
    PLANNED.remember("", None)
    assert not OVERLAY.lines(scene, depsgraph)
    export(tmp_path / "cube.svg")
    assert len(OVERLAY.lines(scene, depsgraph)) == 2
    scene.illustrate_plot.fit, scene.illustrate_plot.margins_mm = "frame", (999.0,) * 4
    PLANNED.remember("", None)
    assert not OVERLAY.lines(scene, depsgraph)  # the button says what is wrong
    scene.camera = None
    assert not OVERLAY.lines(scene, depsgraph)
    OVERLAY.shows_page = False


def test_the_switches_of_the_overlay() -> None:
    manager = bpy.context.window_manager
    manager.illustrate_show_page = True
    manager.illustrate_show_travel = True
    assert OVERLAY.shows_page and OVERLAY.shows_travel
    manager.illustrate_show_page = manager.illustrate_show_travel = False
    assert OVERLAY._handle is None


def test_times_are_in_words() -> None:
    assert [plots.minutes(s) for s in (0.4, 59.6, 200)] == ["0 s", "1 min 0 s", "3 min 20 s"]
