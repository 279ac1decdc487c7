"""A plot as DXF, R12 or 2000: a layer for each pen and region, for CAD programs and laser cutters.

Millimetres, y up, the origin at the page's lower left corner. R12 has polylines within the
tolerance and the outlines of regions; 2000 has the Béziers themselves, as splines, and regions as
hatches with their holes, in solid colour. Layers of regions come before those of pens. ezdxf writes
the file; it is an optional library.
"""

from __future__ import annotations

import io
import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from .curves import Curves, bezier
from .errors import PlotError
from .libraries import load
from .outlines import outlines
from .pens import Layer
from .plans import Plot
from .strokes import Floats

VERSIONS = ("R12", "R2000")
FILL = "Fill"
"""Begins the names of layers of regions."""
_FORBIDDEN = re.compile(r"[^\w \-$]")  # in names of layers
_MILLIMETRES = 4
_LONGEST_R12 = 31  # letters of a name
_BLACK = 7  # black on white, and white on black
_BY_LAYER = 256  # the colour of what has that of its layer
_OUTER, _INNER = 1, 16  # flags of the rings of hatches
_MADE_BY = "illustrate "  # begins the comment that says how a file was made
_FINEST_MM = 0.001  # that curves are followed to


def dxf_of(plot: Plot, version: str = "R2000", made_by: Mapping[str, Any] | None = None) -> bytes:
    """DXF of a version of VERSIONS; the same plot gives the same bytes.

    Raises PlotError for another version and without ezdxf.
    """
    if version not in VERSIONS:
        raise PlotError(f"the version is {version!r}, not one of {', '.join(VERSIONS)}")
    ezdxf = load("ezdxf", "DXF")
    text = io.StringIO()
    with _without_date(ezdxf.options):
        document = ezdxf.new(version, units=_MILLIMETRES)
        space, is_r12 = document.modelspace(), version == "R12"
        for region in plot.regions:
            name = _name(f"{FILL} {region.name}", version, document.layers)
            document.layers.add(name, color=_index(ezdxf, region.colour))
            for rings in region.polygons:
                _fill(space, plot, rings, {"layer": name}, is_r12)
        for layer in plot.layers:
            name = _name(layer.label, version, document.layers)
            document.layers.add(name, **_look(ezdxf, layer, version))
            _draw(space, plot, layer, {"layer": name}, is_r12)
        if made_by is not None:
            text.write(f"999\n{_MADE_BY}{json.dumps(made_by)}\n")
        document.write(text)
    return text.getvalue().encode(document.output_encoding, "dxfreplace")


def read_made_by(data: bytes) -> dict[str, Any]:
    """What `dxf_of` was given as made_by. Raises ValueError where there is none, or no end."""
    lines = data.decode("latin-1").splitlines()
    if len(lines) < 2 or not lines[1].startswith(_MADE_BY) or lines[-1] != "EOF":
        raise ValueError("not a whole DXF that says how it was made")
    return dict(json.loads(lines[1].removeprefix(_MADE_BY)))


@contextmanager
def _without_date(options: Any) -> Iterator[None]:
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


def _name(label: str, version: str, taken: Any) -> str:
    """A name for a layer that no other has, of letters that the version takes."""
    name = _FORBIDDEN.sub("_", label)
    if version == "R12":
        name = re.sub(r"[^A-Z0-9_$-]", "_", name.upper())[:_LONGEST_R12]
    free, number = name, 2
    while free in taken:
        free, number = f"{name[: _LONGEST_R12 - 3]}_{number}", number + 1
    return free


def _look(ezdxf: Any, layer: Layer, version: str) -> dict[str, int]:
    """The nearest of the colours and line widths that DXF has."""
    colour = _index(ezdxf, layer.pen.colour)
    if version == "R12":
        return {"color": colour}
    weights = ezdxf.lldxf.const.VALID_DXF_LINEWEIGHTS
    nearest = min(weights, key=lambda weight: abs(weight - 100 * layer.pen.width_mm))
    return {"color": colour, "lineweight": nearest}


def _index(ezdxf: Any, colour: str) -> int:
    """The nearest of the numbered colours."""
    ink = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    table = np.array([ezdxf.colors.aci2rgb(i) for i in range(1, 256)])
    if not ink.any():
        return _BLACK
    return int(np.argmin(((table - ink) ** 2).sum(axis=1))) + 1


def _up(plot: Plot, points: Floats) -> Any:
    """Points as DXF has them."""
    return np.round(np.c_[points[:, 0], plot.page.height_mm - points[:, 1]], 3).tolist()


def _fill(
    space: Any, plot: Plot, rings: Sequence[Floats], look: dict[str, str], is_r12: bool
) -> None:
    """An area, the first ring its outer one."""
    if is_r12:
        for ring in rings:
            space.add_polyline2d(_up(plot, ring), close=True, dxfattribs=look)
        return
    area = space.add_hatch(dxfattribs=look)
    area.dxf.color = _BY_LAYER
    for i, ring in enumerate(rings):
        area.paths.add_polyline_path(_up(plot, ring), flags=_INNER if i else _OUTER)


def _draw(space: Any, plot: Plot, layer: Layer, look: dict[str, str], is_r12: bool) -> None:
    def up(points: Floats) -> Any:
        return _up(plot, points)

    polyline = space.add_polyline2d if is_r12 else space.add_lwpolyline
    if layer.pen.is_tapered:
        for rings in outlines(layer.strokes):
            _fill(space, plot, rings, look, is_r12)
        return
    curves = plot.curves(layer)
    for first, last, is_closed in _strokes(curves):
        pieces = curves.controls[first:last]
        if is_r12:
            polyline(up(_chords(curves, first, last, plot.tolerance_mm)), dxfattribs=look)
        elif curves.straight[first:last].all():
            ends = np.vstack([pieces[:, 0], pieces[-1:, 3]])
            polyline(up(ends[:-1] if is_closed else ends), close=is_closed, dxfattribs=look)
        else:
            spline = space.add_spline(degree=3, dxfattribs=look)
            spline.control_points = up(np.vstack([pieces[0, :1], pieces[:, 1:].reshape(-1, 2)]))
            spline.knots = np.repeat(np.arange(last - first + 1.0), 3).tolist()
            spline.knots = [0.0, *spline.knots, float(last - first)]


def _strokes(curves: Curves) -> Iterator[tuple[int, int, bool]]:
    """First and last piece of each stroke, and whether it is closed."""
    bounds = curves.offsets.tolist()
    yield from zip(bounds[:-1], bounds[1:], curves.closed.tolist(), strict=True)


def _chords(curves: Curves, first: int, last: int, tolerance_mm: float) -> Floats:
    """A polyline within the tolerance of curves: chords of equal parameters.

    A chord of a cubic over 1/n of it is off by at most its second differences times 6 / 8 n^2.
    """
    points = [curves.controls[first, :1]]
    for piece in range(first, last):
        bend = float(np.linalg.norm(np.diff(curves.controls[piece], 2, axis=0), axis=1).max())
        count = math.ceil(math.sqrt(0.75 * bend / max(tolerance_mm, _FINEST_MM)))
        points.append(bezier(curves.controls[piece], np.arange(1, count + 1) / max(count, 1)))
        if not count:
            points.append(curves.controls[piece, 3:])
    return np.vstack(points)
