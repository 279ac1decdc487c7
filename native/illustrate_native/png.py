"""A drawing as PNG: the same picture as its SVG with tapered strokes. Needs numpy only."""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import rasterise
from .line_groups import DrawingArrays, line_groups, points_of

BLACK = (0, 0, 0, 255)
WHITE = (255, 255, 255, 255)
_CLEAR = (255, 255, 255, 0)
_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_COLOUR_TYPES = {1: 0, 3: 2, 4: 6}  # by the number of channels
_PIXELS_PER_METRE = 1
_KEYWORD = b"Illustrate\0"  # of the text that says how the picture was made

Colour = tuple[int, int, int, int]
"""Red, green, blue, alpha in [0, 255], encoded as in sRGB."""
Fill = tuple[NDArray[np.float64], Colour]
"""(h, w) in [0, 1], how much of each pixel an area covers, and its colour. Areas do not overlap."""


def to_png(
    drawing: DrawingArrays,
    width_px: int,
    height_px: int,
    width_mm: float = 200.0,
    colours: Mapping[str, Colour] | None = None,
    paper: Colour = WHITE,
    made_by: Mapping[str, Any] | None = None,
    fills: Sequence[Fill] = (),
) -> bytes:
    """PNG of a drawing made for an image of width_px by height_px, which is its size.

    width_mm: of the page, for its resolution in print. colours: of groups of lines, by their
    titles (line_groups); black where none is given. paper: may be transparent.
    made_by: what the file is to say of its making, of JSON's types; it is in a text chunk.
    fills: areas below the lines.
    Raises InvalidInput for a size that cannot be used.
    """
    under = _CLEAR if fills else paper
    pixels = to_pixels(drawing, width_px, height_px, colours or {}, under)
    if fills:
        pixels = _over_fills(pixels, fills, paper)
    if paper[3] == 255:
        pixels = pixels[..., :3]
    told = [] if made_by is None else [_chunk(b"tEXt", _KEYWORD + json.dumps(made_by).encode())]
    density = round(1000 * width_px / width_mm)
    size = _chunk(b"pHYs", struct.pack(">IIB", density, density, _PIXELS_PER_METRE))
    return image_file(pixels, b"".join((size, *told)))


def _over_fills(ink: NDArray[np.uint8], fills: Sequence[Fill], paper: Colour) -> NDArray[np.uint8]:
    """Lines on areas on paper. Areas share the pixels on their borders, so they are added up."""
    sheet = _times_alpha(np.array(paper, float))
    light = np.tile(sheet, (*ink.shape[:2], 1))  # red, green and blue times alpha, and alpha
    for cover, colour in fills:
        area = _times_alpha(np.array(colour, float))
        light += cover[..., None] * (area - area[3] * sheet)
    light = _times_alpha(ink.astype(float)) + (1 - ink[..., 3:] / 255.0) * light
    light[..., :3] /= np.maximum(light[..., 3:], 1e-6)
    encoded: NDArray[np.uint8] = np.rint(255 * light.clip(0.0, 1.0)).astype(np.uint8)
    return encoded


def _times_alpha(colour: NDArray[np.float64]) -> NDArray[np.float64]:
    """From [0, 255] to [0, 1]."""
    alpha = colour[..., 3:] / 255
    return np.concatenate([colour[..., :3] / 255 * alpha, alpha], axis=-1)


def image_file(pixels: NDArray[np.uint8], told: bytes = b"") -> bytes:
    """PNG of (h, w, 1) grey, (h, w, 3) colours or (h, w, 4) with alpha. told: chunks before it."""
    height, width, channels = pixels.shape
    rows = np.zeros((height, 1 + width * channels), np.uint8)  # each with filter 0
    rows[:, 1:] = pixels.reshape(height, -1)
    head = struct.pack(">IIBBBBB", width, height, 8, _COLOUR_TYPES[channels], 0, 0, 0)
    return b"".join(
        (
            _SIGNATURE,
            _chunk(b"IHDR", head),
            _chunk(b"sRGB", b"\0"),
            told,
            _chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)),
            _chunk(b"IEND", b""),
        )
    )


def to_pixels(
    drawing: DrawingArrays,
    width_px: int,
    height_px: int,
    colours: Mapping[str, Colour],
    paper: Colour = WHITE,
) -> NDArray[np.uint8]:
    """(height_px, width_px, 4): groups of lines above each other, as in `to_svg`."""
    order, inks = [np.zeros(0, int)], [np.zeros((0, 4), np.uint8)]
    for group in line_groups(drawing):
        order.append(group.strokes)
        ink = np.array(colours.get(group.title, BLACK), np.uint8)
        inks.append(np.tile(ink, (len(group.strokes), 1)))
    strokes = np.concatenate(order)
    points, sizes = points_of(drawing, strokes)
    return rasterise(
        np.asarray(drawing.image)[points],
        np.asarray(drawing.widths)[points],
        np.concatenate([[0], np.cumsum(sizes)]),
        np.asarray(drawing.closed)[strokes],
        np.concatenate(inks),
        width_px,
        height_px,
        paper,
    )


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def read_made_by(data: bytes) -> dict[str, Any]:
    """What `to_png` was given as made_by. Raises ValueError where there is none, or damage."""
    chunks = list(_chunks(data))
    told = [body for name, body in chunks if name == b"tEXt" and body.startswith(_KEYWORD)]
    if not told or chunks[-1][0] != b"IEND":
        raise ValueError("not a whole drawing that says how it was made")
    return dict(json.loads(told[0][len(_KEYWORD) :]))


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Names and bodies. Raises ValueError for bytes that are no PNG, or a damaged one."""
    if not data.startswith(_SIGNATURE):
        raise ValueError("not a PNG")
    start = len(_SIGNATURE)
    while start < len(data):
        size = int.from_bytes(data[start : start + 4], "big")
        name, body = data[start + 4 : start + 8], data[start + 8 : start + 8 + size]
        if data[start : start + 12 + size] != _chunk(name, body):
            raise ValueError("a damaged PNG")
        yield name, body
        start += 12 + size
