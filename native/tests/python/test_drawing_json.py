"""Drawings to JSON and back."""

from __future__ import annotations

import json
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from illustrate_native.drawing_json import StoredDrawing, from_json, to_json

ARRAYS = ("points", "image", "widths", "offsets", "kinds", "closed", "objects", "invisibility")


def drawing(strokes: int = 5, seed: int = 1) -> StoredDrawing:
    random = np.random.default_rng(seed)
    sizes = random.integers(1, 6, strokes)
    count = int(sizes.sum())
    return StoredDrawing(
        640,
        480,
        ["Ball", 'Ring "2"'],
        points=random.normal(size=(count, 3)),
        image=random.uniform(0, 480, (count, 2)),
        widths=random.uniform(0, 3, count).astype(np.float32),
        offsets=np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32),
        kinds=random.integers(0, 10, strokes).astype(np.uint8),
        closed=random.uniform(size=strokes) > 0.5,
        objects=random.integers(0, 2, strokes).astype(np.int32),
        invisibility=random.integers(0, 3, strokes).astype(np.int32),
    )


def text_of(made: StoredDrawing) -> str:
    return to_json(made, made.width_px, made.height_px, made.object_names)


@pytest.mark.parametrize("strokes", [0, 1, 5])
def test_round_trip_gives_the_same_bits(strokes: int) -> None:
    made = drawing(strokes)
    back = from_json(text_of(made))
    for name in ARRAYS:
        before, after = getattr(made, name), getattr(back, name)
        assert before.dtype == after.dtype, name
        assert before.shape == after.shape, name
        assert np.array_equal(before, after), name
    assert (back.width_px, back.height_px, back.object_names) == (640, 480, made.object_names)
    assert text_of(back) == text_of(made)


def test_kinds_are_named() -> None:
    made = drawing()
    strokes = json.loads(text_of(made))["strokes"]
    assert [s["kind"] for s in strokes] == [ill.Kind(int(k)).name for k in made.kinds]
    assert [s["closed"] for s in strokes] == made.closed.tolist()


def test_numbers_that_are_not_finite_are_refused() -> None:
    made = drawing()
    made.image[0, 0] = np.nan
    with pytest.raises(ValueError, match="not JSON compliant"):
        text_of(made)


def spoiled(**changes: Any) -> str:
    data = json.loads(text_of(drawing()))
    for name, value in changes.items():
        if name in data:
            data[name] = value
        else:
            data["strokes"][0][name] = value
    return json.dumps(data)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "not a drawing"),
        ("[]", "not a drawing"),
        (spoiled(format="x"), "not a drawing"),
        (spoiled(version=99), "version 99"),
        (spoiled(strokes=[{}]), "parts missing"),
        (spoiled(kind="SCRIBBLE"), "SCRIBBLE"),
        (spoiled(widths=[]), "stroke 0 has"),
    ],
)
def test_other_texts_are_refused(text: str, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        from_json(text)
