"""The PNG and Blender's render of the strokes against the SVG of the same drawing: the same ink."""

from typing import Any

import bpy
import numpy as np
import pytest
import svg_ink
from blender_render import render_png
from illustrate import native
from illustrate.output import files, write_drawing
from illustrate.running import illustration

import tools

SIZE = (640, 480)
WIDTH_PX = (
    8.0  # Blender's smoothing of edges makes strokes 0.15 to 0.3 px wider, whatever their width
)


def drawn(scene: Any) -> Any:
    """Suzanne, subdivided, from the side."""
    tools.add_camera(scene, (2.2, -4.2, 1.2), SIZE)
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.rotation_euler = (0.6, 0.5, 0)
    scene.collection.objects.link(sun)
    bpy.ops.mesh.primitive_monkey_add()
    tools.subdivide(bpy.context.object, levels=2)
    return illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())


def values_of(path: Any) -> Any:
    """(h, w, channels) of a picture as it is encoded, top row first."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name, image.alpha_mode = "Non-Color", "CHANNEL_PACKED"
    values = np.zeros(len(image.pixels), np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], image.channels)[::-1]


def encoded_ink(path: Any) -> Any:
    """(h, w): the share of each pixel that strokes cover, painted over each other as encoded."""
    return 1 - values_of(path)[..., 0]


def blurred(ink: Any) -> Any:
    """Means of squares of 8 pixels."""
    return ink[: ink.shape[0] // 8 * 8].reshape(-1, 8, ink.shape[1] // 8, 8).mean(axis=(1, 3))


def rendered_ink(path: Any) -> Any:
    """(h, w): the same of Blender's render, where black on white is encoded as sRGB."""
    encoded = values_of(path)[..., 0]
    linear = np.where(encoded < 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    return 1 - linear


def middle(ink: Any) -> Any:
    """(x, y) of the ink's mean position."""
    rows, columns = np.indices(ink.shape)
    return np.array([(columns * ink).sum(), (rows * ink).sum()]) / ink.sum()


@pytest.mark.parametrize("width_px", [0.6, 1.5, 3.0])
def test_the_png_is_the_svg(scene: Any, tmp_path: Any, width_px: float) -> None:
    chosen = scene.illustrate
    chosen.line_width_px = chosen.feature_width_px = chosen.hatch_width_px = width_px
    made = drawn(scene)
    path = tmp_path / "strokes.png"
    files.write_file(str(path), files.Page(scene, made.drawing, made.arrays.camera, [], []))
    text = native.load_part("svg").to_svg(made.drawing, *SIZE, style="tapered")
    picture, svg = encoded_ink(path), svg_ink.coverage(text, *SIZE)
    assert picture.sum() == pytest.approx(svg.sum(), rel=0.02)
    assert np.abs(middle(picture) - middle(svg)).max() < 0.5
    assert np.quantile(np.abs(blurred(picture) - blurred(svg)), 0.99) < 0.05


def test_the_png_has_the_colours_and_the_paper_of_the_scene(scene: Any, tmp_path: Any) -> None:
    scene.illustrate.line_color = (1, 0, 0, 1)
    scene.illustrate.hatching, scene.render.film_transparent = False, True
    made = drawn(scene)
    things = write_drawing(scene, made.drawing, made.arrays.camera, "GREASE_PENCIL")
    path = tmp_path / "strokes.png"
    files.write_file(str(path), files.Page(scene, made.drawing, made.arrays.camera, [], things))
    red, green, _, alpha = values_of(path)[::-1].reshape(-1, 4).T
    assert alpha.min() == 0 and alpha.max() == 1
    assert red.max() > 0.99 and green.max() < 0.1


@pytest.mark.parametrize("target", ["GREASE_PENCIL", "CURVES"])
def test_a_render_has_the_ink_of_the_svg(scene: Any, tmp_path: Any, target: str) -> None:
    scene.illustrate.line_width_px = scene.illustrate.feature_width_px = WIDTH_PX
    scene.illustrate.hatching = False
    made = drawn(scene)
    things = write_drawing(scene, made.drawing, made.arrays.camera, target)
    path = tmp_path / "strokes.png"
    render_png(str(path), scene, things)
    text = native.load_part("svg").to_svg(made.drawing, *SIZE, style="tapered")
    render, svg = rendered_ink(path), svg_ink.coverage(text, *SIZE)
    print(target, render.sum() / svg.sum(), middle(render) - middle(svg))
    assert svg.sum() > 5000
    assert render.sum() == pytest.approx(svg.sum(), rel=0.05)
    assert np.abs(middle(render) - middle(svg)).max() < 1
