"""Meshes cut by the alpha of an image: areas, boundaries and values with known answers."""

import collections
import math
from typing import Any

import numpy as np
import pytest
from illustrate.reading import mesh_parts
from illustrate.reading.alpha import cut as cutting
from illustrate.reading.alpha.cut import cut_by_alpha
from illustrate.reading.alpha.image import AlphaImage
from illustrate.reading.mesh_arrays import MeshArrays

SQUARE = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
RADIUS = 0.3


def mesh(positions: Any, faces: Any, **values: Any) -> MeshArrays:
    """A mesh without creases or marks, but those of `values`."""
    none = np.zeros((0, 2), np.int32)
    held: dict[str, Any] = {
        "edge_vertices": none,
        "edge_sharpness": np.zeros(0),
        "vertex_sharpness": None,
        "marked_edges": none,
        "face_materials": np.zeros(len(faces), np.int32),
    }
    return MeshArrays(
        name="Card",
        positions=np.array(positions, float),
        face_sizes=np.array([len(face) for face in faces], np.int32),
        corner_vertices=np.concatenate(faces).astype(np.int32),
        cage=False,
        **{**held, **values},
    )


def card(**values: Any) -> MeshArrays:
    return mesh(SQUARE, [[0, 1, 2, 3]], **values)


def flat_uv(of: MeshArrays, scale: float = 1.0) -> Any:
    """Places of corners in the plane."""
    return of.positions[of.corner_vertices][:, :2] * scale


def distance(texels: int, place: Any = (0.5, 0.5)) -> Any:
    """(texels, texels) how far the middles of texels are from a place."""
    middles = (np.arange(texels) + 0.5) / texels
    return np.hypot(middles[None, :] - place[0], middles[:, None] - place[1])


def disc(texels: int, radius: float = RADIUS, place: Any = (0.5, 0.5)) -> Any:
    """Alpha of a disc, as a painter's brush leaves it: soft over one texel."""
    return ((radius - distance(texels, place)) * texels + 0.5).clip(0, 1)


def cut(of: MeshArrays, values: Any, uv: Any = None, **options: Any) -> MeshArrays:
    places = flat_uv(of) if uv is None else uv
    faces = np.zeros(len(of.face_sizes), int)
    return cut_by_alpha(of, places, faces, [AlphaImage(values, **options)]).mesh


def faces_of(of: MeshArrays) -> list[Any]:
    return np.split(of.corner_vertices, np.cumsum(of.face_sizes)[:-1])


def area(of: MeshArrays) -> float:
    """Of all faces, counted negative where one is turned round."""
    total = 0.0
    for face in faces_of(of):
        x, y = of.positions[face][:, :2].T
        total += float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    return total


def boundary(of: MeshArrays) -> dict[int, int]:
    """The next vertex after each on the boundary; fails where faces do not fit together."""
    sides = collections.Counter(
        side for f in faces_of(of) for side in zip(f.tolist(), np.roll(f, -1).tolist(), strict=True)
    )
    assert set(sides.values()) <= {1}
    open_sides = [side for side in sides if side[::-1] not in sides]
    following = dict(open_sides)
    assert len(following) == len(open_sides)
    return following


def loops(of: MeshArrays) -> int:
    """Closed loops of the boundary."""
    following, count = boundary(of), 0
    while following:
        first = at = next(iter(following))
        while (at := following.pop(at)) != first:
            pass
        count += 1
    return count


@pytest.mark.parametrize("is_hard", [False, True])
def test_a_disc_has_its_area_and_one_boundary(is_hard: bool) -> None:
    for texels in (64, 128, 256, 512):
        alpha = disc(texels)
        made = cut(card(), alpha.round() if is_hard else alpha)
        assert loops(made) == 1
        error = abs(area(made) - math.pi * RADIUS**2)
        assert error < (0.3 if is_hard else 0.1) * 2 * math.pi * RADIUS / texels
        rim = made.positions[list(boundary(made))][:, :2] - 0.5
        off = np.abs(np.linalg.norm(rim, axis=1) - RADIUS).max() * texels
        assert off < (1.0 if is_hard else 0.3)  # texels


def test_the_outline_of_texels_is_no_staircase() -> None:
    """Edges of the boundary turn little from the tangents of the disc."""
    made = cut(card(), disc(256).round())
    following = boundary(made)
    begin, end = (made.positions[list(x)][:, :2] for x in (following, following.values()))
    middle, along = (begin + end) / 2 - 0.5, end - begin
    lengths = np.linalg.norm(along, axis=1)
    slope = np.abs((middle * along).sum(axis=1)) / lengths / np.linalg.norm(middle, axis=1)
    assert np.average(slope, weights=lengths) < math.sin(math.radians(10))


def test_a_ring_has_two_boundaries() -> None:
    made = cut(card(), disc(128) * (1 - disc(128, 0.15)))
    assert loops(made) == 2
    assert area(made) == pytest.approx(math.pi * (0.3**2 - 0.15**2), rel=0.01)


@pytest.mark.parametrize("faces", [[[0, 1, 2], [0, 2, 3]], [[0, 1, 4], [1, 2, 4], [2, 3, 0, 4]]])
def test_faces_of_any_corners_join_without_a_crack(faces: Any) -> None:
    made = cut(mesh([*SQUARE, (0.4, 0.6, 0)], faces), disc(128))
    assert loops(made) == 1
    assert area(made) == pytest.approx(math.pi * RADIUS**2, rel=0.01)


def test_neighbours_share_points_on_their_edge() -> None:
    strip = [(x, y, 0) for y in (0, 1) for x in (0, 1, 2)]
    two = mesh(strip, [[0, 1, 4, 3], [1, 2, 5, 4]])
    made = cut(two, disc(256, 0.2, (0.5, 0.25)), flat_uv(two, 0.5))
    assert loops(made) == 1
    assert area(made) == pytest.approx(math.pi * 0.4**2, rel=0.01)
    rim = made.positions[list(boundary(made))]
    assert (np.abs(rim[:, 0] - 1) < 1e-9).sum() == 2  # where the circle crosses the edge


def test_whole_neighbours_stay_and_have_the_points_of_the_edge() -> None:
    places = [(x, y, 0) for y in (0, 1) for x in (0, 1, 2, 3)]
    three = mesh(places, [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6]])
    hole = 1 - disc(256, 0.1, (1 / 3, 1 / 6))
    made = cut(three, hole, flat_uv(three, 1 / 3), wrap="extend")
    assert loops(made) == 2 and area(made) == pytest.approx(3 - math.pi * 0.3**2, rel=0.01)
    assert made.face_sizes[-1] <= 6  # the quad, and points of its neighbour
    apart = cut_by_alpha(three, flat_uv(three), np.array([0, -1, -1]), [AlphaImage(hole)]).mesh
    assert loops(apart) == 2 and apart.face_sizes[-1] == 4 and apart.face_sizes[-2] > 4


def test_a_seam_of_uvs_cracks_nothing() -> None:
    """Faces that see other parts of the image have crossings of their own on the edge."""
    strip = [(x, y, 0) for y in (0, 1) for x in (0, 1, 2)]
    two = mesh(strip, [[0, 1, 4, 3], [1, 2, 5, 4]])
    uv = np.array([[0, 0], [0.5, 0], [0.5, 1], [0, 1], [0.45, 0], [1, 0], [1, 1], [0.45, 1]], float)
    made = cut(two, disc(128), uv)
    assert loops(made) == 1


def test_wraps() -> None:
    four = cut(card(), disc(64), flat_uv(card(), 2))
    assert loops(four) == 4 and area(four) == pytest.approx(math.pi * 0.3**2, rel=0.02)
    mirrored = cut(card(), disc(128, 0.2, (1, 1)), flat_uv(card(), 2), wrap="mirror")
    assert loops(mirrored) == 1 and area(mirrored) == pytest.approx(math.pi * 0.1**2, rel=0.02)
    clipped = cut(card(), np.ones((64, 64)), flat_uv(card(), 3) - 1.1, wrap="clip")
    assert loops(clipped) == 1 and area(clipped) == pytest.approx(1 / 9, rel=0.01)
    extended = cut(card(), np.ones((64, 64)), flat_uv(card(), 3) - 1.1, wrap="extend")
    assert extended.face_sizes.tolist() == [4]


def test_a_stem_at_one_rim_does_not_show_at_the_other() -> None:
    stem = np.zeros((64, 64))
    stem[:8, 28:36] = 1
    made = cut(card(), stem)
    assert loops(made) == 1 and made.positions[:, 1].max() < 0.2
    assert loops(cut(card(), stem, flat_uv(card()) * (1, 1.01))) == 2  # another copy begins


@pytest.mark.parametrize("wrap", ["repeat", "mirror", "extend", "clip"])
def test_what_is_opaque_stays_the_very_mesh(wrap: str) -> None:
    of = card()
    assert cut(of, np.ones((4, 4)), wrap=wrap) is of
    assert cut_by_alpha(of, flat_uv(of), [-1], [AlphaImage(np.zeros((2, 2)))]).mesh is of


@pytest.mark.parametrize("threshold", [0.0, 0.5, 1.0])
def test_of_what_is_clear_nothing_stays(threshold: float) -> None:
    made = cut(card(vertex_sharpness=np.ones(4)), np.zeros((4, 4)), threshold=threshold)
    assert [len(made.positions), len(made.face_sizes), len(made.corner_vertices)] == [0, 0, 0]
    assert len(made.vertex_sharpness) == 0


def test_a_threshold_moves_the_outline() -> None:
    slope = np.tile(np.linspace(0, 1, 256), (256, 1))
    for threshold in (0.25, 0.75):
        made = cut(card(), slope, threshold=threshold, wrap="extend")
        assert area(made) == pytest.approx(1 - threshold, abs=0.01)


def test_corners_carry_their_values_on() -> None:
    uv = np.array([[0, 0], [2, 0], [2, 3], [0, 3]], float)
    normals = np.array([[0, 0, 1], [1, 0, 1], [1, 0, 1], [0, 0, 1]], np.float32)
    of = card(
        uv=uv,
        corner_normals=normals,
        reflectance=np.array([0.0, 1.0, 1.0, 0.0]),
        face_textures=np.array([0], np.int32),
        face_materials=np.array([7], np.int32),
    )
    made = cut(of, disc(128), flat_uv(of))
    at = made.positions[made.corner_vertices]
    assert made.uv == pytest.approx(at[:, :2] * (2, 3), abs=1e-12)
    assert made.corner_normals[:, 0] == pytest.approx(at[:, 0], abs=1e-6)
    assert made.corner_normals.dtype == np.float32
    assert made.reflectance == pytest.approx(at[:, 0], abs=1e-12)
    assert set(made.face_materials.tolist()) == {7} and set(made.face_textures.tolist()) == {0}


def test_creases_and_marks_are_as_long_as_what_is_left_of_them() -> None:
    strip = [(x, y, 0) for y in (0, 1) for x in (0, 1, 2)]
    seam = np.array([[4, 1]], np.int32)
    two = mesh(
        strip,
        [[0, 1, 4, 3], [1, 2, 5, 4]],
        edge_vertices=np.concatenate([seam, [[0, 1]]]).astype(np.int32),
        edge_sharpness=np.array([10.0, 3.0]),
        marked_edges=seam,
        loose_edges=np.array([[0, 5]], np.int32),
    )
    made = cut(two, disc(256, 0.2, (0.5, 0.25)), flat_uv(two, 0.5))
    for pairs in (made.edge_vertices, made.marked_edges):
        ends = made.positions[pairs]
        assert (np.abs(ends[:, :, 0] - 1) < 1e-9).all()
        assert np.abs(ends[:, 0, 1] - ends[:, 1, 1]).sum() == pytest.approx(0.8, abs=0.01)
    assert set(made.edge_sharpness.tolist()) == {10.0}
    assert made.positions[made.loose_edges[0]].tolist() == [[0, 0, 0], [2, 1, 0]]


def test_points_lie_on_bent_quads() -> None:
    bent = mesh([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)], [[0, 1, 2, 3]])
    made = cut(bent, disc(128))
    x, y, z = made.positions.T
    assert z == pytest.approx(x * y, abs=1e-12)


def test_bounds_make_cells_wider_and_say_so(monkeypatch: Any) -> None:
    of = card()
    fine = cut_by_alpha(of, flat_uv(of), [0], [AlphaImage(disc(256))])
    assert not fine.is_coarse
    monkeypatch.setattr(cutting, "MOST_CUT", 30)
    coarse = cut_by_alpha(of, flat_uv(of), [0], [AlphaImage(disc(256))])
    assert coarse.is_coarse and loops(coarse.mesh) == 1
    assert len(coarse.mesh.face_sizes) < len(fine.mesh.face_sizes) / 4
    assert area(coarse.mesh) == pytest.approx(math.pi * RADIUS**2, rel=0.1)


@pytest.mark.parametrize("texels", [(1, 1), (1, 64), (64, 3)])
def test_images_of_any_form(texels: Any) -> None:
    made = cut(card(), np.full(texels, 0.4))
    assert len(made.face_sizes) == 0


def test_places_that_are_not_finite_crack_nothing() -> None:
    for wrong in (math.nan, math.inf, 1e30):
        uv = flat_uv(card())
        uv[2] = wrong
        boundary(cut(card(), disc(16), uv))
    of = card()
    of.positions[1] = math.nan
    boundary(cut(of, disc(16), np.array(SQUARE, float)[:, :2]))


def test_wrong_arguments_are_named() -> None:
    of = card()
    with pytest.raises(ValueError, match="uv: expected shape"):
        cut_by_alpha(of, np.zeros((3, 2)), [0], [AlphaImage([[1]])])
    with pytest.raises(ValueError, match="face_images: expected shape"):
        cut_by_alpha(of, flat_uv(of), [0, 0], [AlphaImage([[1]])])
    with pytest.raises(ValueError, match="face_images: numbers"):
        cut_by_alpha(of, flat_uv(of), [1], [AlphaImage([[1]])])
    with pytest.raises(ValueError, match="values"):
        AlphaImage([1.0])
    with pytest.raises(ValueError, match="wrap"):
        AlphaImage([[1.0]], "twice")
    with pytest.raises(ValueError, match="threshold"):
        AlphaImage([[1.0]], threshold=math.nan)


def test_parts_hang_together_by_vertices() -> None:
    places = [(x, y, 0) for x in range(6) for y in (0, 1)]
    faces = [[0, 2, 3, 1], [2, 4, 5, 3], [6, 8, 9, 7]]
    of = mesh(places, faces, marked_edges=np.array([[2, 3], [8, 9]], np.int32))
    together = mesh_parts.hanging_together(of, np.array([True, False, False]))
    assert together.tolist() == [True, True, False]
    part = mesh_parts.faces_alone(of, ~together, with_loose=False)
    assert part.positions[part.corner_vertices].tolist() == [list(places[i]) for i in faces[2]]
    assert part.positions[part.marked_edges].tolist() == [[[4, 0, 0], [4, 1, 0]]]
