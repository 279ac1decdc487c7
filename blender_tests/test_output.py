"""What is written into the scene and to files."""

import itertools
import json
import re
from typing import Any

import bpy
import numpy as np
import pytest
from illustrate import native
from illustrate.messages import IllustrateError
from illustrate.output import files, write_drawing
from illustrate.running import illustration

import tools


def made(scene: Any) -> Any:
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


def written(scene: Any, result: Any, target: str) -> dict[str, list[tools.Stroke]]:
    things = write_drawing(scene, result.drawing, result.arrays.camera, target)
    return tools.read_curves(things) if target == "CURVES" else tools.read_pencil(things[0])


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
def test_strokes_are_those_of_the_drawing(scene: Any, target: str) -> None:
    tools.cube_scene(scene)
    result = made(scene)
    drawing = result.drawing
    layers = written(scene, result, target)
    kinds = {name: name.upper().replace("-", "_").replace(" ", "_") for name in layers}
    ill = native.load()
    assert sum(map(len, layers.values())) == len(drawing.kinds) > 0
    for name, strokes in layers.items():
        of_kind = np.flatnonzero(drawing.kinds == int(getattr(ill.Kind, kinds[name])))
        assert len(strokes) == len(of_kind)
        for i, stroke in zip(of_kind, strokes, strict=True):
            span = slice(drawing.offsets[i], drawing.offsets[i + 1])
            assert np.abs(stroke["points"] - drawing.points[span]).max() < 1e-5
            assert stroke["closed"] == bool(drawing.closed[i])


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
@pytest.mark.parametrize("kind", ["PERSP", "ORTHO"])
def test_strokes_look_as_wide_as_the_drawing_says(scene: Any, target: str, kind: str) -> None:
    tools.cube_scene(scene)
    scene.camera.data.type = kind
    result = made(scene)
    camera, drawing = result.arrays.camera, result.drawing
    layers = written(scene, result, target)
    clip = camera.projection @ camera.view
    right = camera.view[0, :3]
    groups = native.load_part("line_groups").line_groups(drawing)
    for group in groups:
        for i, stroke in zip(group.strokes, layers[group.title], strict=True):
            ends = [
                np.c_[p, np.ones(len(p))] @ clip.T
                for p in (stroke["points"], stroke["points"] + 2 * right * stroke["radii"][:, None])
            ]
            x = [(e[:, 0] / e[:, 3] + 1) / 2 * camera.width_px for e in ends]
            widths = drawing.widths[drawing.offsets[i] : drawing.offsets[i + 1]]
            assert x[1] - x[0] == pytest.approx(widths, rel=1e-3, abs=1e-3)


def test_strokes_of_version_3_carry_kind_and_object(scene: Any) -> None:
    if not tools.V3:
        pytest.skip("Grease Pencil 2 has no attributes")
    tools.cube_scene(scene)
    tools.add_cube("Other", (2.5, 0, 0))
    result = made(scene)
    thing = write_drawing(scene, result.drawing, result.arrays.camera, "GREASE_PENCIL")[0]
    found: list[tuple[int, int]] = []
    for layer in thing.data.layers:
        attributes = layer.frames[0].drawing.attributes
        found += zip(
            (v.value - 1 for v in attributes["illustrate_kind"].data),
            (v.value for v in attributes["illustrate_object"].data),
            strict=True,
        )
    drawing = result.drawing
    assert sorted(found) == sorted(
        zip(drawing.kinds.tolist(), drawing.objects.tolist(), strict=True)
    )


def page(scene: Any, **options: Any) -> Any:
    result = made(scene)
    things = write_drawing(scene, result.drawing, result.arrays.camera, "GREASE_PENCIL")
    return files.Page(scene, result.drawing, result.arrays.camera, result.names, things, **options)


def pixels(path: Any) -> Any:
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    values = np.zeros(len(image.pixels), np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], image.channels)[::-1, :, :3]


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
def test_png_shows_the_strokes_on_white_paper(scene: Any, tmp_path: Any, target: str) -> None:
    tools.cube_scene(scene)
    scene.illustrate.hatching = False
    result = made(scene)
    things = write_drawing(scene, result.drawing, result.arrays.camera, target)
    before = tools.snapshot()
    path = tmp_path / "cube.png"
    files.write_file(str(path), files.Page(scene, result.drawing, result.arrays.camera, [], things))
    assert tools.snapshot() == before
    ink = 1 - pixels(path).mean(axis=2)
    assert ink.shape == (240, 320)
    assert ink[0, 0] == 0 and ink.max() > 0.8
    x, y = result.drawing.image.astype(int).T
    inside = (x > 1) & (x < 318) & (y > 1) & (y < 238)
    near = np.array(
        [ink[j - 1 : j + 2, i - 1 : i + 2].max() for i, j in zip(x[inside], y[inside], strict=True)]
    )
    assert np.quantile(near, 0.1) > 0.3
    dark = np.argwhere(ink > 0.5)[:, ::-1] + 0.5
    lines = [
        np.linspace(a, b, 64)
        for i in range(len(result.drawing.kinds))
        for a, b in segments(result.drawing, i)
    ]
    samples = np.concatenate(lines)
    far = [np.linalg.norm(samples - p, axis=1).min() for p in dark[::7]]
    assert max(far) < 4


def segments(drawing: Any, i: int) -> list[Any]:
    points = drawing.image[drawing.offsets[i] : drawing.offsets[i + 1]]
    if drawing.closed[i]:
        points = np.vstack([points, points[:1]])
    return list(itertools.pairwise(points))


def test_svg_is_in_millimetres_with_a_group_per_kind(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    path = tmp_path / "cube.svg"
    cube = page(scene, width_mm=120.0)
    files.write_file(str(path), cube)
    text = path.read_text(encoding="utf-8")
    assert 'width="120mm" height="90mm" viewBox="0 0 320 240"' in text
    groups = native.load_part("line_groups").line_groups(cube.drawing)
    assert re.findall(r'inkscape:label="([^"]+)"', text) == [g.title for g in groups]
    assert text.count("<path") == len(cube.drawing.kinds)


def test_json_holds_the_drawing(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    path = tmp_path / "cube.json"
    cube = page(scene)
    files.write_file(str(path), cube)
    text = path.read_text(encoding="utf-8")
    assert json.loads(text)["objects"] == ["Box"]
    stored = native.load_part("drawing_json").from_json(text)
    for name in ("points", "image", "widths", "offsets", "kinds", "closed", "objects"):
        assert np.array_equal(getattr(stored, name), getattr(cube.drawing, name)), name


def test_blend_is_a_copy_with_the_illustration(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    path = tmp_path / "cube.blend"
    files.write_file(str(path), page(scene))
    assert not bpy.data.filepath
    with bpy.data.libraries.load(str(path)) as (inside, _):
        assert {"Box", "Illustration"} <= set(inside.objects)


def test_files_appear_whole_or_not_at_all(scene: Any, tmp_path: Any, monkeypatch: Any) -> None:
    tools.cube_scene(scene)
    cube = page(scene)
    (tmp_path / "cube.svg").write_text("the last one")

    def fail(*_: Any) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(files.os, "replace", fail)
    with pytest.raises(IllustrateError, match=r"cube\.svg.*disk full"):
        files.write_file(str(tmp_path / "cube.svg"), cube)
    assert [path.name for path in tmp_path.iterdir()] == ["cube.svg"]
    assert (tmp_path / "cube.svg").read_text() == "the last one"


def test_a_folder_that_cannot_be_made_is_named(tmp_path: Any) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(IllustrateError, match=r"file[/\\]inside.*choose another"):
        files.prepare_folder(str(tmp_path / "file" / "inside"))
