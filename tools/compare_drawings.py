"""Compares SVG drawings of the same scenes that two systems made.

Same bytes are best. The C libraries of systems round acos, atan2, exp, hypot and others otherwise
in the last bit, and where a hatch begins may hang on that bit. So the lines of the shape must lie
in the same place, and the hatches, as a whole, must be as long.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import shapely
from suites import Outcome

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
SVG = "{http://www.w3.org/2000/svg}"
HATCHES = ("hatch", "cross-hatch", "undercut")
MOST_APART_PX = 0.05
"""Coordinates have two digits, and of two neighbours on a curve another may be kept."""
MOST_LENGTH = 0.02
"""Share by which hatches may be longer or shorter, all together."""

Layers = dict[str, list[str]]


def layers_of(drawing: Path) -> Layers:
    """The paths of each layer, in their order."""
    root = ElementTree.parse(drawing).getroot()
    return {
        group.get("id", ""): [path.get("d", "") for path in group.iter(f"{SVG}path")]
        for group in root.iter(f"{SVG}g")
    }


def shape_of(paths: list[str]) -> shapely.MultiLineString:
    """Their polylines."""
    lines = []
    for part in (part for path in paths for part in path.split("M")[1:]):
        numbers = [float(number) for number in NUMBER.findall(part)]
        lines.append(list(zip(numbers[::2], numbers[1::2], strict=True)))
    return shapely.MultiLineString([line for line in lines if len(line) > 1])


def apart(here: list[str], there: list[str]) -> float:
    """How far points of one lie from the other at most, in pixels."""
    first, second = shape_of(here), shape_of(there)
    return float(shapely.hausdorff_distance(first, second)) if here and there else float("inf")


def judge(here: Layers, there: Layers) -> tuple[bool, str]:
    """Whether two drawings agree, and how far."""
    if here.keys() != there.keys():
        return False, f"layers {', '.join(here)} and {', '.join(there)}"
    lines = [name for name in here if name not in HATCHES and here[name] != there[name]]
    farthest = max((apart(here[name], there[name]) for name in lines), default=0.0)
    hatches = [name for name in here if name in HATCHES]
    both = [[path for name in hatches for path in drawing[name]] for drawing in (here, there)]
    same = len(set(both[0]) & set(both[1])) / max(len(both[0]), 1)
    lengths = [shape_of(paths).length for paths in both]
    longer = lengths[1] / lengths[0] - 1 if lengths[0] else 0.0
    agrees = farthest <= MOST_APART_PX and abs(longer) <= MOST_LENGTH
    return agrees, (f"lines {farthest:.4f} px apart at most; of {len(both[0])} hatches "
                    f"{same:.0%} the same, all together {longer:+.2%} long")  # fmt: skip


def outcome(here: Path, there: Path, scenes: tuple[str, ...]) -> Outcome:
    """A test for each scene: whether the two drawings agree. Prints how far each does."""
    found = Outcome()
    for scene in scenes:
        first, second = (folder / f"{scene}.svg" for folder in (here, there))
        agrees, how = True, "the same bytes"
        if first.read_bytes() != second.read_bytes():
            agrees, how = judge(layers_of(first), layers_of(second))
        print(f"{scene}: {how}")
        found.counts["passed" if agrees else "failed"] += 1
    return found
