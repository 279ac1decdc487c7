"""An image as tone: what is read of an image datablock or a render, as light that comes back.

Images are as light as they look: sRGB decoded, floats as they are. One per frame where they are a
sequence.
"""

import os
import re
from typing import Any

import bpy
import numpy as np

from ..messages import said
from .kept_images import IMAGES
from .pictures import read_image

SOURCES = [
    ("LIGHTS", "Lights", "Light and materials say how dark the drawing is", 0),
    ("IMAGE", "Image", "An image that fills the picture says how dark the drawing is", 1),
    ("RENDER", "Render", "Every drawing begins with a render, which says how dark it is", 2),
]
MOST_STRETCH = 1.01  # between the sides of an image and of the picture

Tone = tuple[Any, list[str]]
"""(h, w) float32, linear, rows downwards, or None; and warnings."""


def read_tone(scene: Any, width_px: int, height_px: int) -> Tone:
    """The tone that the scene's settings take from an image, of its current frame.

    None, and why, where an image is asked for that cannot be used; None for other sources.
    """
    chosen = scene.illustrate
    if chosen.tone_source != "IMAGE":
        return None, []
    image = chosen.tone_image
    if image is None:
        return None, [said("Tone is from an image, but none is chosen: it is from the lights")]
    try:
        luminance = luminance_of(image, scene.frame_current)
    except ValueError as error:
        told = 'Image "{name}" gives no tone, the lights do: {error}'
        return None, [said(told, name=image.name, error=error)]
    return fitted(luminance, image.name, width_px, height_px)


def fitted(luminance: Any, name: str, width_px: int, height_px: int) -> Tone:
    """The middle of an image, as wide for its height as the picture is; a word where it is cut."""
    height, width = luminance.shape
    stretch = (width / height) / (width_px / height_px)
    if 1 / MOST_STRETCH <= stretch <= MOST_STRETCH:
        return luminance, []
    wide = max(round(width / stretch), 1) if stretch > 1 else width
    tall = max(round(height * stretch), 1) if stretch < 1 else height
    left, top = (width - wide) // 2, (height - tall) // 2
    cut = np.ascontiguousarray(luminance[top : top + tall, left : left + wide])
    return cut, [
        said(
            'Of image "{name}" only the middle gives tone: it has {width} x {height} pixels, the '
            "picture {width_px} x {height_px}",
            name=name,
            width=width,
            height=height,
            width_px=width_px,
            height_px=height_px,
        )
    ]


def luminance_of(image: Any, frame: int) -> Any:
    """(h, w) float32 linear luminance, rows downwards. Raises ValueError in words of the artist."""
    if image.type == "RENDER_RESULT":
        raise ValueError(said("it is kept by the renderer. Set Tone From to Render"))
    if image.source == "MOVIE":
        raise ValueError(said("it is a movie. Save its frames as an image sequence"))
    if image.source == "SEQUENCE":
        return _luminance_of_file(path_at(image, frame), image)
    return IMAGES.of(image, "tone", lambda: tone_of(image))


def tone_of(image: Any) -> Any:
    """The same of a loaded image that is one picture."""
    return np.ascontiguousarray(read_image(image)[::-1])


def path_at(image: Any, frame: int) -> str:
    """The file of a sequence's frame: the last number in the name of its file is the frame's."""
    path = bpy.path.abspath(image.filepath, library=image.library)
    folder, name = os.path.split(path)
    numbered = re.sub(r"\d+(?=\D*$)", lambda number: f"{frame:0{len(number[0])}}", name, count=1)
    return os.path.join(folder, numbered)


def _luminance_of_file(path: str, like: Any) -> Any:
    """The same of a file that is opened as `like` is."""
    image = load(path)
    try:
        image.colorspace_settings.name = like.colorspace_settings.name
        return tone_of(image)
    finally:
        bpy.data.images.remove(image)


def load(path: str) -> Any:
    """A new image datablock. Raises ValueError where there is no file or none that can be read."""
    try:
        return bpy.data.images.load(path, check_existing=False)
    except RuntimeError as error:
        missing = said('its file "{path}" is missing or cannot be read', path=path)
        raise ValueError(missing) from error


def choose_file(scene: Any, pattern: str) -> None:
    """Takes the tone from a file; from a sequence where a row of # stands for the frame's number.

    A file that is missing is warned of when it is read.
    """
    name = os.path.basename(pattern)
    image = bpy.data.images.new(name, 1, 1)
    image.source = "SEQUENCE" if "#" in name else "FILE"
    image.filepath = os.path.abspath(
        re.sub("#+(?=[^#]*$)", lambda marks: "0" * len(marks[0]), pattern)
    )
    scene.illustrate.tone_source, scene.illustrate.tone_image = "IMAGE", image
