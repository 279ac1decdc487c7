"""The strokes of an object at rest are the same to the bit, whatever happens to objects that
neither hide nor shadow it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import LEVEL, draw
from shapes import Doubles, Shape, drape, look_at, plate, sphere, torus

Stroke = tuple[int, bytes, bytes]
Scene = dict[str, Shape]

# In a row: what rests (of every kind: smooth, with a boundary, with flat faces), then what does
# not.
RESTING = ("bump", "cloth", "plate")
VIEW = look_at(direction=(0.0, -2.0, 1.0), radius=6.5, size_px=640)


def bump() -> Shape:
    """A sphere with dents: its field has more than one good minimum."""
    ball = sphere(10)
    x, y, z = ball.positions.T
    radius = 1 + 0.15 * np.sin(3 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(5 * z)
    return Shape(ball.positions * radius[:, None], ball.face_sizes, ball.corner_vertices)


def stretched(shape: Shape, by: Doubles) -> Shape:
    return Shape(shape.positions * by, shape.face_sizes, shape.corner_vertices)


def scene_at_first() -> Scene:
    return {
        "bump": bump().moved((-5.2, 0, 0)),
        "cloth": drape(16).moved((-2.7, 0, 0)),
        "plate": plate(7).moved((-0.3, 0, 0)),
        "ring": torus(16, 8).moved((2.7, 0, 0)),
        "last": bump().moved((5.4, 0, 0)),
    }


def with_ring(shape: Shape) -> Scene:
    return scene_at_first() | {"ring": shape}


CHANGES: dict[str, Callable[[], Scene]] = {
    "moved": lambda: with_ring(torus(16, 8).moved((2.8, 0.3, 0.2))),
    "moved far": lambda: with_ring(torus(16, 8).moved((2.7, 800, 300))),
    "stretched": lambda: with_ring(
        stretched(torus(16, 8), np.array([1.01, 1.0, 1.1])).moved((2.7, 0, 0))
    ),
    "finer": lambda: with_ring(torus(40, 20).moved((2.7, 0, 0))),
    "deleted": lambda: {k: s for k, s in scene_at_first().items() if k != "ring"},
    "added": lambda: scene_at_first() | {"more": sphere(6).moved((2.7, 0, 2.5))},
    "added behind the camera": lambda: (
        {"more": torus(30, 15, 9.0, 3.0).moved((0, -80, 40))} | scene_at_first()
    ),
    "renamed": lambda: {("x" if k == "ring" else k): s for k, s in scene_at_first().items()},
    "in another order": lambda: dict(sorted(scene_at_first().items(), reverse=True)),
    "alone": lambda: {k: s for k, s in scene_at_first().items() if k in RESTING},
}


def prepared_of(scene: Scene, threads: int = 1) -> ill.Prepared:
    meshes = [shape.mesh(name=name) for name, shape in scene.items()]
    return ill.prepare(meshes, ill.PrepareOptions(level=LEVEL, threads=threads))


def strokes_of(scene: Scene, drawing: ill.Drawing) -> dict[str, Counter[Stroke]]:
    """Of each resting object, the bytes of its strokes."""
    names = list(scene)
    found: dict[str, Counter[Stroke]] = {name: Counter() for name in RESTING}
    for i, (begin, end) in enumerate(zip(drawing.offsets[:-1], drawing.offsets[1:], strict=True)):
        name = names[drawing.objects[i]]
        if name not in found:
            continue
        span = slice(begin, end)
        image, widths = drawing.image[span].tobytes(), drawing.widths[span].tobytes()
        found[name][int(drawing.kinds[i]), image, widths] += 1
    return found


def drawn(scene: Scene, threads: int = 1, **more: Any) -> dict[str, Counter[Stroke]]:
    prepared = prepared_of(scene, threads)
    options = ill.DrawOptions(threads=threads, spacing_px=5, **more)
    return strokes_of(scene, draw(prepared, VIEW, options))


@pytest.fixture(scope="module")
def at_first() -> dict[str, Counter[Stroke]]:
    return drawn(scene_at_first())


def changed(before: Counter[Stroke], after: Counter[Stroke]) -> tuple[int, int]:
    return (before - after).total(), before.total()


def test_there_is_something_to_change(at_first: dict[str, Counter[Stroke]]) -> None:
    kinds = {ill.Kind.HATCH, ill.Kind.CROSS_HATCH, ill.Kind.UNDERCUT}
    for name in RESTING:
        hatches = sum(n for stroke, n in at_first[name].items() if stroke[0] in kinds)
        assert hatches > 5, name


@pytest.mark.parametrize("change", CHANGES)
def test_nothing_moves_that_did_not_move(at_first: dict[str, Counter[Stroke]], change: str) -> None:
    after = drawn(CHANGES[change]())
    for name in RESTING:
        assert after[name] == at_first[name], (name, changed(at_first[name], after[name]))


def test_threads_change_nothing(at_first: dict[str, Counter[Stroke]]) -> None:
    assert drawn(scene_at_first(), threads=3) == at_first
