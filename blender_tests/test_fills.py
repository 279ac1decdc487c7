"""What is seen of objects and materials: Grease Pencil fills, masks, and pens by material."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
from typing import Any

import bpy
import illustrate
import numpy as np
import pytest
from blender_render import render_png
from illustrate.output import bake_drawings, fills, sheet_of
from illustrate.plot import areas, plots
from illustrate.running import illustration
from test_headless import headless
from test_plot import export, groups
from test_plot_headless import saved

import tools

SIZE = (320, 240)
COLOURS = {"Red": (1.0, 0.0, 0.0, 1.0), "Blue": (0.0, 0.0, 1.0, 1.0), "Green": (0.0, 1.0, 0.0, 1.0)}


def paint(thing: Any, *names: str) -> None:
    for name in names:
        material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
        material.diffuse_color = COLOURS[name]
        for node in material.node_tree.nodes if material.node_tree else ():  # new in Blender 5
            if node.type == "BSDF_PRINCIPLED":
                node.inputs["Base Color"].default_value = COLOURS[name]
        thing.data.materials.append(material)


def ring_scene(scene: Any) -> Any:
    """Seen from above: a green floor, on it a ring, one half red and one half blue; the ring."""
    eye = tools.add_camera(scene, (0, 0, 10), SIZE, type="ORTHO", ortho_scale=8.0)
    eye.rotation_euler = (0, 0, 0)
    bpy.ops.mesh.primitive_plane_add(size=5.0)
    paint(bpy.context.object, "Green")
    bpy.ops.mesh.primitive_torus_add(major_radius=1.5, minor_radius=0.5, location=(0, 0, 1))
    ring = bpy.context.object
    ring.name = "Ring"
    paint(ring, "Red", "Blue")
    for face in ring.data.polygons:
        face.material_index, face.use_smooth = int(face.center.x > 0), True
    scene.illustrate.fill_regions = True
    scene.illustrate.hatching = False
    return ring


EXPECTED = {
    "Red": np.pi * (2.0**2 - 1.0**2) / 2,
    "Blue": np.pi * (2.0**2 - 1.0**2) / 2,
    "Green": 25 - np.pi * (2.0**2 - 1.0**2),
}
"""Square metres in the picture; a metre is 40 pixels."""


def illustrated(scene: Any) -> Any:
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    return next(thing for thing in scene.objects if thing.type == tools.pencil_type())


@pytest.fixture
def shapely() -> Any:
    return pytest.importorskip("shapely", reason="shapely is not installed")


@pytest.mark.usefixtures("shapely")
def test_fills_have_the_areas_and_holes_of_what_is_seen(scene: Any, tmp_path: Any) -> None:
    ring_scene(scene)
    pencil = illustrated(scene)
    layers = tools.read_pencil(pencil)
    assert next(iter(layers)) == "Fill"
    assert all(stroke["closed"] and not stroke["radii"].any() for stroke in layers["Fill"])
    for layer in pencil.data.layers:
        layer.hide = (layer.name if tools.V3 else layer.info) != "Fill"
    path = str(tmp_path / "fills.png")
    try:
        render_png(path, scene, [pencil])
    except RuntimeError as error:
        pytest.skip(f"this Blender cannot render here: {error}")
    picture = bpy.data.images.load(path)
    pixels = np.array(picture.pixels[:]).reshape(SIZE[1], SIZE[0], -1)[..., :3]
    for name, colour in COLOURS.items():
        found = (np.abs(pixels - colour[:3]).max(axis=2) < 0.5).sum() / 40**2
        assert found == pytest.approx(EXPECTED[name], rel=0.02), name
    assert pixels[120, 160] == pytest.approx([0, 1, 0], abs=0.1)  # the hole


@pytest.mark.usefixtures("shapely")
def test_fills_lie_where_the_areas_are(scene: Any) -> None:
    ring_scene(scene)
    strokes = tools.read_pencil(illustrated(scene))["Fill"]
    polygons = [stroke["points"][:, :2] for stroke in strokes]
    areas_m2 = sorted(abs(np.cross(p, np.roll(p, -1, axis=0)).sum()) / 2 for p in polygons)
    # The floor is one stroke, cut open to the ring, and another one in the hole of the ring.
    expected = [EXPECTED["Red"], EXPECTED["Blue"], np.pi, 25 - np.pi * 4]
    assert areas_m2 == pytest.approx(sorted(expected), rel=0.01)
    heights = np.concatenate([stroke["points"][:, 2] for stroke in strokes])
    assert np.abs(heights).max() < 1e-3  # in the plane of the farthest stroke, the floor's rim


@pytest.mark.usefixtures("shapely")
def test_materials_of_fills_are_kept_and_follow_their_source(scene: Any) -> None:
    ring_scene(scene)
    data = illustrated(scene).data
    found = {name: data.materials[index] for name, index in fills.of_data(data).items()}
    assert set(found) == set(COLOURS)
    for name, material in found.items():
        style = material.grease_pencil
        assert tuple(style.fill_color) == pytest.approx(COLOURS[name])
        assert style.show_fill and not style.show_stroke
    found["Red"].grease_pencil.fill_color = (1, 1, 0, 1)  # the artist's
    bpy.data.materials["Blue"].diffuse_color = (0, 0.5, 1, 1)
    assert illustrated(scene).data == data
    assert tuple(found["Red"].grease_pencil.fill_color) == (1, 1, 0, 1)
    assert tuple(found["Blue"].grease_pencil.fill_color) == (0, 0.5, 1, 1)
    assert len(tools.read_pencil(illustrated(scene))["Fill"]) == 4  # not twice
    scene.illustrate.fill_regions = False
    assert not tools.read_pencil(illustrated(scene)).get("Fill")
    bpy.ops.illustrate.clear()
    assert not [m for m in bpy.data.materials if m.name.startswith("Illustration")]


@pytest.mark.usefixtures("shapely")
def test_bakes_fill_every_frame_and_curves_none(scene: Any) -> None:
    ring_scene(scene)
    scene.frame_start, scene.frame_end = 1, 3
    assert bpy.ops.illustrate.bake() == {"FINISHED"}
    pencil = next(thing for thing in scene.objects if thing.type == tools.pencil_type())
    [layer] = [la for la in pencil.data.layers if (la.name if tools.V3 else la.info) == "Fill"]
    assert [frame.frame_number for frame in layer.frames] == [1, 2, 3]
    assert len(tools.read_pencil(pencil)["Fill"]) == 12
    scene.illustrate.output = "CURVES"
    bpy.ops.illustrate.illustrate()
    assert not [thing for thing in scene.objects if thing.name.endswith("Fill")]


@pytest.mark.usefixtures("shapely")
def test_an_artists_stroke_on_the_layer_of_fills_stays(scene: Any) -> None:
    ring_scene(scene)
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    filled = areas.fills_of(scene, made)
    camera = made.arrays.camera
    sheet = sheet_of(made.drawing, camera, 1, made.names, filled)
    assert sheet.groups[0].inks and len(sheet.groups[0].sizes) == 4
    bake_drawings(scene, [sheet])
    pencil = next(thing for thing in scene.objects if thing.type == tools.pencil_type())
    [layer] = [la for la in pencil.data.layers if (la.name if tools.V3 else la.info) == "Fill"]
    tools.add_artists_stroke(layer, len(pencil.data.materials) - 1)
    assert len(tools.read_pencil(pencil)["Fill"]) == 5
    bpy.ops.illustrate.clear()
    assert len(tools.read_pencil(pencil)["Fill"]) == 1


@pytest.mark.parametrize("act", ["illustrate", "bake"])
def test_without_shapely_nothing_is_drawn(scene: Any, monkeypatch: Any, act: str) -> None:
    ring_scene(scene)
    before = set(bpy.data.objects)
    monkeypatch.setitem(sys.modules, "shapely", None)
    with pytest.raises(
        RuntimeError, match=r"Nothing is filled: .*needs the Python package shapely"
    ):
        getattr(bpy.ops.illustrate, act)()
    assert set(bpy.data.objects) == before


@pytest.mark.usefixtures("shapely")
def test_what_hides_but_is_not_drawn_is_no_area(scene: Any) -> None:
    ring = ring_scene(scene)

    def inks() -> set[str]:
        made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
        return {area.ink for area in areas.fills_of(scene, made)}

    assert inks() == {"Red", "Blue", "Green"}
    ring.illustrate.use_own = ring.illustrate.occlude_only = True
    assert inks() == {"Green"}
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    [floor] = areas.areas_of(scene, made)
    assert floor.region.area / 40**2 == pytest.approx(EXPECTED["Green"], rel=0.01)
    ring.illustrate.occlude_only, ring.illustrate.see_through = False, True
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    [floor] = areas.areas_of(scene, made)
    assert floor.region.area / 40**2 == pytest.approx(25, rel=0.01)


def grey(path: pathlib.Path) -> Any:
    picture = bpy.data.images.load(str(path))
    picture.colorspace_settings.name = "Non-Color"
    assert tuple(picture.size) == SIZE
    return np.array(picture.pixels[:]).reshape(SIZE[1], SIZE[0], -1)[..., 0]


@pytest.mark.usefixtures("shapely")
def test_masks_are_written_beside_the_file(scene: Any, tmp_path: Any) -> None:
    ring_scene(scene)
    scene.illustrate_plot.masks = True
    export(tmp_path / "ring.svg")
    names = {"Red": "Ring Red", "Blue": "Ring Blue", "Green": "Plane"}
    assert {path.name for path in tmp_path.iterdir()} == {
        "ring.svg", *(f"ring_mask_{name}.png" for name in names.values()),
    }  # fmt: skip
    masks = {name: grey(tmp_path / f"ring_mask_{title}.png") for name, title in names.items()}
    for name, mask in masks.items():
        assert mask.sum() / 40**2 == pytest.approx(EXPECTED[name], rel=0.01)
    assert masks["Green"][120, 160] == 1 and masks["Red"][120, 100] == masks["Blue"][120, 220] == 1
    whole = sum(masks.values())
    assert np.abs(whole[22:218, 62:258] - 1).max() < 0.05  # no gaps, nothing twice


@pytest.mark.usefixtures("shapely")
def test_headless_writes_masks_and_fills(scene: Any, tmp_path: Any) -> None:
    ring_scene(scene)
    saved(tmp_path)
    out = tmp_path / "out"
    arguments = ["--frames", "1-2", "--out", str(out), "--format", "svg,blend", "--masks"]
    assert illustrate.headless.main(arguments) == 0
    names = sorted(path.name for path in out.iterdir())
    assert [name for name in names if "mask" in name] == [
        f"shot_000{n}_mask_{title}.png"
        for n in (1, 2)
        for title in ("Plane", "Ring Blue", "Ring Red")
    ]
    bpy.ops.wm.open_mainfile(filepath=str(out / "shot_0002.blend"))
    pencil = next(o for o in bpy.context.scene.objects if o.type == tools.pencil_type())
    assert len(tools.read_pencil(pencil)["Fill"]) == 4


def by_pdftoppm(path: pathlib.Path) -> Any:
    """(240, 320, 3) of the page, in [0, 1], upwards."""
    command = ["pdftoppm", "-r", "50.8", "-singlefile", str(path)]
    data = subprocess.run(command, check=True, capture_output=True).stdout
    pixels = np.frombuffer(data[-SIZE[0] * SIZE[1] * 3 :], np.uint8)
    return pixels.reshape(SIZE[1], SIZE[0], 3)[::-1] / 255


@pytest.mark.usefixtures("shapely")
def test_pdf_png_and_pencil_are_one_picture(scene: Any, tmp_path: Any) -> None:
    """With one width of lines all that differs is where edges are smoothed."""
    pytest.importorskip("pypdf", reason="pypdf is not installed")
    if not shutil.which("pdftoppm"):
        pytest.skip("pdftoppm is not installed")
    ring_scene(scene)
    chosen, plot = scene.illustrate, scene.illustrate_plot
    chosen.line_width_px = chosen.feature_width_px = 3.0
    plot.paper, plot.size_mm, plot.margins_mm = "OWN", (160, 120), (0, 0, 0, 0)  # .5 mm a pixel
    plot.pens_by, plot.pen_width_mm, plot.fill_regions = "ONE", 1.5, True
    assert (
        illustrate.headless.main(["--out", str(tmp_path), "--name", "x", "--format", "pdf,png"])
        == 0
    )
    render_png(str(tmp_path / "pencil.png"), scene, [illustrated(scene)])
    pictures = [by_pdftoppm(tmp_path / "x.pdf")]
    for name in ("x.png", "pencil.png"):
        picture = bpy.data.images.load(str(tmp_path / name))
        pictures.append(np.array(picture.pixels[:]).reshape(SIZE[1], SIZE[0], -1)[..., :3])
    pdf, png, pencil = pictures
    assert (png.max(axis=2) < 0.2).sum() > 1000  # ink
    for other in (pdf, pencil):  # lines of whole pixels may be one to the side
        off = np.abs(blurred(other) - blurred(png)).max(axis=2)
        assert (off > 0.3).mean() < 0.003 and (off > 0.2).mean() < 0.02


def blurred(picture: Any) -> Any:
    """Means over squares of three by three pixels."""
    wide = np.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    rows = [wide[i : i + SIZE[1]] for i in range(3)]
    return sum(row[:, j : j + SIZE[0]] for row in rows for j in range(3)) / 9


def test_pens_choose_materials(scene: Any, tmp_path: Any) -> None:
    ring_scene(scene)
    scene.illustrate.fill_regions = False
    scene.illustrate.hatching = True
    plot = scene.illustrate_plot
    plot.pens_by = "OWN"
    for name in ("Red", "Blue"):
        bpy.ops.illustrate.edit_pens(action="ADD")
        plot.pens[-1].name, plot.pens[-1].material = name, bpy.data.materials[name]
        plot.pens[-1].kinds = {"Hatch", "Cross-hatch"}
    bpy.ops.illustrate.edit_pens(action="ADD")
    plot.pens[-1].name = "Rest"
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    layers = plots.plot_of(scene, made).layers
    assert [layer.pen.name for layer in layers] == ["Red", "Blue", "Rest"]
    middle = plots.plot_of(scene, made).page.width_mm / 2
    for layer, side in zip(layers, (-1, 1), strict=False):
        points = layer.strokes.points[:, 0] - middle
        assert (np.sign(points) == side).mean() > 0.8  # some hatches go on over the border
    export(tmp_path / "pens.svg")
    assert list(groups(tmp_path / "pens.svg")) == ["1 Red", "2 Blue", "3 Rest"]
    ran = headless(saved(tmp_path), "--out", str(tmp_path / "out"), "--plot", "scene")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    [path] = (tmp_path / "out").iterdir()
    assert path.read_text().count("inkscape:label") == 3
    assert groups(path).keys() == groups(tmp_path / "pens.svg").keys()


def test_a_headless_command_without_shapely_says_so_once(
    scene: Any, tmp_path: Any, monkeypatch: Any, capsys: Any
) -> None:
    tools.cube_scene(scene)
    monkeypatch.setitem(sys.modules, "shapely", None)
    out = tmp_path / "out"
    assert illustrate.headless.main(["--out", str(out), "--frames", "1-3", "--masks"]) == 1
    told = capsys.readouterr().err
    assert len(re.findall("shapely", told)) == 2 and "install" in told  # its name, and the command
    assert not out.exists()


def test_the_stamp_tells_whether_areas_are_filled(scene: Any) -> None:
    tools.cube_scene(scene)
    from illustrate.output import stamps

    before = stamps.stamp_of(scene, 200.0, "centerline")
    scene.illustrate.fill_regions = True
    assert json.dumps(stamps.stamp_of(scene, 200.0, "centerline")) != json.dumps(before)
