"""Labels and lines of shapes given by formulas: exact counts, layers by brute force, steadiness."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import draw
from numpy.typing import NDArray
from shapes import (
    Shape,
    drape,
    grid_quads,
    klein_bottle,
    look_at,
    of_quads,
    plate,
    sphere,
    torus,
)

LINES = ill.DrawOptions(hatching=False)
# Nothing that depends on which other lines meet an end: no specks, no thin ends.
ALIKE: dict[str, Any] = {"hatching": False, "speck_px": 0, "taper_px": 0}
LARGE_PX = 512
CAMERAS = [
    look_at(direction, 1.9, perspective=perspective, size_px=LARGE_PX)
    for direction in ((1.0, -2.0, 0.8), (-1.1, -0.3, 0.35), (0.2, 0.9, -1.3))
    for perspective in (True, False)
]


def prepared_of(*shapes: Shape, level: int = 2) -> ill.Prepared:
    options = ill.PrepareOptions(scheme="catmull-clark", level=level, field=False)
    return ill.prepare([s.mesh() for s in shapes], options)


def blob() -> Shape:
    """A ball with bumps and hollows: folds, cusps and swallowtails in most views."""
    ball = sphere(16)
    x, y, z = ball.positions.T
    radius = 1 + 0.22 * np.sin(3.1 * x + 1) * np.sin(3.7 * y + 2) + 0.16 * np.sin(5.3 * z + 4 * x)
    return Shape(ball.positions * radius[:, None], ball.face_sizes, ball.corner_vertices)


SMOOTH = {"blob": blob(), "torus": torus(), "klein bottle": klein_bottle(), "drape": drape()}


# --- the torus: R = 1, r = 0.4, seen along directions whose angle to the axis has cosine b


def loops_of(graph: ill.Graph) -> list[list[int]]:
    """The labels along each closed chain of silhouettes, each run of equal ones once."""
    following: dict[int, int] = {}
    for node, kind in enumerate(graph.node_kind):
        if kind == ill.Node.CROSSING:
            front_in, front_out, back_in, back_out = graph.node_arcs[node]
            following |= {front_in: front_out, back_in: back_out}
        else:
            coming, going = (np.flatnonzero(graph.arc_nodes[:, side] == node) for side in (1, 0))
            following[coming[0]] = going[0]
    loops = []
    left = set(range(len(graph.arc_kind)))
    while left:
        arc = min(left)
        labels = []
        while arc in left:
            left.remove(arc)
            labels.append(int(graph.arc_invisibility[arc]))
            arc = following.get(arc, arc)
        loops.append([q for i, q in enumerate(labels) if q != labels[i - 1] or len(labels) == 1])
    return loops


def is_turned(labels: list[int], expected: list[int]) -> bool:
    """Whether two cycles are the same, wherever they start and whichever way they run."""
    turns = [expected[i:] + expected[:i] for i in range(len(expected))]
    return labels in turns or labels[::-1] in turns


@pytest.mark.parametrize("perspective", [True, False])
@pytest.mark.parametrize(
    ("cosine", "cusps", "crossings", "inner"),
    [(0.8, 0, 0, [0]), (0.5, 4, 2, [0, 1, 2, 0, 2, 1]), (0.2, 4, 0, [0, 1, 2, 1])],
)
def test_labels_round_the_inner_loop_of_a_torus(
    perspective: bool, cosine: float, cusps: int, crossings: int, inner: list[int]
) -> None:
    direction = (np.sqrt(1 - cosine**2), 0.013, cosine)
    camera = look_at(direction, 1.5, perspective=perspective, size_px=LARGE_PX)
    graph = draw(prepared_of(torus(48, 24)), camera, LINES).graph
    assert (graph.node_kind == ill.Node.CUSP).sum() == cusps
    assert (graph.node_kind == ill.Node.CROSSING).sum() == crossings
    loops = sorted(loops_of(graph), key=len)
    assert loops[0] == [0], "the outer loop is visible"
    assert len(loops) == 2
    assert is_turned(loops[1], inner), loops[1]


# --- layers by brute force


def projected(camera: ill.Camera, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 3) image x, y in px and depth along the view axis."""
    seen = np.c_[points, np.ones(len(points))] @ camera.view.T
    clip = seen @ camera.projection.T
    x, y = (clip[:, :2] / clip[:, 3:]).T
    image = (x + 1) / 2 * camera.width_px, (1 - y) / 2 * camera.height_px
    return np.stack([*image, -seen[:, 2]], axis=1)


def depths_at(corners: NDArray[np.float64], xy: NDArray[np.float64]) -> NDArray[np.float64]:
    """The depth of each triangle (t, 3 corners, 3) that covers an image point."""
    a, b, c = (corners[:, k] for k in range(3))
    ab, ac, ap = (b - a)[:, :2], (c - a)[:, :2], xy - a[:, :2]
    area = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        v = (ap[:, 0] * ac[:, 1] - ap[:, 1] * ac[:, 0]) / area
        w = (ab[:, 0] * ap[:, 1] - ab[:, 1] * ap[:, 0]) / area
        inside = (v >= 0) & (w >= 0) & (v + w <= 1)
    depth = a[:, 2] + v * (b - a)[:, 2] + w * (c - a)[:, 2]
    return np.asarray(depth[inside])


def clear_samples(
    graph: ill.Graph, clear_px: float
) -> list[tuple[int, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]]:
    """(arc, image, image tangent, world) at middles of arcs' segments far from all other curves."""
    begins, ends = graph.arc_offsets[:-1], graph.arc_offsets[1:]
    arc_of = np.repeat(np.arange(len(begins)), ends - begins)
    found = []
    for arc, (begin, end) in enumerate(zip(begins, ends, strict=True)):
        middle = (begin + end) // 2
        step = graph.arc_image[middle] - graph.arc_image[middle - 1]
        length = float(np.linalg.norm(step))
        if not length > 0:
            continue
        xy = (graph.arc_image[middle] + graph.arc_image[middle - 1]) / 2
        away = np.linalg.norm(graph.arc_image - xy, axis=1)
        along = np.abs(np.arange(len(arc_of)) - middle)
        others = (arc_of != arc) | (along > 2 * clear_px / max(length, 0.1))
        if away[others].min(initial=np.inf) > clear_px:
            world = (graph.arc_points[middle] + graph.arc_points[middle - 1]) / 2
            found.append((arc, xy, step / length, world))
    return found


@pytest.mark.parametrize("name", ["blob", "torus", "klein bottle"])
def test_labels_are_the_layers_that_rays_count(name: str) -> None:
    """On a surface one level finer, a ray two pixels beside the curve, off its own surface."""
    coarse, fine = (prepared_of(SMOOTH[name], level=level) for level in (2, 3))
    scale = 1 if name != "klein bottle" else 2.2
    asked = 0
    for camera in CAMERAS:
        camera = look_at(tuple(camera.view[2, :3]), 1.9 * scale,
                         perspective=camera.projection[3, 3] == 0, size_px=LARGE_PX)  # fmt: skip
        corners = projected(camera, fine.surface.positions)[fine.surface.triangles]
        graph = draw(coarse, camera, LINES).graph
        for arc, xy, along, world in clear_samples(graph, 6):
            if graph.arc_kind[arc] != ill.Kind.SILHOUETTE:
                continue
            beside = xy + 2 * np.array([-along[1], along[0]])  # the right side: y is down
            depth = projected(camera, world[None])[0, 2]
            layers = (depths_at(corners, beside) < depth).sum()
            assert layers == graph.arc_invisibility[arc], (name, xy)
            asked += 1
    assert asked >= 12


# --- steadiness


def visible_lines(drawing: ill.Drawing) -> tuple[int, float]:
    """How many visible lines, and their length in px."""
    length = 0.0
    for s in range(len(drawing.kinds)):
        line = drawing.image[drawing.offsets[s] : drawing.offsets[s + 1]]
        if drawing.closed[s]:
            line = np.r_[line, line[:1]]
        length += np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    return len(drawing.kinds), length


@pytest.mark.parametrize("name", ["blob", "torus"])
def test_levels_of_one_surface_give_the_same_lines(name: str) -> None:
    amounts = np.array([
        np.sum([visible_lines(draw(prepared_of(SMOOTH[name], level=level), camera, LINES))
                for camera in CAMERAS], axis=0)
        for level in (2, 3, 4)
    ])  # fmt: skip
    count, length = np.ptp(amounts, axis=0) / amounts.max(axis=0)
    assert count <= 0.05
    assert length <= 0.01


@pytest.mark.parametrize("name", ["blob", "torus", "drape"])
def test_lines_are_steady_along_an_orbit(name: str) -> None:
    prepared = prepared_of(SMOOTH[name], level=3)
    counts = []
    for angle in np.radians(0.5) * np.arange(61):
        direction = (np.cos(angle), np.sin(angle), np.tan(np.radians(20)))
        camera = look_at(direction, 1.9, size_px=LARGE_PX)
        counts.append(len(draw(prepared, camera, LINES).kinds))
    changes = np.abs(np.diff(counts))
    assert np.median(changes) <= 1
    assert changes.max() <= 3


def shallow_fold(pixel: float) -> Shape:
    """A sheet that folds over in a loop of two cusps, 20 px long, 12 wide and 2 deep."""
    s, t = (x.ravel() for x in np.meshgrid(*2 * [np.arange(-22.0, 22.1)], indexing="ij"))
    positions = pixel * np.stack([(s**3 + s * (t**2 - 100)) / 60, t, 0.1 * s], axis=1)
    return of_quads(positions, grid_quads(45, 45, wrap_rows=False, wrap_columns=False))


def test_a_shallow_fold_is_hidden_by_a_wall() -> None:
    camera = look_at((0.0, 0.0, 1.0), 1.0, perspective=False, size_px=LARGE_PX)
    wall = of_quads(
        np.array([[-0.9, -0.9, 1], [0.9, -0.9, 1], [0.9, 0.9, 1], [-0.9, 0.9, 1]]),
        np.array([[0, 1, 2, 3]]),
    )
    prepared = prepared_of(shallow_fold(pixel=2 / LARGE_PX), wall, level=1)
    graph = draw(prepared, camera, LINES).graph
    folds = graph.arc_kind == ill.Kind.SILHOUETTE
    assert (graph.node_kind == ill.Node.CUSP).sum() == 2
    assert sorted(graph.arc_invisibility[folds]) == [1, 2]


@pytest.mark.parametrize("name", list(SMOOTH))
def test_repairs_of_smooth_surfaces_are_below_a_pixel(name: str) -> None:
    prepared = prepared_of(SMOOTH[name], level=2)
    radius = 4.2 if name == "klein bottle" else 1.9
    for direction in np.random.default_rng(4).normal(size=(12, 3)):
        drawing = draw(prepared, look_at(tuple(direction), radius, size_px=LARGE_PX), LINES)
        assert drawing.repair_max_px <= 1


# --- what is asked for


def strokes(drawing: ill.Drawing, chosen: NDArray[np.bool_]) -> list[bytes]:
    """The image points of the chosen strokes."""
    starts, ends = drawing.offsets[:-1][chosen], drawing.offsets[1:][chosen]
    return [drawing.image[a:b].tobytes() for a, b in zip(starts, ends, strict=True)]


# --- flat faces


@pytest.mark.parametrize(("sides", "wobble"), [(3, 0.0), (4, 0.0), (5, 0.0), (24, 0.08)])
def test_flat_faces_between_creases_carry_no_lines(sides: int, wobble: float) -> None:
    """Their limit folded over itself: silhouettes ran through it, and it passed through the next
    face."""
    mesh = plate(sides, wobble).mesh(crease_angle_deg=60.0, scheme="loop")
    prepared = ill.prepare([mesh], ill.PrepareOptions(level=4, field=False))
    for camera in CAMERAS:
        drawing = draw(prepared, camera, LINES)
        assert not (drawing.graph.arc_kind == ill.Kind.INTERSECTION).any()
        assert drawing.counts["repairs"] == drawing.counts["unbalanced_loops"] == 0
        if sides < 6:
            assert not (drawing.graph.arc_kind == ill.Kind.SILHOUETTE).any()


# --- hidden lines and styles


def test_hidden_lines_are_drawn_by_their_layers() -> None:
    prepared, camera = prepared_of(SMOOTH["blob"], torus().moved((0.3, 1.9, 0.1))), CAMERAS[0]

    def drawn(low: int, high: int) -> ill.Drawing:
        return draw(prepared, camera, ill.DrawOptions(hidden_lines=(low, high), **ALIKE))

    visible, every = draw(prepared, camera, ill.DrawOptions(**ALIKE)), drawn(1, 99)
    assert set(every.invisibility) == set(every.graph.arc_invisibility) > {0, 1, 2}
    for low, high in ((1, 1), (2, 2), (1, 2), (2, 99), (3, 3)):
        asked = drawn(low, high)
        hidden = asked.invisibility > 0
        assert set(asked.invisibility[hidden]) <= set(range(low, high + 1))
        wanted = (every.invisibility >= low) & (every.invisibility <= high)
        assert strokes(asked, hidden) == strokes(every, wanted)
        assert strokes(asked, ~hidden) == strokes(visible, visible.invisibility == 0)
    with pytest.raises(ill.InvalidInput, match="hidden_lines"):
        drawn(3, 2)


def test_glass_hides_nothing_and_keeps_its_own_outlines() -> None:
    """A torus before a sphere; a third shape hides a part of the torus."""
    shapes = [torus().moved((0.0, -2.0, 0.1)), sphere(), sphere().moved((1.2, -4.0, 0.4))]
    camera = look_at((0.15, -1.0, 0.2), 3.6, size_px=LARGE_PX)
    prepared = prepared_of(*shapes)

    def drawn(*styles: ill.ObjectStyle) -> ill.Drawing:
        return ill.draw(prepared, camera, ill.DrawOptions(styles=styles, **ALIKE))

    usual, ignored = ill.ObjectStyle(), ill.ObjectStyle(ignore=True)
    glass = drawn(ill.ObjectStyle(see_through=True), usual, usual)
    without, whole = drawn(ignored, usual, usual), drawn(usual, usual, usual)
    is_glass = glass.objects == 0
    assert strokes(glass, ~is_glass) == strokes(without, without.objects > 0)
    assert strokes(glass, is_glass) == strokes(whole, whole.objects == 0)
    assert is_glass.any() and (~is_glass).any()


def test_styles_change_no_line_of_others() -> None:
    """Three shapes, each partly behind the one before."""
    shapes = [sphere(), torus().moved((-0.6, 1.9, 0.2)), sphere().moved((-1.5, 4.2, -0.9))]
    camera = look_at((0.15, -1.0, 0.2), 3.6, centre=(0.0, 1.9, 0.0), size_px=LARGE_PX)
    prepared = prepared_of(*shapes)

    def drawn(**first: Any) -> ill.Drawing:
        styles = [ill.ObjectStyle(**first), ill.ObjectStyle(), ill.ObjectStyle()]
        return draw(prepared, camera, ill.DrawOptions(styles=styles, **ALIKE))

    plain = drawn()
    assert set(plain.objects) == {0, 1, 2}
    for quiet in ({"occlude_only": True}, {"lines": False}):
        hiding = drawn(**quiet)
        assert set(hiding.objects) == {1, 2}
        assert strokes(hiding, hiding.objects > 0) == strokes(plain, plain.objects > 0)
    alone = draw(prepared_of(*shapes[1:]), camera, ill.DrawOptions(**ALIKE))
    without = drawn(ignore=True)
    assert strokes(without, without.objects > 0) == strokes(alone, alone.objects >= 0)
    assert set(without.objects) == {1, 2}
    assert strokes(without, without.objects > 0) != strokes(plain, plain.objects > 0)
