"""What every drawing has to fulfil, whatever was drawn."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
from numpy.typing import NDArray
from shapes import Shape

LEVEL = 2

# An arc ends at its node: far above the image grid of 2^-16 px, far below anything visible.
MEET_PX = 0.05

# The end of a stroke lies at a node: five times the 0.1 px of simplification.
END_PX = 0.5

# Layers that a curve gains or loses where it passes behind one of this kind. Creases hide nothing
# between two front faces, and as much as a silhouette at a fold.
LAYERS_HIDDEN_BY = {
    ill.Kind.SILHOUETTE: {2}, ill.Kind.BOUNDARY: {1}, ill.Kind.SEAM: {1},
    ill.Kind.CREASE: {0, 2}, ill.Kind.MARK: {0, 2}, ill.Kind.MATERIAL: {0, 2},
    ill.Kind.FLAT_OUTLINE: {0, 2}, ill.Kind.INTERSECTION: {0}, ill.Kind.SUGGESTIVE: {0},
    ill.Kind.RIDGE: {0}, ill.Kind.VALLEY: {0}, ill.Kind.LOOSE: {0}, ill.Kind.TERMINATOR: {0},
    ill.Kind.SHADOW_OUTLINE: {0},
}  # fmt: skip

STROKE_ARRAYS = (
    "points", "image", "widths", "triangles", "barycentrics", "offsets", "kinds", "closed",
    "objects", "invisibility",
)  # fmt: skip
GRAPH_ARRAYS = (
    "node_kind", "node_image", "node_arcs", "arc_nodes", "arc_kind", "arc_object",
    "arc_invisibility", "arc_flush", "arc_layers_over", "arc_offsets", "arc_image", "arc_points",
)  # fmt: skip


def arrays_of(drawing: ill.Drawing) -> dict[str, NDArray[np.generic]]:
    """Every public array of strokes, graph and tone."""
    found = {name: getattr(drawing, name) for name in STROKE_ARRAYS}
    found |= {"graph." + name: getattr(drawing.graph, name) for name in GRAPH_ARRAYS}
    return found | {"tone." + name: getattr(drawing.tone, name) for name in ("level", "band")}


def digest(drawing: ill.Drawing) -> list[bytes]:
    """Every byte of a drawing."""
    return [array.tobytes() for array in arrays_of(drawing).values()]


def check_drawing(drawing: ill.Drawing, camera: ill.Camera) -> None:
    """Fails with the first rule that the drawing breaks."""
    check_strokes(drawing, camera)
    check_offsets(drawing.graph)
    check_incidence(drawing.graph)
    check_labels(drawing.graph)
    check_line_ends(drawing, camera)


def prepared_of(*shapes: Shape, **options: Any) -> ill.Prepared:
    """`ill.prepare` of shapes at LEVEL."""
    return ill.prepare([s.mesh() for s in shapes], ill.PrepareOptions(level=LEVEL, **options))


def draw(prepared: ill.Prepared, camera: ill.Camera, *more: Any, **named: Any) -> ill.Drawing:
    """`ill.draw`, and the drawing is checked."""
    drawing = ill.draw(prepared, camera, *more, **named)
    check_drawing(drawing, camera)
    return drawing


def lengths_px(drawing: ill.Drawing) -> NDArray[np.float64]:
    """(strokes,) of each in the image."""
    steps = np.r_[np.linalg.norm(np.diff(drawing.image, axis=0), axis=1), 0.0]
    steps[drawing.offsets[1:] - 1] = 0  # from one stroke to the next
    return np.add.reduceat(steps, drawing.offsets[:-1])


def check_strokes(drawing: ill.Drawing, camera: ill.Camera) -> None:
    p, s = len(drawing.points), len(drawing.kinds)
    expected = {
        "points": (p, 3), "image": (p, 2), "widths": (p,), "triangles": (p,),
        "barycentrics": (p, 2), "offsets": (s + 1,), "kinds": (s,), "closed": (s,),
        "objects": (s,), "invisibility": (s,),
    }  # fmt: skip
    for name, shape in expected.items():
        assert getattr(drawing, name).shape == shape, name
    for name, array in arrays_of(drawing).items():
        assert array.dtype.kind != "f" or np.isfinite(array).all(), f"{name} is not finite"
    assert drawing.offsets[0] == 0
    assert drawing.offsets[-1] == p
    assert (np.diff(drawing.offsets) >= 2).all(), "a stroke has fewer than two points"
    assert (np.diff(drawing.kinds.astype(int)) >= 0).all(), "strokes are not sorted by kind"
    assert (drawing.kinds != ill.Kind.SEAM).all(), "a seam is drawn"
    assert (drawing.widths >= 0).all()
    frame = [camera.width_px, camera.height_px]
    assert ((drawing.image >= 0) & (drawing.image <= frame)).all(), "a point outside the frame"


def check_offsets(graph: ill.Graph) -> None:
    assert graph.arc_offsets[0] == 0
    assert graph.arc_offsets[-1] == len(graph.arc_image) == len(graph.arc_points)
    assert (np.diff(graph.arc_offsets) >= 2).all(), "an arc has fewer than two points"


def check_incidence(graph: ill.Graph) -> None:
    """node_arcs and arc_nodes agree, and arcs end where their nodes are."""
    ends = np.stack([graph.arc_image[graph.arc_offsets[:-1]],
                     graph.arc_image[graph.arc_offsets[1:] - 1]], axis=1)  # fmt: skip
    at_node: list[list[int]] = [[] for _ in graph.node_kind]
    for arc, nodes in enumerate(graph.arc_nodes):
        assert (nodes >= 0).all() or (nodes == -1).all(), f"arc {arc} has one node"
        for end, node in zip(ends[arc], nodes, strict=True):
            if node < 0:
                continue
            at_node[node].append(arc)
            gap = np.linalg.norm(end - graph.node_image[node])
            assert gap < MEET_PX, f"arc {arc} ends {gap} px from its node"
    slots = {ill.Node.CROSSING: 4, ill.Node.CUSP: 2}
    for node, kind in enumerate(graph.node_kind):
        assert at_node[node], f"node {node} has no arcs"
        count = slots.get(ill.Node(int(kind)), 0)
        if count:
            assert sorted(graph.node_arcs[node, :count]) == sorted(at_node[node])


def check_labels(graph: ill.Graph) -> None:
    """The rules of quantitative invisibility at crossings and cusps."""
    layers = graph.arc_invisibility
    assert (layers >= 0).all(), "a negative number of layers"
    for front_in, front_out, back_in, back_out in graph.node_arcs[graph.node_kind == 1]:
        assert layers[front_in] == layers[front_out], "a front curve changes at a crossing"
        assert min(layers[back_in], layers[back_out]) >= layers[front_in]
        hidden = LAYERS_HIDDEN_BY[ill.Kind(int(graph.arc_kind[front_in]))]
        assert abs(layers[back_in] - layers[back_out]) in hidden, "a wrong step behind a curve"
    for near, far, *_ in graph.node_arcs[graph.node_kind == 0]:
        assert layers[far] == layers[near] + 1, "a cusp's far branch is not one layer deeper"


def check_line_ends(drawing: ill.Drawing, camera: ill.Camera) -> None:
    """Lines end at nodes of the graph or at the frame."""
    hatches = (ill.Kind.HATCH, ill.Kind.CROSS_HATCH, ill.Kind.UNDERCUT)
    lines = np.flatnonzero(~drawing.closed & ~np.isin(drawing.kinds, hatches))
    ends = np.concatenate([drawing.offsets[lines], drawing.offsets[lines + 1] - 1])
    frame = [camera.width_px, camera.height_px]
    for xy in drawing.image[ends]:
        at_frame = min(*xy, *(frame - xy)) < MEET_PX
        to_nodes = np.linalg.norm(drawing.graph.node_image - xy, axis=1)
        assert at_frame or to_nodes.min(initial=np.inf) < END_PX, f"a line ends at nothing: {xy}"
