"""Plots as PDF: vectors in true size, a page for each plot, the layers as optional content.

pypdf keeps the structure of the file; it is an optional library.
"""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from .libraries import load
from .outlines import outlines
from .pages import Box
from .pens import Layer
from .plans import Plot
from .strokes import Floats
from .svg_file import REGIONS

POINTS_PER_MM = 72 / 25.4
MADE_BY = "/Illustrate"
"""The entry of the document's information that says how it was made."""


def pdf_of(plots: Sequence[Plot], made_by: Mapping[str, Any] | None = None) -> bytes:
    """A PDF with a page for each plot; layers of the same name are one.

    The same plots give the same bytes. Raises PlotError without pypdf.
    """
    pypdf = load("pypdf", "PDF")
    writer = pypdf.PdfWriter()
    areas = [REGIONS] if any(plot.regions for plot in plots) else []
    labels = [layer.label for plot in plots for layer in plot.layers]
    names = list(dict.fromkeys([*areas, *labels]))
    groups = {name: _optional_content(pypdf.generic, writer, name) for name in names}
    for plot in plots:
        _add_page(pypdf.generic, writer, plot, groups)
    _list_layers(pypdf.generic, writer, list(groups.values()))
    told = {} if made_by is None else {MADE_BY: json.dumps(made_by)}
    writer.add_metadata({"/Producer": "Illustrate", **told})
    file = io.BytesIO()
    writer.write(file)
    return file.getvalue()


def read_made_by(data: bytes) -> dict[str, Any]:
    """What `pdf_of` was given as made_by. Raises ValueError where there is none."""
    pypdf = load("pypdf", "PDF")
    try:
        told = pypdf.PdfReader(io.BytesIO(data)).metadata[MADE_BY]
    except (pypdf.errors.PyPdfError, KeyError, TypeError) as error:
        raise ValueError("not a whole PDF that says how it was made") from error
    return dict(json.loads(told))


def _optional_content(generic: Any, writer: Any, name: str) -> Any:
    group = generic.DictionaryObject()
    group[generic.NameObject("/Type")] = generic.NameObject("/OCG")
    group[generic.NameObject("/Name")] = generic.TextStringObject(name)
    return writer._add_object(group)


def _list_layers(generic: Any, writer: Any, groups: list[Any]) -> None:
    """Tells readers of the layers, in their order, all of them shown."""
    shown = generic.DictionaryObject()
    shown[generic.NameObject("/Order")] = generic.ArrayObject(groups)
    shown[generic.NameObject("/ON")] = generic.ArrayObject(groups)
    properties = generic.DictionaryObject()
    properties[generic.NameObject("/OCGs")] = generic.ArrayObject(groups)
    properties[generic.NameObject("/D")] = shown
    writer.root_object[generic.NameObject("/OCProperties")] = properties


def _add_page(generic: Any, writer: Any, plot: Plot, groups: dict[str, Any]) -> None:
    outer = plot.page.outer
    width, height = outer[2] - outer[0], outer[3] - outer[1]
    page = writer.add_blank_page(width * POINTS_PER_MM, height * POINTS_PER_MM)
    trim = (0.0, 0.0, plot.page.width_mm, plot.page.height_mm)
    for name, box in (("/BleedBox", outer), ("/TrimBox", trim)):
        page[generic.NameObject(name)] = _box(generic, box, outer)
    used = generic.DictionaryObject()
    if plot.regions:
        used[generic.NameObject("/R")] = groups[REGIONS]
    for i, layer in enumerate(plot.layers):
        used[generic.NameObject(f"/L{i}")] = groups[layer.label]
    resources = generic.DictionaryObject()
    resources[generic.NameObject("/Properties")] = used
    page[generic.NameObject("/Resources")] = resources
    content = generic.StreamObject()
    content.set_data("\n".join(_content(plot)).encode())
    page[generic.NameObject("/Contents")] = writer._add_object(content.flate_encode())


def _box(generic: Any, box: Box, outer: Box) -> Any:
    """A box as PDF has it: points, from the lower left corner of the sheet."""
    left, right = box[0] - outer[0], box[2] - outer[0]
    bottom, top = outer[3] - box[3], outer[3] - box[1]
    sides = (left, bottom, right, top)
    return generic.RectangleObject([round(side * POINTS_PER_MM, 4) for side in sides])


def _content(plot: Plot) -> Iterator[str]:
    """Operators of a page, whose units are made millimetres, y down."""
    left, _, _, bottom = plot.page.outer
    k = POINTS_PER_MM
    yield f"{k:.9f} 0 0 {-k:.9f} {-left * k:.6f} {bottom * k:.6f} cm 1 J 1 j"
    if plot.regions:
        yield "/OC /R BDC"
        for region in plot.regions:
            rings = (_ring(ring) for polygon in region.polygons for ring in polygon)
            yield f"{_ink(region.colour)} rg {' '.join(rings)} f*"
        yield "EMC"
    for i, layer in enumerate(plot.layers):
        yield f"/OC /L{i} BDC"
        yield from _layer(plot, layer)
        yield "EMC"


def _layer(plot: Plot, layer: Layer) -> Iterator[str]:
    ink = _ink(layer.pen.colour)
    if layer.pen.is_tapered:
        yield f"{ink} rg"
        yield from (" ".join(map(_ring, rings)) + " f" for rings in outlines(layer.strokes))
        return
    yield f"{ink} RG {_numbers(layer.pen.width_mm)} w"
    curves = plot.curves(layer)
    controls = np.round(curves.controls, 2)
    for first, last, is_closed in zip(
        curves.offsets[:-1].tolist(), curves.offsets[1:].tolist(), curves.closed, strict=True
    ):
        parts = [f"{_numbers(*controls[first, 0])} m"]
        for piece in range(first, last):
            is_line = curves.straight[piece]
            ends = controls[piece, 3:] if is_line else controls[piece, 1:]
            parts.append(f"{_numbers(*ends.ravel())} {'l' if is_line else 'c'}")
        yield " ".join(parts) + (" s" if is_closed else " S")


def _ink(colour: str) -> str:
    return " ".join(f"{int(colour[i : i + 2], 16) / 255:.4g}" for i in (1, 3, 5))


def _ring(ring: Floats) -> str:
    first, *rest = (_numbers(*point) for point in ring)
    return " ".join([f"{first} m", *(f"{point} l" for point in rest), "h"])


def _numbers(*values: float) -> str:
    return " ".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in values)
