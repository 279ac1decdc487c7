"""Drawings on paper: pages, pens, the order of strokes, and files of millimetres.

    strokes = strokes_of(drawing)
    plot = plot_of(strokes, width_px, height_px, PlotOptions(paper="A4", margin_mm=10))
    open("torus.svg", "w").write(svg_of(plot))

Each step is a function on plain arrays, in a file of its own; docs/plot.md.
"""

from .errors import PlotError
from .formats import EXTENSIONS, check, check_regions, file_of, read_made_by
from .masks import coverage, mask_names, mask_of
from .order import Cost, Machine
from .pages import FORMATS, Page, make_page, read_paper
from .pens import Layer, Pen, check_pens, one_pen, pens_by_line
from .plans import Plot, PlotOptions, Thing, placing_of, plot_of, strokes_of
from .regions import Region, cut_open, regions_of
from .seen import seen_from
from .strokes import Strokes, Subject, make_strokes
from .svg_file import svg_of

__all__ = [
    "EXTENSIONS",
    "FORMATS",
    "Cost",
    "Layer",
    "Machine",
    "Page",
    "Pen",
    "Plot",
    "PlotError",
    "PlotOptions",
    "Region",
    "Strokes",
    "Subject",
    "Thing",
    "check",
    "check_pens",
    "check_regions",
    "coverage",
    "cut_open",
    "file_of",
    "make_page",
    "make_strokes",
    "mask_names",
    "mask_of",
    "one_pen",
    "pens_by_line",
    "placing_of",
    "plot_of",
    "read_made_by",
    "read_paper",
    "regions_of",
    "seen_from",
    "strokes_of",
    "svg_of",
]
