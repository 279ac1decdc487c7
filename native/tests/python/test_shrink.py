"""A bug's mesh is made small."""

from __future__ import annotations

import illustrate_native as ill
import numpy as np
import pytest
from shapes import Shape, klein_bottle, sphere
from shrink import part, smallest


def cannot_be_oriented(shape: Shape) -> bool:
    options = ill.PrepareOptions(scheme="none", field=False)
    return ill.prepare([shape.mesh()], options).report["covered_parts"] > 0


def test_of_a_klein_bottle_a_moebius_strip_is_left() -> None:
    found = smallest(klein_bottle(8, 6), cannot_be_oriented)
    assert cannot_be_oriented(found)
    faces = np.arange(len(found.face_sizes))
    assert 3 <= len(faces) <= 10
    assert not any(cannot_be_oriented(part(found, np.delete(faces, f))) for f in faces)
    assert len(found.positions) == len(np.unique(found.corner_vertices))
    assert np.array_equal(found.positions, np.round(found.positions, 5))


def test_a_part_is_what_it_was() -> None:
    whole = sphere(2)
    some = part(whole, np.array([1, 7]))
    assert some.face_sizes.tolist() == [4, 4]
    old, new = (shape.positions[shape.corner_vertices].reshape(-1, 4, 3) for shape in (whole, some))
    assert np.array_equal(new, old[[1, 7]])


def test_what_does_not_fail_is_not_shrunk() -> None:
    with pytest.raises(ValueError, match="nothing to shrink"):
        smallest(sphere(2), cannot_be_oriented)
