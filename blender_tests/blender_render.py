"""Blender's own render of the strokes on white paper, to hold drawings against."""

from typing import Any

import bpy

WHITE = (1.0, 1.0, 1.0)


def render_png(path: str, scene: Any, strokes: list[Any]) -> None:
    """Renders objects that hold strokes to `path`, as the scene's camera sees them, at its size.

    It happens in a scene of its own: nothing else is in the picture, the artist's scene stays.
    """
    stage = bpy.data.scenes.new("illustrate paper")
    paper = bpy.data.worlds.new("illustrate paper")
    try:
        _set_up(stage, paper, scene)
        for thing in strokes:
            stage.collection.objects.link(thing)
        stage.render.filepath = path
        bpy.ops.render.render(write_still=True, scene=stage.name)
    finally:
        bpy.data.batch_remove((stage,))  # `scenes.remove` crashes in a command of 4.3
        bpy.data.worlds.remove(paper)


def _set_up(stage: Any, paper: Any, scene: Any) -> None:
    """White paper, flat ink, colours as they are; the size of the scene's render."""
    paper.color = WHITE
    stage.world, stage.camera, stage.frame_current = paper, scene.camera, scene.frame_current
    render = stage.render
    render.engine = "BLENDER_WORKBENCH"
    for name in (
        "resolution_x",
        "resolution_y",
        "resolution_percentage",
        "pixel_aspect_x",
        "pixel_aspect_y",
    ):
        setattr(render, name, getattr(scene.render, name))
    render.dither_intensity = 0.0
    render.use_file_extension = False
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    stage.view_settings.view_transform = "Standard"
    stage.view_settings.look = "None"
    shading = stage.display.shading
    shading.light, shading.color_type = "FLAT", "MATERIAL"
