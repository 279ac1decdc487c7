"""Tone from images and from renders."""

import pathlib
from typing import Any

import bpy
import illustrate
import numpy as np
import pytest
from illustrate.farm.arguments import parse
from illustrate.reading import tone_images
from illustrate.running import rendering
from illustrate.running.illustration import illustrate as draw
from illustrate.running.illustration import read_request

import tools

SCRIPT = pathlib.Path(illustrate.__file__).parent / "headless.py"


def new_image(name: str, width: int, height: int, rows: Any) -> Any:
    """rows: (h,) grey of each, from below, as it is encoded."""
    image = bpy.data.images.new(name, width, height)
    pixels = np.ones((height, width, 4), np.float32)
    pixels[..., :3] = np.asarray(rows, np.float32)[:, None, None]
    image.pixels.foreach_set(pixels.reshape(-1))
    return image


def read(scene: Any) -> Any:
    return read_request(scene, bpy.context.evaluated_depsgraph_get())


@pytest.fixture
def box(scene: Any) -> Any:
    """A cube before a camera, 4:3, toned by an image."""
    cube = tools.cube_scene(scene)
    scene.illustrate.tone_source = "IMAGE"
    return cube


@pytest.mark.usefixtures("box")
def test_an_image_is_read_linear_with_its_rows_downwards(scene: Any) -> None:
    scene.illustrate.tone_image = new_image("Photo", 4, 3, (0.0, 0.5, 1.0))
    request = read(scene)
    assert request.draw["tone_image"][:, 0] == pytest.approx([1.0, 0.2140, 0.0], abs=2e-3)
    assert not request.warnings
    scene.illustrate.tone_source = "LIGHTS"
    assert read(scene).draw["tone_image"] is None


@pytest.mark.usefixtures("box")
def test_the_drawing_is_as_dark_as_the_image(scene: Any) -> None:
    scene.illustrate.auto_exposure = False
    levels = {}
    for grey in (0.0, 1.0):
        scene.illustrate.tone_image = new_image("Photo", 4, 3, [grey] * 3)
        tone = draw(scene, bpy.context.evaluated_depsgraph_get()).drawing.tone
        levels[grey] = set(tone.level[tone.level != 255].tolist())
    assert levels == {0.0: {2}, 1.0: {0}}


@pytest.mark.usefixtures("box")
def test_the_middle_of_an_image_of_another_form_is_taken(scene: Any) -> None:
    scene.illustrate.tone_image = new_image("Tall", 4, 9, [0, 0, 0, 1, 1, 1, 0, 0, 0])
    request = read(scene)
    assert request.draw["tone_image"].shape == (3, 4)
    assert (request.draw["tone_image"] == 1).all()
    (warning,) = request.warnings
    assert '"Tall"' in warning and "4 x 9" in warning and "320 x 240" in warning
    scene.illustrate.tone_image = new_image("Large", 40, 30, [1] * 30)
    assert not read(scene).warnings


@pytest.mark.usefixtures("box")
def test_an_image_that_cannot_be_used_is_named_once(scene: Any, tmp_path: Any) -> None:
    missing = bpy.data.images.new("Lost", 1, 1)
    missing.source, missing.filepath = "FILE", str(tmp_path / "lost.png")
    wide = new_image("Wide", 1, 1, [1])
    movie = bpy.data.images.new("Film", 1, 1)
    movie.source = "MOVIE"
    sequence = bpy.data.images.new("Frames", 1, 1)
    sequence.source, sequence.filepath = "SEQUENCE", str(tmp_path / "frame_001.png")
    for image in (missing, movie, sequence, None, wide):
        scene.illustrate.tone_image = image
        request = read(scene)
        if image is wide:
            assert request.draw["tone_image"] is not None
            continue
        assert request.draw["tone_image"] is None
        (warning,) = request.warnings
        assert image is None or image.name in warning
    assert len(bpy.data.images) == 4


@pytest.mark.usefixtures("box")
def test_a_sequence_has_an_image_for_each_frame(scene: Any, tmp_path: Any) -> None:
    for frame, grey in ((1, 0.0), (2, 1.0)):
        image = new_image(f"{frame}", 4, 3, [grey] * 3)
        image.filepath_raw, image.file_format = str(tmp_path / f"take2_{frame:04}.png"), "PNG"
        image.save()
    tone_images.choose_file(scene, str(tmp_path / "take2_####.png"))
    assert scene.illustrate.tone_source == "IMAGE"
    for frame, light in ((1, 0.0), (2, 1.0)):
        scene.frame_set(frame)
        assert read(scene).draw["tone_image"].mean() == pytest.approx(light)
    scene.frame_set(3)
    assert "take2_0003.png" in read(scene).warnings[0]


def lit_by_cycles(scene: Any) -> Any:
    """A cube lit from the right of its camera, for renders of a moment."""
    cube = tools.cube_scene(scene)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 4
    scene.cycles.use_denoising = False
    scene.render.resolution_percentage = 25
    sun = scene.objects["Sun"]
    sun.data.energy = 3
    sun.rotation_euler = (0.9, 0, 0.6)
    return cube


def state(scene: Any) -> list[Any]:
    settings = scene.render.image_settings
    return [
        settings.file_format, settings.color_mode, scene.render.use_freestyle,
        bpy.context.preferences.view.render_display_type,
        sorted(image.name for image in bpy.data.images if image.type != "RENDER_RESULT"),
        [thing.hide_render for thing in scene.objects],
    ]  # fmt: skip


def test_a_render_is_hatched_and_leaves_no_trace(scene: Any) -> None:
    lit_by_cycles(scene)
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    before = state(scene)
    scene.illustrate.tone_source = "RENDER"
    seen = []

    def look(_scene: Any, *_: Any) -> None:
        seen.append([thing.hide_render for thing in scene.objects if thing.type != "CAMERA"])

    bpy.app.handlers.render_pre.append(look)
    try:
        assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    finally:
        bpy.app.handlers.render_pre.remove(look)
    assert len(seen) == 1 and sum(seen[0]) == 1  # the illustration alone
    assert state(scene) == before


def test_a_render_is_as_light_as_it_looks(scene: Any) -> None:
    lit_by_cycles(scene)
    light = rendering.render_now(scene, tone_images.tone_of)
    assert light.shape == (60, 80)
    assert light[30:50, 30:50].max() > 0.2 and light[:5, :5].max() < 0.05


def test_a_render_is_kept_for_more_drawings(scene: Any) -> None:
    lit_by_cycles(scene)
    for _ in range(2):
        assert bpy.ops.illustrate.render_tone() == {"FINISHED"}
    chosen = scene.illustrate
    assert (chosen.tone_source, chosen.tone_image.name) == ("IMAGE", rendering.NAME)
    assert tuple(chosen.tone_image.size) == (80, 60) and chosen.tone_image.packed_file
    assert not read(scene).warnings
    assert [i.name for i in bpy.data.images if i.type == "IMAGE"] == [rendering.NAME]


def test_a_bake_renders_each_frame(scene: Any) -> None:
    lit_by_cycles(scene)
    scene.illustrate.tone_source = "RENDER"
    scene.frame_start, scene.frame_end = 1, 2
    frames: list[int] = []

    def look(_scene: Any, *_: Any) -> None:
        frames.append(scene.frame_current)

    bpy.app.handlers.render_pre.append(look)
    try:
        assert bpy.ops.illustrate.bake() == {"FINISHED"}
    finally:
        bpy.app.handlers.render_pre.remove(look)
    assert frames == [1, 2]


def test_a_scene_that_cannot_be_rendered_says_so(scene: Any, monkeypatch: Any) -> None:
    lit_by_cycles(scene)
    scene.illustrate.tone_source = "RENDER"
    before = state(scene)

    def refuse(*_: Any) -> None:
        raise illustrate.messages.IllustrateError("no")

    monkeypatch.setattr(rendering, "_render", refuse)
    with pytest.raises(RuntimeError, match="no"):
        bpy.ops.illustrate.illustrate()
    assert state(scene) == before


def test_the_command_takes_images_and_renders(scene: Any, tmp_path: Any) -> None:
    lit_by_cycles(scene)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    for name, grey in (("light", 1.0), ("dark", 0.0)):
        image = new_image(name, 4, 3, [grey] * 3)
        image.filepath_raw, image.file_format = str(tmp_path / f"{name}.png"), "PNG"
        image.save()
    sizes = {}
    for name, *arguments in (
        ("light", "--tone-image", str(tmp_path / "light.png")),
        ("dark", "--tone-image", str(tmp_path / "dark.png")),
        ("render", "--tone-from", "render"),
        ("lost", "--tone-image", str(tmp_path / "lost_##.png")),
    ):
        ran = tools.run_script(
            SCRIPT, "--out", str(tmp_path / name), *arguments, blend=tmp_path / "shot.blend"
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr
        assert ("lost_01.png" in ran.stderr) == (name == "lost")
        sizes[name] = (tmp_path / name / "shot_0001.svg").stat().st_size
    assert sizes["light"] < sizes["render"] < 1.2 * sizes["dark"]
    with pytest.raises(SystemExit):
        parse(["--out", "x", "--tone-image", "a.png", "--tone-from", "render"])
