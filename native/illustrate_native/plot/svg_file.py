"""A plot as SVG: user units are millimetres, a layer for each pen, one width in each.

Layers are Inkscape's, named as AxiDraw and vpype read them.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from .curves import Curves
from .outlines import outlines
from .pens import Layer
from .plans import Plot
from .regions import Region
from .strokes import Floats

_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
     version="1.1" width="{width}mm" height="{height}mm" viewBox="{left} {top} {width} {height}">"""
END = "</svg>"
REGIONS = "%Regions"
"""The layer of areas, which AxiDraw does not plot."""


def svg_of(plot: Plot, made_by: Mapping[str, Any] | None = None) -> str:
    """SVG text; the same plot gives the same. made_by: as of `illustrate_native.svg.to_svg`."""
    return "\n".join([*head(plot, made_by), *layers(plot), END, ""])


def head(plot: Plot, made_by: Mapping[str, Any] | None) -> Iterator[str]:
    """Up to the first layer."""
    left, top, right, bottom = plot.page.outer
    size = {"width": right - left, "height": bottom - top, "left": left, "top": top}
    yield _HEAD.format(**{name: number(value) for name, value in size.items()})
    if made_by is not None:
        yield f'<metadata id="illustrate">{escape(json.dumps(made_by))}</metadata>'


def layers(plot: Plot, prefix: str = "pen") -> Iterator[str]:
    """All layers as groups; prefix: of their ids, which are each their own in a file."""
    if plot.regions:
        yield f'<g id="{prefix}-regions" inkscape:groupmode="layer" inkscape:label="{REGIONS}">'
        yield from map(_region, plot.regions)
        yield "</g>"
    for place, layer in enumerate(plot.layers):
        name = f"{prefix}-{place + 1}"
        yield (
            f'<g id="{name}" inkscape:groupmode="layer" inkscape:label={quoteattr(layer.label)} '
            f"{_paint(layer)}>"
        )
        paths = _outlines(layer) if layer.pen.is_tapered else _paths(plot.curves(layer))
        yield from (f'<path d="{path}"/>' for path in paths)
        yield "</g>"


def number(value: float) -> str:
    """To a thousandth, without what says nothing."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _paint(layer: Layer) -> str:
    pen = layer.pen
    if pen.is_tapered:
        return f'fill="{pen.colour}" stroke="none"'
    return (
        f'fill="none" stroke="{pen.colour}" stroke-width="{number(pen.width_mm)}" '
        'stroke-linecap="round" stroke-linejoin="round"'
    )


def _outlines(layer: Layer) -> Iterator[str]:
    for rings in outlines(layer.strokes):
        yield "".join(_ring(ring) for ring in rings)


def _region(region: Region) -> str:
    rings = (_ring(ring) for polygon in region.polygons for ring in polygon)
    return (
        f'<path inkscape:label={quoteattr(region.name)} fill="{region.colour}" fill-rule="evenodd" '
        f'd="{"".join(rings)}"/>'
    )


def _ring(ring: Floats) -> str:
    hundredths = np.rint(ring * 100).astype(np.int64)
    steps = np.diff(hundredths, axis=0).tolist()
    return _path(["M", *["l"] * len(steps)], [hundredths[0].tolist(), *steps]) + "z"


def _paths(curves: Curves) -> Iterator[str]:
    """Path data of each stroke, relative, so that no rounding adds up."""
    controls = np.rint(curves.controls * 100).astype(np.int64)
    steps = (controls[:, 1:] - controls[:, :1]).reshape(-1, 6).tolist()
    starts, straight = controls[:, 0].tolist(), curves.straight.tolist()
    bounds = zip(curves.offsets[:-1].tolist(), curves.offsets[1:].tolist(), strict=True)
    for (first, last), is_closed in zip(bounds, curves.closed.tolist(), strict=True):
        numbers, commands = [starts[first]], ["M"]
        for piece in range(first, last):
            if not any(steps[piece]):
                continue
            numbers.append(steps[piece][4:] if straight[piece] else steps[piece])
            commands.append("l" if straight[piece] else "c")
        yield _path(commands, numbers) + ("z" if is_closed else "")


def _path(commands: list[str], numbers: list[list[int]]) -> str:
    """Commands with hundredths, without what SVG can do without.

    That is a command that is the last one again, spaces before signs, and before a second point.
    """
    parts, last_command, last = [], "", ""
    for command, values in zip(commands, numbers, strict=True):
        if command != last_command:
            parts.append(command)
            last_command, last = command, ""
        for value in values:
            text = _short(value)
            is_apart = not last or text[0] == "-" or (text[0] == "." and "." in last)
            parts.append(text if is_apart else " " + text)
            last = text
    return "".join(parts)


def _short(hundredths: int) -> str:
    """Such as '-.2' for -20."""
    whole, rest = divmod(abs(hundredths), 100)
    text = (str(whole) if whole or not rest else "") + (f".{rest:02}".rstrip("0") if rest else "")
    return f"-{text}" if hundredths < 0 else text
