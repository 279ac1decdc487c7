"""The strokes as PNG, in the colours of their pens: the same picture in every Blender."""

from typing import Any

from .. import native
from . import pens
from .strokes import pen_of


def png_of(page: Any) -> bytes:
    """A PNG of a Page's drawing, the size of the scene's render. Transparent where its film is."""
    groups = native.load_part("line_groups").line_groups(page.drawing)
    inks = _inks(page.scene.illustrate, page.strokes)
    colours = {group.title: inks[pen_of(group)] for group in groups}
    png = native.load_part("png")
    paper = (255, 255, 255, 0) if page.scene.render.film_transparent else png.WHITE
    size = page.camera.width_px, page.camera.height_px
    cover = native.load_part("plot").coverage
    fills = [(cover(area.region, *size), encoded(area.colour)) for area in page.areas]
    return bytes(
        png.to_png(page.drawing, *size, page.width_mm, colours, paper, page.made_by, fills)
    )


def _inks(settings: Any, strokes: list[Any]) -> dict[str, tuple[int, int, int, int]]:
    """The colours of pens: of their materials where strokes have them, else of the settings."""
    inks = {pen: tuple(getattr(settings, name)) for pen, name in pens.PENS.items()}
    for thing in strokes:
        for pen, index in pens.of_data(thing.data).items():
            inks[pen] = tuple(pens.colour_of(thing.data.materials[index]))
    return {pen: encoded(colour) for pen, colour in inks.items()}


def hex_of(colour: tuple[float, ...]) -> str:
    """Such as '#1a2b3c', of linear light."""
    return "#" + "".join(f"{number:02x}" for number in encoded(colour)[:3])


def encoded(colour: tuple[float, ...]) -> tuple[int, int, int, int]:
    """From linear light, with alpha or without, to bytes of sRGB."""
    *light, alpha = (min(max(value, 0.0), 1.0) for value in (*colour, 1.0)[:4])
    encoded = [12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in light]
    red, green, blue = (round(255 * value) for value in encoded)
    return red, green, blue, round(255 * alpha)
