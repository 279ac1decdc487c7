"""What the add-on wrote, and what the artist made beside it."""

import json
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate import output
from illustrate.output import write_drawing
from illustrate.running import illustration

import tools


def click() -> None:
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}


def pencil_data() -> Any:
    return next(t for t in bpy.data.objects if t.type == tools.pencil_type()).data


def layer_names(data: Any) -> list[str]:
    return [layer.name if tools.V3 else layer.info for layer in data.layers]


def hidden_scene(scene: Any) -> Any:
    """A cube behind another, with all kinds of strokes; what was drawn."""
    tools.cube_scene(scene)
    tools.add_cube("Other", (-2.5, 2.5, 0))
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, location=(2, -1, 1.5))
    ball = bpy.context.object
    ball.data.polygons.foreach_set("use_smooth", [True] * len(ball.data.polygons))
    scene.illustrate.hidden = True
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


def triples(drawing: Any) -> list[tuple[int, int, int]]:
    return sorted(
        zip(
            drawing.kinds.tolist(),
            drawing.objects.tolist(),
            drawing.invisibility.tolist(),
            strict=True,
        )
    )


def test_strokes_of_grease_pencil_know_what_they_are(scene: Any) -> None:
    made = hidden_scene(scene)
    click()
    found: list[tuple[int, int, int]] = []
    data = pencil_data()
    for layer in data.layers:
        if tools.V3:
            attributes = layer.frames[0].drawing.attributes
            columns = [
                [v.value for v in attributes[f"illustrate_{name}"].data]
                for name in ("kind", "object", "invisibility")
            ]
            found += [(k - 1, o, i) for k, o, i in zip(*columns, strict=True)]
        else:
            told = np.array(data["illustrate_strokes"][f"{layer.info} 1"]).reshape(-1, 3)
            assert len(told) == len(layer.frames[0].strokes)
            found += map(tuple, told.tolist())
    assert sorted(found) == triples(made.drawing)
    assert json.loads(data["illustrate_objects"]) == made.names


def test_strokes_of_curves_know_what_they_are(scene: Any) -> None:
    made = hidden_scene(scene)
    scene.illustrate.output = "CURVES"
    click()
    found: list[tuple[int, int, int]] = []
    for thing in scene.objects:
        if thing.type == "CURVE":
            curve = thing.data
            columns = [list(curve[f"illustrate_{n}"]) for n in ("kinds", "of", "invisibility")]
            assert len(columns[0]) == len(curve.splines)
            found += zip(*columns, strict=True)
            assert json.loads(curve["illustrate_objects"]) == made.names
    assert sorted(found) == triples(made.drawing)


def test_layers_lie_in_order_in_a_group_whenever_they_are_made(scene: Any) -> None:
    hidden_scene(scene)
    scene.illustrate.hatching = False
    scene.illustrate.hidden = False
    click()
    scene.illustrate.hatching = scene.illustrate.hidden = True
    click()
    names = layer_names(pencil_data())
    late = [n for n in ("Hidden", "Undercut", "Cross-hatch", "Hatch", "Crease", "Silhouette")
            if n in names]  # fmt: skip
    assert [name for name in names if name in late] == late and len(late) >= 4
    if tools.V3:
        groups = {layer.parent_group.name for layer in pencil_data().layers}
        assert groups == {"Illustration"}


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
def test_a_pen_has_the_colour_of_the_settings_until_the_artist_paints(
    scene: Any, target: str
) -> None:
    hidden_scene(scene)
    chosen = scene.illustrate
    chosen.output, chosen.hatch_color = target, (0, 0, 1, 1)
    click()
    things = [t for t in scene.objects if t.name.startswith("Illustration")]
    inks = {m["illustrate_pen"]: m for t in things for m in t.data.materials}
    assert set(inks) == {"Line", "Feature", "Hatch", "Hidden"}

    def ink(pen: str) -> Any:
        pencil = inks[pen].grease_pencil if target == "GREASE_PENCIL" else None
        return tuple(pencil.color if pencil else inks[pen].diffuse_color)

    assert ink("Hatch") == (0, 0, 1, 1) and ink("Line") == (0, 0, 0, 1)
    chosen.line_color = (1, 0, 0, 1)
    assert ink("Line") == (1, 0, 0, 1)
    if target == "GREASE_PENCIL":
        inks["Hatch"].grease_pencil.color = (0, 1, 0, 1)
        click()
        assert ink("Hatch") == (0, 1, 0, 1)
    assert all(thing.show_in_front for thing in things)
    chosen.in_front = False
    assert not any(thing.show_in_front for thing in things)


def artists_work() -> dict[str, Any]:
    """A stroke and a keyframe in a layer of the add-on, a layer, a material; what they are."""
    data = pencil_data()
    theirs = bpy.data.materials.new("Red")
    bpy.data.materials.create_gpencil_data(theirs)
    theirs.grease_pencil.color = (1, 0, 0, 1)
    data.materials.append(theirs)
    index = len(data.materials) - 1
    own = data.layers.new("Notes")
    tools.add_artists_stroke(own, index)
    ours = next(layer for layer in data.layers if layer != own)
    tools.add_artists_stroke(ours, index)
    ours.frames.new(7)
    tools.add_artists_stroke_at(ours, 7)
    ours.opacity, own.opacity = 0.5, 0.25
    names = layer_names(data)
    return {"index": index, "layers": [names[data.layers[:].index(x)] for x in (ours, own)]}


def read_work(work: dict[str, Any]) -> Any:
    data = pencil_data()
    material = data.materials[work["index"]]
    layers = [data.layers[layer_names(data).index(name)] for name in work["layers"]]
    return (
        material.name,
        tuple(material.grease_pencil.color),
        [layer.opacity for layer in layers],
        [tools.artists_bytes(layer) for layer in layers],
        layer_names(data),
    )


def test_the_artists_work_survives_twenty_clicks(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    click()
    work = artists_work()
    before = read_work(work)
    assert sum(len(strokes) for strokes in before[3]) == 3
    for i in range(20):
        cube.location.x = 0.05 * i
        scene.frame_set(1 + i % 3)
        click()
        assert read_work(work) == before
    bpy.ops.illustrate.clear()
    assert read_work(work)[:4] == before[:4]
    assert sum(map(len, tools.read_pencil(bpy.data.objects["Illustration"]).values())) == 3


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
def test_linked_illustrations_are_left_alone(scene: Any, target: str, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    scene.illustrate.output = target
    click()
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    tools.new_file()
    scene = bpy.context.scene
    tools.cube_scene(scene)
    scene.illustrate.output = target
    with bpy.data.libraries.load(path, link=True) as (there, wanted):
        wanted.objects = [name for name in there.objects if name.startswith("Illustration")]
    for thing in wanted.objects:
        scene.collection.objects.link(thing)
    linked = list(wanted.objects)
    assert linked and not output.has_illustration(scene)
    click()
    assert output.has_illustration(scene)
    bpy.ops.illustrate.clear()
    assert not output.has_illustration(scene)
    assert all(thing.name in scene.collection.objects for thing in linked)


def test_clear_takes_everything_back(scene: Any) -> None:
    hidden_scene(scene)
    before = tools.snapshot()
    assert not bpy.ops.illustrate.clear.poll()
    for target in ("GREASE_PENCIL", "CURVES"):
        scene.illustrate.output = target
        click()
        assert bpy.ops.illustrate.clear() == {"FINISHED"}
        assert tools.snapshot() == before


def test_ten_thousand_strokes_are_written_and_replaced(scene: Any) -> None:
    """Not a time: that nothing in the way strokes are written goes by their square."""
    tools.cube_scene(scene)
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())

    class Many:
        count = 10_000
        points = np.random.default_rng(1).uniform(-1, 1, (3 * count, 3))
        widths = np.ones(3 * count, np.float32)
        offsets = np.arange(0, 3 * count + 1, 3)
        kinds = np.zeros(count, np.uint8)
        closed = np.zeros(count, bool)
        objects = invisibility = stroke_ids = np.zeros(count, np.int32)
        stroke_starts = np.zeros(count, np.float32)

    for _ in range(2):
        write_drawing(scene, Many, made.arrays.camera, "GREASE_PENCIL")
        strokes = tools.read_pencil(bpy.data.objects["Illustration"])["Silhouette"]
        assert len(strokes) == Many.count
