"""The sketches of docs/glossary.md: one function a notion, in its order.

    .venv/bin/python tools/docs/glossary_sketches.py [--out docs/pictures/glossary]

Network, strands, paths, arcs and strokes are those of one real view; the others are drawn from
formulas.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
from sketch import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, Sketch
from views import ROOT, ring_and_ball

CYCLE = (BLACK, ORANGE, BLUE, GREEN, RED, PINK, SKY)
NODE_COLOURS = {ill.Node.CUSP: RED, ill.Node.CROSSING: BLUE, ill.Node.JOINT: GREEN}
PAPER, SHADE = "#f3f1ec", "#dcd8cf"


def curve(x: Any, y: Any) -> Any:
    """(n, 2) points."""
    return np.stack(np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float)), axis=-1)


def circle(x: float, y: float, radius: float, start: float = 0, end: float = 360) -> Any:
    """Points of an arc of a circle, degrees, clockwise on the page."""
    angle = np.radians(np.linspace(start, end, max(int((end - start) / 6), 8)))
    return curve(x + radius * np.cos(angle), y + radius * np.sin(angle))


# The words for a part of a curve, on one view.


class OneView:
    """The curves of a real view, and which arcs make one strand or one path."""

    def __init__(self) -> None:
        self.drawing = ring_and_ball((200, 130), hatching=False).drawn()[1]
        self.graph = self.drawing.graph
        self.strands = self._joined((ill.Node.CROSSING,))
        self.paths = self._joined((ill.Node.CROSSING, ill.Node.CUSP))

    def _joined(self, through: tuple[ill.Node, ...]) -> Any:
        """(arcs) numbers that arcs share which go on into each other at nodes of these kinds."""
        number = np.arange(len(self.graph.arc_kind))
        for kind, arcs in zip(self.graph.node_kind, self.graph.node_arcs, strict=True):
            if kind not in through:
                continue
            pairs = [arcs[:2], arcs[2:]] if kind == ill.Node.CROSSING else [arcs[:2]]
            for a, b in pairs:
                number[number == number[b]] = number[a]
        return np.unique(number, return_inverse=True)[1]

    def sketch(self, numbers: Any = None, nodes: tuple[ill.Node, ...] = ()) -> Sketch:
        """All arcs, in a colour for each number; None: in black."""
        graph, made = self.graph, Sketch(200, 130)
        for arc in range(len(graph.arc_kind)):
            colour = BLACK if numbers is None else CYCLE[numbers[arc] % len(CYCLE)]
            span = slice(graph.arc_offsets[arc], graph.arc_offsets[arc + 1])
            is_closed = bool(graph.arc_nodes[arc, 0] < 0)
            made.line(graph.arc_image[span], colour, 1.3, closed=is_closed)
        for kind in nodes:
            made.dots(graph.node_image[graph.node_kind == kind], NODE_COLOURS[kind], 2.6)
        return made


VIEW = OneView()


def network() -> Sketch:
    return VIEW.sketch(nodes=(ill.Node.CUSP, ill.Node.JOINT))


def strand() -> Sketch:
    return VIEW.sketch(VIEW.strands, (ill.Node.CUSP, ill.Node.JOINT))


def path() -> Sketch:
    return VIEW.sketch(VIEW.paths, (ill.Node.JOINT,))


def arc() -> Sketch:
    return VIEW.sketch(
        np.arange(len(VIEW.strands)), (ill.Node.CUSP, ill.Node.JOINT, ill.Node.CROSSING)
    )


def stroke() -> Sketch:
    made, drawing = Sketch(200, 130), VIEW.drawing
    for i in range(len(drawing.kinds)):
        span = slice(drawing.offsets[i], drawing.offsets[i + 1])
        made.line(drawing.image[span], CYCLE[i % len(CYCLE)], 2, closed=bool(drawing.closed[i]))
    return made


# Nodes.


def silhouette() -> Sketch:
    made = Sketch().line(circle(100, 52, 44), BLACK, 2, closed=True, fill=PAPER)
    for angle, colour in ((215, GREY), (180, BLACK), (145, GREY)):
        foot = circle(100, 52, 44, angle, angle + 6)[0]
        made.line([foot, foot + (foot - (100, 52)) * 0.6], colour)
    return made.text(20, 114, "normal across the sight")


def cusp() -> Sketch:
    t = np.linspace(0, 1, 30)
    near = curve(40 + 110 * t, 60 - 34 * t**1.5)
    far = curve(40 + 110 * t, 60 + 34 * t**1.5)
    made = Sketch().line(near, BLACK, 2).line(far, ORANGE, 1.4, "4 3").dots([(40, 60)])
    return made.text(154, 30, "near: n").text(136, 112, "far: n + 1", ORANGE)


def crossing() -> Sketch:
    t = np.linspace(-1, 1, 30)
    front, back = curve(100 + 70 * t, 60 - 30 * t + 12 * t**2), curve(100 + 12 * t**2, 60 + 50 * t)
    made = (
        Sketch()
        .line(front, BLACK, 2)
        .line(back[:15], BLACK, 1.6)
        .line(back[15:], ORANGE, 1.4, "4 3")
    )
    made.dots([(100, 60)], BLUE)
    return made.text(118, 20, "behind: n").text(118, 108, "n + 2", ORANGE).text(8, 66, "in front")


def joint() -> Sketch:
    t = np.linspace(0, 1, 20)
    made = Sketch().line([(20, 90), (180, 70)], BLUE, 2)
    made.line(curve(100 + 60 * t, 80 - 60 * t + 14 * t**2), BLACK, 2).dots([(100, 80)], GREEN)
    return made.text(20, 108, "boundary", BLUE).text(118, 26, "silhouette")


def layers() -> Sketch:
    made = Sketch()
    for x, colour in ((60, SHADE), (110, PAPER)):
        made.line(
            curve(x + np.array([0, 14, 14, 0]), [30, 18, 86, 98]), GREY, 1, closed=True, fill=colour
        )
    made.line([(20, 58), (166, 58)], BLUE, 1, "3 3").dots([(166, 58)], BLACK)
    return made.text(4, 54, "eye").text(150, 76, "2 layers")


# Thin features.


def lens() -> Sketch:
    t = np.linspace(0, 1, 60)
    bump = 16 * np.sin(np.pi * np.clip((t - 0.3) / 0.4, 0, 1)) - 3
    made = Sketch().line(curve(15 + 170 * t, 60 + 0 * t), BLACK, 2)
    made.line(curve(15 + 170 * t, 60 - bump), ORANGE, 1.6)
    return made.dots([(70, 60), (130, 60)], BLUE).text(56, 92, "two crossings")


def twist() -> Sketch:
    t = np.linspace(-1.5, 1.5, 80)
    made = Sketch().line(curve(100 + 60 * t**3 - 60 * t * 1.0, 96 - 40 * t**2), BLACK, 2)
    return made.dots([(100, 56)], BLUE).text(112, 60, "itself")


def swallowtail() -> Sketch:
    t = np.linspace(-1.2, 1.2, 120)
    x, y = 4 * t**3 - 4.2 * t, 3 * t**4 - 2.1 * t**2
    ends = np.sqrt(4.2 / 12) * np.array([-1, 1])
    made = Sketch().line(curve(100 + 25 * x, 62 + 32 * y), BLACK, 2)
    made.dots(curve(100 + 25 * (4 * ends**3 - 4.2 * ends), 62 + 32 * (3 * ends**4 - 2.1 * ends**2)))
    return made.text(80, 18, "two cusps", RED)


def touch() -> Sketch:
    t = np.linspace(-1, 1, 40)
    contour, over = curve(100 + 85 * t, 40 + 26 * t**2), curve(100 + 42 * t, 40 + 56 * t**2)
    made = Sketch().line(contour, BLACK, 2).line(over[:21], ORANGE, 1.6)
    made.line(over[20:], ORANGE, 1.4, "4 3").dots([(100, 40)], GREEN)
    return made.text(148, 86, "contour").text(14, 108, "curve through it", ORANGE)


def unit_of_paper() -> Sketch:
    made = Sketch().line([(30, 20), (170, 20), (170, 96), (30, 96)], BLACK, 1.4, closed=True)
    for i in range(1, 20):
        made.line([(30 + 7 * i, 96), (30 + 7 * i, 92)], GREY, 0.8)
    return made.text(30, 112, "1024 units, at any size")


# The surface.


def cage() -> Sketch:
    corners = np.array([(30, 96), (22, 30), (90, 14), (170, 28), (178, 92), (104, 108)], float)
    made = Sketch().line(corners, BLUE, 1.2, "4 3", closed=True).dots(corners, BLUE, 2.4)
    made.line(chaikin(corners), BLACK, 2, closed=True)
    return made.text(92, 66, "limit").text(30, 12, "cage", BLUE)


def chaikin(corners: Any) -> Any:
    """A closed quadratic B-spline, by cutting corners."""
    for _ in range(4):
        after = np.roll(corners, -1, axis=0)
        cut = np.stack([0.75 * corners + 0.25 * after, 0.25 * corners + 0.75 * after], axis=1)
        corners = cut.reshape(-1, 2)
    return corners


def level() -> Sketch:
    made = Sketch()
    for column, steps in enumerate((1, 2, 4)):
        left = 14 + 62 * column
        for i in range(steps + 1):
            at = 50 * i / steps
            made.line([(left + at, 34), (left + at, 84)], GREY, 1)
            made.line([(left, 34 + at), (left + 50, 34 + at)], GREY, 1)
        made.text(left + 20, 104, str(column))
    return made


def double_cover() -> Sketch:
    t = np.linspace(0, 2 * np.pi, 80)
    x, y = 100 + 70 * np.cos(t), 60 + 26 * np.sin(t)
    wave = 9 * np.cos(t / 2)
    made = Sketch().line(curve(x, y), GREY, 1, "3 3")
    made.line(curve(x, y - wave), BLACK, 1.8)
    return made.line(curve(x, y + wave), ORANGE, 1.8).text(70, 64, "two sheets")


def crease() -> Sketch:
    made = Sketch().line([(30, 80), (100, 30), (170, 80)], BLACK, 2)
    made.line([(65, 55), (50, 34)], GREY).line([(135, 55), (150, 34)], GREY).dots(
        [(100, 30)], GREEN
    )
    return made.text(54, 104, "two normals, one edge")


# The field.


def crosses(turn: Callable[[Any, Any], Any], made: Sketch) -> Sketch:
    """Crosses on a grid, turned by an angle of the place."""
    for x in range(20, 190, 20):
        for y in range(16, 112, 20):
            for quarter in (0, np.pi / 2):
                angle = turn(x - 100.0, y - 56.0) + quarter
                step, at = 7 * np.array([np.cos(angle), np.sin(angle)]), np.array([x, y])
                made.line([at - step, at + step], GREY, 1.2)
    return made


def cross_field() -> Sketch:
    return crosses(lambda x, y: 0.004 * x + 0.006 * y, Sketch())


def singularity() -> Sketch:
    return crosses(lambda x, y: np.arctan2(y, x + 1e-9) / 4, Sketch()).dots([(100, 56)], RED, 5)


def family() -> Sketch:
    made, t = Sketch(), np.linspace(0, 1, 20)
    for i in range(7):
        made.line(curve(20 + 160 * t, 16 + 14 * i + 10 * np.sin(np.pi * t)), BLACK, 1.2)
    for i in range(9):
        made.line(
            curve(24 + 19 * i, 16 + 84 * t + 10 * np.sin(np.pi * (4 + 19 * i) / 160)), ORANGE, 1
        )
    return made


def family_seam() -> Sketch:
    made, t = Sketch(), np.linspace(0, 1, 20)
    for i in range(7):
        made.line(curve(20 + 74 * t, 20 + 13 * i), BLACK, 1.3)
    for i in range(6):
        made.line(curve(106 + 13 * i, 16 + 84 * t), ORANGE, 1.3)
    return made.line([(98, 10), (101, 108)], RED, 1.2, "3 3")


# Hatches.


def hatch_curve(offset: float, start: float = 0.0, end: float = 1.0) -> Any:
    t = np.linspace(start, end, 30)
    return curve(14 + 172 * t, 24 + offset + 18 * np.sin(np.pi * t))


def curve_on_the_surface() -> Sketch:
    made = Sketch()
    for offsets, colour, width in (((0, 64), RED, 2), ((32,), ORANGE, 1.6), ((16, 48), SKY, 1.2)):
        for offset in offsets:
            made.line(hatch_curve(offset), colour, width)
    return made.text(20, 14, "1st", RED).text(48, 14, "2nd", ORANGE).text(80, 14, "3rd radius", SKY)


def streamline() -> Sketch:
    made = Sketch()
    for offset in (0, 30, 60):
        made.line(hatch_curve(offset), BLACK, 1.2).dots(hatch_curve(offset)[::4], BLUE, 2)
    return made


def hatch() -> Sketch:
    made = Sketch()
    for i, offset in enumerate((0, 14, 28, 42, 56, 70)):
        made.line(hatch_curve(offset, 0.05 * i, 0.9 - 0.06 * i), BLACK, 1.4)
    return made


def spacing() -> Sketch:
    made = Sketch().line(hatch_curve(10), BLACK, 1.4).line(hatch_curve(48), BLACK, 1.4)
    made.line([(100, 53), (100, 89)], RED, 1.2)
    return made.text(106, 76, "spacing", RED)


def tone() -> Sketch:
    made = Sketch()
    for i, fill in enumerate(("#fff", "#c4c4c4", "#808080")):
        left = 10 + 62 * i
        made.line(
            curve(left + np.array([0, 54, 54, 0]), [20, 20, 74, 74]),
            GREY,
            0.8,
            closed=True,
            fill=fill,
        )
        made.text(left, 92, ("highlight", "midtone", "shadow")[i])
    return made


def undercut() -> Sketch:
    made = Sketch().line(circle(100, 118, 60, 180, 360), BLACK, 2)
    made.line(circle(100, 118, 54, 185, 355), ORANGE, 9)
    made.line(circle(100, 118, 69, 190, 350), SKY, 14)
    return made.text(70, 98, "Mach band", ORANGE).text(12, 36, "undercut", BLUE)


def crumb() -> Sketch:
    made = Sketch()
    for offset in (0, 20, 40):
        made.line(hatch_curve(offset, 0, 0.55), BLACK, 1.4)
    made.line(hatch_curve(60, 0.1, 0.17), RED, 2).line(hatch_curve(20, 0.85, 0.93), RED, 2)
    return made.text(30, 112, "crumb", RED).text(140, 38, "tick", RED)


SKETCHES: tuple[Callable[[], Sketch], ...] = (
    network, strand, path, arc, stroke, silhouette, cusp, crossing, joint, layers, lens, twist,
    swallowtail, touch, unit_of_paper, cage, level, crease, double_cover, cross_field, singularity,
    family, family_seam, curve_on_the_surface, streamline, hatch, spacing, tone, undercut, crumb,
)  # fmt: skip


def main() -> None:
    """Writes every sketch."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "pictures" / "glossary")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    for sketch in SKETCHES:
        name = sketch.__name__.replace("_", "-")
        (folder / f"{name}.svg").write_text(sketch().svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
