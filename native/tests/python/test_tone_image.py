"""Ink as dark as the light that is asked for, of an image and of lights; what bad images get."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import illustrate_native as ill
import numpy as np
import pytest
from illustrate_native import png
from numpy.typing import NDArray
from shapes import look_at, plate, sphere, torus

SIZE_PX = 640
SPACING_PX = 5
WINDOW_PX = 4 * SPACING_PX
CAMERA = look_at((0.3, 0.2, 1.0), radius=1.0, perspective=False, size_px=SIZE_PX)


SHAPES = {"ball": sphere(), "plate": plate(40), "torus": torus()}


@cache
def prepared(name: str) -> ill.Prepared:
    """One for all views: field and hatch curves are found once."""
    return ill.prepare([SHAPES[name].mesh()])


def portrait() -> NDArray[np.float64]:
    """(h, w) soft light with a few dark patches, as of a photograph."""
    rows, columns = np.indices((SIZE_PX, SIZE_PX)) / SIZE_PX
    light = 0.55 + 0.45 * np.sin(5 * columns + 1) * np.cos(4 * rows)
    for row, column, size in ((0.4, 0.4, 0.1), (0.4, 0.62, 0.1), (0.65, 0.5, 0.12)):
        light *= 1 - 0.7 * np.exp(-((rows - row) ** 2 + (columns - column) ** 2) / size**2)
    picture: NDArray[np.float64] = light.clip(0, 1)
    return picture


def windows(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means of squares of the picture."""
    count = SIZE_PX // WINDOW_PX
    cut = values[: count * WINDOW_PX, : count * WINDOW_PX]
    means: NDArray[np.float64] = cut.reshape(count, WINDOW_PX, count, WINDOW_PX).mean(axis=(1, 3))
    return means


def likeness(shape: str, options: ill.DrawOptions, lights: Sequence[ill.Light] = ()) -> float:
    """The correlation of paper left white and light asked for, over windows within the shape."""
    drawing = ill.draw(prepared(shape), CAMERA, options, lights=lights)
    pixels = png.to_pixels(drawing, SIZE_PX, SIZE_PX, {}, png.WHITE)
    white = windows(pixels[..., 0] / 255.0)
    cells = ((np.arange(SIZE_PX) + 0.5) / drawing.tone.cell_px).astype(int)
    light = np.minimum(drawing.tone.brightness, 1)[np.ix_(cells, cells)].astype(float)
    seen = drawing.tone.level[np.ix_(cells, cells)] != 255
    inside = windows(seen.astype(float)) == 1
    assert inside.sum() > 200
    return float(np.corrcoef(white[inside], windows(light)[inside])[0, 1])


def fine_lines(**values: object) -> ill.DrawOptions:
    return ill.DrawOptions(
        spacing_px=SPACING_PX, undercuts=False, mach_bands=False, cell_px=1.0, **values
    )


def photograph(**values: object) -> ill.DrawOptions:
    """As the preset of this name."""
    tones = {"highlight_threshold": 0.9, "shadow_threshold": 0.5}
    return fine_lines(hatch_width_px=1.2, hatch_width_by_light=0.7, **tones, **values)


@pytest.mark.parametrize("extra_levels", [0, 2])
@pytest.mark.parametrize("shape", ["ball", "plate"])
def test_hatches_are_as_dark_as_the_image(shape: str, extra_levels: int) -> None:
    options = photograph(extra_levels=extra_levels, tone_image=portrait())
    assert likeness(shape, options) >= 0.95


@pytest.mark.parametrize("shape", ["ball", "plate"])
def test_so_they_are_with_the_default_tones(shape: str) -> None:
    assert likeness(shape, fine_lines(tone_image=portrait())) >= 0.95


LIGHTS = {
    "at the eye": ill.Light("head"),
    "beside it": ill.Light("side", (-1.0, 0.8, 0.7)),
    "a lamp": ill.Light("point", (1.0, 1.5, 1.5), 3.0, falloff_distance=1.0),
}


@pytest.mark.parametrize("light", LIGHTS)
@pytest.mark.parametrize("shape", ["ball", "torus"])
def test_hatches_are_as_dark_as_the_light(shape: str, light: str) -> None:
    options = fine_lines(auto_exposure=True, line_width_px=0, feature_width_px=0)
    assert likeness(shape, options, [LIGHTS[light]]) >= 0.95


def test_the_image_is_read_as_it_is_when_drawn() -> None:
    image = np.full((8, 8), 0.9, np.float32)
    options = fine_lines(tone_image=image)
    assert options.tone_image is image
    light = ill.draw(prepared("ball"), CAMERA, options)
    assert not (light.kinds >= ill.Kind.HATCH).any()
    image[:] = 0.1
    dark = ill.draw(prepared("ball"), CAMERA, options)
    assert (dark.tone.level[dark.tone.level != 255] == 2).all()


def test_images_of_any_numbers_are_taken() -> None:
    wild = np.array([[np.nan, np.inf, -1.0, 6e4], [0, 1, 2, 3]])
    for image in (wild, wild.astype(np.float16), [[1]], np.ones((3, 5), bool)):
        ill.draw(prepared("ball"), CAMERA, fine_lines(tone_image=image))


@pytest.mark.parametrize("image", ["photo.png", 3, np.ones(4), np.ones((2, 2, 3)), np.ones((0, 4))])
def test_what_is_no_image_is_named(image: object) -> None:
    with pytest.raises(ill.InvalidInput, match="tone_image must be"):
        ill.draw(prepared("ball"), CAMERA, fine_lines(tone_image=image))
