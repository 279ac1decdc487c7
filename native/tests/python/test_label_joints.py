"""Labels at joints of shapes with known answers, and the vote beside them."""

from __future__ import annotations

from dataclasses import replace

import illustrate_native as ill
import numpy as np
import pytest
from numpy.typing import NDArray
from shapes import Shape, grid_quads, klein_bottle, look_at, of_quads, sphere, torus

DIRECTIONS = [(1.0, -2.0, 0.8), (-1.5, -0.4, -1.0), (0.3, 0.9, 1.7), (-0.2, 1.0, 0.15)]


def tube(rows: int = 16, columns: int = 32) -> Shape:
    """A cylinder without caps."""
    z, u = np.meshgrid(np.linspace(-1, 1, rows), 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")  # fmt: skip
    positions = np.stack([np.cos(u), np.sin(u), z], axis=-1).reshape(-1, 3)
    return of_quads(positions, grid_quads(rows, columns, False, True))


def bowl(rows: int = 16, columns: int = 32) -> Shape:
    """A hemisphere without its pole, open above and at a small hole below."""
    v, u = np.meshgrid(np.linspace(0.2, np.pi / 2, rows), 2 * np.pi * np.arange(columns) / columns,
                       indexing="ij")  # fmt: skip
    positions = np.stack([np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), -np.cos(v)], axis=-1)
    return of_quads(positions.reshape(-1, 3), grid_quads(rows, columns, False, True))


def moebius(columns: int = 48, rows: int = 9) -> Shape:
    u, w = np.meshgrid(2 * np.pi * np.arange(columns) / columns, np.linspace(-0.4, 0.4, rows),
                       indexing="ij")  # fmt: skip
    radius = 1 + w * np.cos(u / 2)
    positions = np.stack([radius * np.cos(u), radius * np.sin(u), w * np.sin(u / 2)], axis=-1)
    quads = grid_quads(columns, rows, False, False)
    last, first = (columns - 1) * rows + np.arange(rows), np.arange(rows)[::-1]
    closing = np.stack([last[:-1], last[1:], first[1:], first[:-1]], axis=-1)
    return of_quads(positions.reshape(-1, 3), np.concatenate([quads, closing]))


def lines_of(
    shape: Shape, direction: tuple[float, float, float], visibility: str = "labels"
) -> ill.Drawing:
    options = ill.PrepareOptions(level=3, field=False)
    camera = look_at(direction, radius=3.2 if len(shape.positions) == 512 else 1.8, size_px=1024)
    return ill.draw(
        ill.prepare([shape.mesh()], options),
        camera,
        ill.DrawOptions(hatching=False, visibility=visibility),
    )


def lengths(graph: ill.Graph) -> NDArray[np.float64]:
    """Of the arcs (a,), px."""
    steps = np.r_[np.linalg.norm(np.diff(graph.arc_image, axis=0), axis=1), 0.0]
    steps[graph.arc_offsets[1:] - 1] = 0
    return np.add.reduceat(steps, graph.arc_offsets[:-1])


def differences_at_joints(graph: ill.Graph) -> list[list[int]]:
    """Labels of the two boundary arcs less that of the contour that runs into them, sorted."""
    found = []
    for node in np.flatnonzero(graph.node_kind == ill.Node.JOINT):
        arcs = np.flatnonzero((graph.arc_nodes == node).any(axis=1))
        contours = arcs[graph.arc_kind[arcs] == ill.Kind.SILHOUETTE]
        boundaries = arcs[graph.arc_kind[arcs] == ill.Kind.BOUNDARY]
        if len(contours) == 1 and len(boundaries) == 2:
            labels = graph.arc_invisibility
            found.append(sorted(int(labels[b] - labels[contours[0]]) for b in boundaries))
    return found


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("shape", [tube(), bowl(), moebius()])
def test_open_sheets_need_no_repairs(shape: Shape, direction: tuple[float, float, float]) -> None:
    drawing = lines_of(shape, direction)
    assert drawing.counts["unbalanced_loops"] == 0
    assert drawing.counts["repairs"] == 0


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("shape", [tube(), bowl()])
def test_boundaries_go_on_as_hidden_as_contours_or_by_a_layer_more(
    shape: Shape, direction: tuple[float, float, float]
) -> None:
    joints = differences_at_joints(lines_of(shape, direction).graph)
    assert all(d in ([0, 0], [0, 1]) for d in joints)


def ball_in_a_torus() -> list[Shape]:
    ball = sphere(6)
    return [torus(), replace(ball, positions=0.5 * ball.positions + (0.9, 0.1, 0.1))]


PIERCED = {
    "ball in a torus": (ball_in_a_torus(), 1.7),
    "klein bottle, along its edges": ([klein_bottle()], 4.2),
}


@pytest.mark.parametrize("name", list(PIERCED))
def test_what_passes_through_a_surface_comes_out_again(name: str) -> None:
    """Closed contours and intersection curves balance; three of them may meet within a pixel."""
    made, radius = PIERCED[name]
    options = ill.PrepareOptions(scheme="catmull-clark", level=2, field=False)
    prepared = ill.prepare([shape.mesh() for shape in made], options)
    loops = unbalanced = 0
    count = 100
    height = 1 - (2 * np.arange(count) + 1) / count
    around = np.pi * (1 + np.sqrt(5)) * (np.arange(count) + 0.5)
    for k, (z, angle) in enumerate(zip(height, around, strict=True)):
        ring = np.sqrt(1 - z * z)
        direction = (ring * np.cos(angle), ring * np.sin(angle), z)
        camera = look_at(direction, radius, perspective=k % 2 == 1, size_px=512)
        counts = ill.draw(prepared, camera, ill.DrawOptions(hatching=False)).counts
        loops += counts["loops"]
        unbalanced += counts["unbalanced_loops"]
    assert unbalanced <= 0.01 * loops


def test_contours_of_a_tube_end_in_joints() -> None:
    assert len(differences_at_joints(lines_of(tube(), DIRECTIONS[0]).graph)) == 4


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_vote_mostly_agrees_with_labels(direction: tuple[float, float, float]) -> None:
    labelled, voted = (lines_of(torus(), direction, how) for how in ("labels", "vote"))
    np.testing.assert_array_equal(labelled.graph.arc_nodes, voted.graph.arc_nodes)
    assert set(voted.graph.arc_invisibility) <= {0, 1}
    same = (labelled.graph.arc_invisibility > 0) == (voted.graph.arc_invisibility > 0)
    length = lengths(labelled.graph)
    assert length[same].sum() > 0.9 * length.sum()
    assert "repairs" not in voted.counts


def test_vote_is_not_the_default() -> None:
    assert ill.DrawOptions().visibility == "labels"
    with pytest.raises(ill.InvalidInput, match="visibility is 'z-buffer', expected 'labels' or"):
        ill.DrawOptions(visibility="z-buffer")


def test_vote_draws_what_passes_through_itself() -> None:
    assert len(lines_of(klein_bottle(), DIRECTIONS[0], "vote").kinds) > 0
