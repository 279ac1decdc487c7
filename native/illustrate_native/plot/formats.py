"""The files of plots, by the extensions of their names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .animation import animated_svg_of
from .dxf_file import dxf_of
from .errors import PlotError
from .pdf_file import pdf_of
from .plans import Plot
from .svg_file import svg_of

EXTENSIONS = ("svg", "pdf", "dxf")
LIBRARIES = {"pdf": "pypdf", "dxf": "ezdxf"}
"""What must be installed for an extension."""


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
    if extension == "pdf":
        return pdf_of(plots, made_by)
    if extension == "svg" and len(plots) == 1:
        return svg_of(plots[0], made_by).encode()
    if extension == "svg":
        return animated_svg_of(plots, frames_per_second, made_by).encode()
    if extension == "dxf" and len(plots) == 1:
        return dxf_of(plots[0])
    if extension == "dxf":
        raise PlotError("a DXF holds one drawing: choose PDF or SVG for a sequence")
    raise PlotError(f"{extension!r} is no format of plots: choose {', '.join(EXTENSIONS)}")
