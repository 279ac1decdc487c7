"""The files of plots, by the extensions of their names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .. import svg
from . import dxf_file, pdf_file
from .animation import animated_svg_of
from .dxf_file import dxf_of
from .errors import PlotError
from .libraries import load
from .pdf_file import pdf_of
from .plans import Plot
from .regions import PURPOSE
from .svg_file import svg_of

EXTENSIONS = ("svg", "pdf", "dxf")
LIBRARIES = {"pdf": "pypdf", "dxf": "ezdxf"}
"""What must be installed for an extension."""


def read_made_by(extension: str, data: bytes) -> dict[str, Any]:
    """What a file says of its making. Raises ValueError where it does not."""
    if extension == "svg":
        return svg.read_made_by(data.decode())
    if extension == "pdf":
        return pdf_file.read_made_by(data)
    return dxf_file.read_made_by(data)


def check(extension: str, is_sequence: bool = False, has_regions: bool = False) -> None:
    """Raises PlotError where `file_of` or filling regions would: nothing need be drawn for it."""
    if extension not in EXTENSIONS:
        raise PlotError(f"{extension!r} is no format of plots: choose {', '.join(EXTENSIONS)}")
    if is_sequence and extension == "dxf":
        raise PlotError("a DXF holds one drawing: choose PDF or SVG for a sequence")
    if has_regions:
        check_regions()
    if extension in LIBRARIES:
        load(LIBRARIES[extension], extension.upper())


def check_regions() -> None:
    """Raises PlotError where `regions_of` would, for want of a library."""
    load("shapely", PURPOSE)


def file_of(
    extension: str,
    plots: Sequence[Plot],
    made_by: Mapping[str, Any] | None = None,
    frames_per_second: float = 24.0,
) -> bytes:
    """The bytes of a file of one plot or of a sequence: pages of a PDF, frames of an SVG.

    Raises PlotError for other extensions, for a sequence of what has no pages, and where a library
    is missing.
    """
    check(extension, len(plots) > 1)
    if extension == "pdf":
        return pdf_of(plots, made_by)
    if extension == "dxf":
        return dxf_of(plots[0], made_by=made_by)
    if len(plots) == 1:
        return svg_of(plots[0], made_by).encode()
    return animated_svg_of(plots, frames_per_second, made_by).encode()
