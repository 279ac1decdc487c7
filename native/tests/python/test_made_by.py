"""What files say of their making, and whether they are whole."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from illustrate_native import png, svg
from illustrate_native.drawing_json import StoredDrawing, from_json, to_json

MADE_BY = {"version": "1.2.3", "frame": 7, "exposure": 0.1, "names": '<Käse> & "Brot"'}


def line() -> StoredDrawing:
    return StoredDrawing(
        40,
        30,
        ["Ball"],
        points=np.array([[0.0, 0, 0], [1, 0, 0]]),
        image=np.array([[5.0, 5], [35, 25]]),
        widths=np.array([1, 2], np.float32),
        offsets=np.array([0, 2], np.int32),
        kinds=np.zeros(1, np.uint8),
        closed=np.zeros(1, np.bool_),
        objects=np.zeros(1, np.int32),
        invisibility=np.zeros(1, np.int32),
    )


def written(made_by: dict[str, Any] | None) -> dict[str, bytes]:
    made = line()
    return {
        "svg": svg.to_svg(made, 40, 30, made_by=made_by).encode(),
        "png": png.to_png(made, 40, 30, made_by=made_by),
        "json": to_json(made, 40, 30, made.object_names, made_by).encode(),
    }


READ: dict[str, Callable[[bytes], dict[str, Any]]] = {
    "svg": lambda data: svg.read_made_by(data.decode()),
    "png": png.read_made_by,
    "json": lambda data: from_json(data.decode()).made_by,
}


@pytest.mark.parametrize("kind", READ)
def test_it_is_read_as_it_was_written(kind: str) -> None:
    assert READ[kind](written(MADE_BY)[kind]) == MADE_BY


@pytest.mark.parametrize("kind", READ)
def test_half_a_file_is_none(kind: str) -> None:
    data = written(MADE_BY)[kind]
    for size in (0, len(data) // 2, len(data) - 6):
        with pytest.raises(ValueError):
            READ[kind](data[:size])


def test_a_file_that_says_nothing() -> None:
    files = written(None)
    assert READ["json"](files["json"]) == {}
    for kind in ("svg", "png"):
        with pytest.raises(ValueError, match="how it was made"):
            READ[kind](files[kind])


def test_a_changed_bit_of_a_png_is_found() -> None:
    data = bytearray(written(MADE_BY)["png"])
    data[-30] ^= 1
    with pytest.raises(ValueError, match="damaged"):
        png.read_made_by(bytes(data))


def test_the_svg_is_well_formed() -> None:
    root = ElementTree.fromstring(written(MADE_BY)["svg"])
    [told] = [child for child in root if child.tag.endswith("metadata")]
    assert "<Käse>" in (told.text or "").encode().decode("unicode_escape")


def decoded(data: bytes) -> Any:
    """(h, w, channels) of a PNG whose rows have no filter."""
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert depth == 8
    begin = data.index(b"IDAT")
    (size,) = struct.unpack(">I", data[begin - 4 : begin])
    rows = np.frombuffer(zlib.decompress(data[begin + 4 : begin + 4 + size]), np.uint8)
    rows = rows.reshape(height, 1 + width * {2: 3, 6: 4}[kind])
    assert not rows[:, 0].any()
    return rows[:, 1:].reshape(height, width, -1)


def test_a_png_has_alpha_where_its_paper_is_seen_through() -> None:
    solid, clear = (decoded(png.to_png(line(), 40, 30, paper=p)) for p in (png.WHITE, (0,) * 4))
    assert (solid.shape, clear.shape) == ((30, 40, 3), (30, 40, 4))
    assert solid[0, 0].tolist() == [255] * 3 and clear[0, 0].tolist() == [0] * 4
    assert clear[15, 20, 3] == 255 - solid[15, 20, 0] > 128  # as much ink on either
