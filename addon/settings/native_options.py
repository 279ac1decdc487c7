"""The native options as properties of Blender: one row each, the only place that names them all.

A row says under which name Blender keeps the option, on which panel it is shown and how its value
is turned into the native one. To mirror a new native option, add a row.
"""

import math
from typing import Any

from bpy.props import FloatProperty, FloatVectorProperty

from .option_kinds import (
    NativeOption,
    choice,
    paper,
    pixels,
    real,
    share,
    switch,
    threshold,
    value_of,
    whole,
)

THREADS = whole("threads", "surface", "Threads", 0,
                "Threads to compute with, 0 for as many as there are cores",
                min=0, max=1024)  # fmt: skip

SCHEMES = [
    ("auto", "Automatic", "Catmull-Clark for meshes of quads, Loop for others", 0),
    ("catmull-clark", "Catmull-Clark", "The surface of Blender's Subdivision modifier", 1),
    ("loop", "Loop", "The surface of triangle meshes", 2),
    ("none", "None", "Draw the faces as they are", 3),
]
SEEDINGS = [
    ("surface-curves", "Surface", "Ranked curves of the surface, alike from all sides", 0),
    ("critical-curves", "Picture", "The lines of the picture, as in the paper", 1),
]
FIELD_STARTS = [
    ("search", "Search", "The smoothest of many fields", 0),
    ("principal", "Principal", "Near the principal directions of curvature", 1),
]

PREPARE = (
    choice("scheme", "surface", "Subdivision", SCHEMES, "auto",
           "Which smooth surface meshes stand for, where no Subdivision modifier says it"),
    whole("level", "surface", "Level", -1,
          "How often surfaces are subdivided, -1 for as often as the picture needs",
          min=-1, max=10),
    real("edge_length", "surface", "Edge Size", 0.0,
         "Longest median edge of automatic levels, 0 for what the picture needs",
         min=0.0, unit="LENGTH"),
    whole("triangle_budget", "surface", "Triangles", 250_000,
          "Most triangles that surfaces are refined to, all objects together",
          min=1_000, soft_max=2_000_000),
    whole("most_intersections", "surface", "Crossings", 500_000,
          "Most pairs of triangles that cross: objects that cross in more, such as fur, have no "
          "lines where they pass through each other",
          min=0, soft_max=10_000_000),
    THREADS,
    whole("rings", "surface", "Smoothing", 3,
          "Rings of neighbours that directions are computed from: more for meshes with fine detail "
          "that the hatches should not follow",
          min=1, max=10),
    real("parabolic_ratio", "surface", "Parabolic", 0.2,
         "Hatches keep to the curvature where the smaller one is at most this share of the larger; "
         "0 smooths all directions",
         min=0.0, soft_max=1.0),
    real("least_curvature", "surface", "Curvature", 1.0,
         "Where an object bends less, measured against its size, directions are smoothed",
         min=0.0, soft_max=20.0),
    real("largest_energy", "surface", "Energy", 0.05,
         "Where directions of curvature disagree more with their neighbours, they are smoothed",
         min=0.0, max=2.0),
    real("alignment_weight", "surface", "Alignment", 0.1,
         "How strongly creases and boundaries pull the hatches along them",
         min=0.0, soft_max=1.0),
    switch("inverse_length_weights", "surface", "Short Edges", False,
           "Edges of the surface count in inverse proportion to their length"),
    choice("field_start", "surface", "Start", FIELD_STARTS, "search",
           "Where the smoothing of directions starts from"),
    real("guide_radius", "surface", "Radius", 0.05,
         "So far from a guide it alone says where hatches run, measured against the object's size",
         min=0.0, soft_max=1.0),
    whole("max_evaluations", "surface", "Evaluations", 500,
          "Most steps of smoothing the directions",
          min=0, soft_max=5_000),
    NativeOption(
        "default_direction",
        FloatVectorProperty(name="Direction", size=3, default=(0.0, 0.0, 1.0),
                            subtype="XYZ",
                            description="World direction of hatches where no curvature gives one"),
        "surface",
        to_native=lambda vector: tuple(vector) if any(vector) else (0.0, 0.0, 1.0),
    ),
)  # fmt: skip

LINES = (
    paper("line_width_px", "main", "Line Width", 2.0, "Width of silhouettes and boundaries",
           0.05, 100.0, 10.0, 0.3),
    paper("feature_width_px", "lines", "Features", 1.4,
           "Width of all other lines but hatches",
           0.05, 100.0, 10.0, 0.2),
    share("line_width_by_light", "lines", "By Light", 0.0,
           "Share by which lines swell on the side of a form that is turned from the light"),
    share("line_width_by_depth", "lines", "By Depth", 0.0,
           "Share by which the nearest lines swell and the farthest thin out"),
    real("inner_width_scale", "lines", "Inside", 1.0,
          "Width of lines inside an object's outline, as a share of what they have without",
          min=0.0, max=100.0, soft_max=1.0, subtype="FACTOR"),
    share("line_width_by_crowding", "lines", "Crowded", 1.0,
          "How far lines thin out where gaps between them would close"),
    share("hidden_width_scale", "lines", "Hidden", 0.5,
           "Width of hidden lines, as a share of that of visible ones"),
    paper("taper_px", "lines", "Taper", 6.0, "Length over which ends that meet no line thin out",
           0.0, 1000.0, 100.0),
    paper("speck_px", "lines", "Shortest", 3.0,
           "Shorter lines that close no gap are left out",
           0.0, 1000.0, 50.0),
    pixels("simplify_px", "lines", "Simplify", 0.1, "How far a stroke may be from its curve",
            min=0.0, max=100.0, soft_max=2.0),
    switch("marks", "lines", "Marked Edges", False, "Draw edges with a Freestyle mark"),
    switch("materials", "lines", "Materials", False, "Draw lines between materials"),
    switch("flat_outlines", "lines", "Flat Outlines", False, "Draw the outlines of flat areas"),
    switch("loose_edges", "lines", "Loose Edges", False,
           "Draw edges that belong to no face, and objects that have no others"),
    switch("terminators", "lines", "Terminators", False,
           "Draw where smooth forms turn away from the scene's lights"),
    switch("shadow_outlines", "lines", "Shadow Lines", False,
           "Draw the outlines of the shadows that the scene's lights cast"),
    switch("suggestive_contours", "lines", "Suggestive", False,
            "Draw where a smooth surface nearly turns away from the camera"),
    threshold("suggestive_threshold", "suggestive contours", 20.0),
    switch("ridges", "lines", "Ridges", False, "Draw where a smooth surface bulges most"),
    threshold("ridge_threshold", "ridges", 15.0),
    switch("valleys", "lines", "Valleys", False, "Draw where a smooth surface caves in most"),
    threshold("valley_threshold", "valleys", 15.0),
)  # fmt: skip

HATCHING = (
    switch("hatching", "main", "Hatching", True, "Hatch midtones and cross-hatch shadows"),
    paper("spacing_px", "main", "Spacing", 8.0, "Distance between neighbouring hatches",
           1.0, 10_000.0, 40.0),
    paper("hatch_width_px", "hatching", "Width", 1.0, "Width of hatches where shadow begins",
           0.05, 100.0, 10.0),
    share("hatch_width_by_light", "hatching", "By Light", 0.5,
           "Share by which hatches swell towards the dark and thin towards highlights"),
    paper("undercut_spacing_px", "hatching", "Undercuts", 5.0,
           "Distance between neighbouring hatches in undercuts", 1.0, 10_000.0, 40.0),
    paper("least_spacing_px", "hatching", "Finest", 4.0,
           "Parts smaller than sixteen spacings are hatched finer, down to this distance between "
           "hatches", 1.0, 10_000.0, 40.0),
    real("test_factor", "hatching", "Nearest", 0.6,
          "A hatch ends where it comes nearer to another than this share of the spacing",
          min=0.1, max=1.0, subtype="FACTOR"),
    paper("min_length_px", "hatching", "Shortest", 8.0, "Shorter hatches are left out",
           0.0, 10_000.0, 100.0),
    paper("max_length_px", "hatching", "Longest", 2500.0, "Length at which a hatch ends",
           1.0, 20_000.0, 5_000.0),
    choice("hatch_seeding", "hatching", "Seeding", SEEDINGS, "surface-curves",
           "What hatches start from"),
    NativeOption(
        "max_turn_deg",
        FloatProperty(name="Most Turn", default=math.radians(150), min=math.radians(1),
                      max=math.radians(360), subtype="ANGLE",
                      description="How far a hatch may turn before it ends"),
        "hatching", "max_turn", math.degrees,
    ),
    pixels("step_px", "hatching", "Step", 1.5, "Length of the steps in which hatches are traced",
            min=0.25, max=20.0),
)  # fmt: skip

LIGHT = (
    share("highlight_threshold", "light", "Highlight", 0.85,
           "Where it is brighter there are no hatches"),
    share("shadow_threshold", "light", "Shadow", 0.45,
           "Where it is not brighter there are two directions of hatches"),
    real("smallest_tone", "light", "Patches", 2.5,
         "Patches of one tone smaller than so many spacings across join their neighbour; at 0 all "
         "stay, and edges of tone are as rough as the light",
         min=0.0, max=20.0, soft_max=6.0),
    whole("extra_levels", "light", "Extra Levels", 0,
           "Divide shadows into so many levels more, with hatches along the diagonals",
           min=0, max=3),
    share("reflectance", "light", "Materials", 1.0,
           "How much counts how light or dark materials are; at 0 all is white paper"),
    NativeOption(
        "exposure",
        FloatProperty(name="Exposure", default=0.0, min=-16.0, max=16.0, soft_min=-4.0,
                      soft_max=4.0, description="Make light stronger or weaker, in stops"),
        "light", "exposure_stops", lambda stops: 2.0**stops,
    ),
    switch("cast_shadows", "light", "Cast Shadows", True,
            "Let objects keep the light from others"),
    switch("mach_bands", "light", "Mach Bands", True,
            "Leave a narrow band along the near side of a fold white"),
    paper("mach_band_px", "light", "Width", 6.0, "Width of Mach bands",
           0.0, 100.0, 50.0),
    switch("undercuts", "light", "Undercuts", True,
            "Hatch densely what lies just behind a fold"),
    paper("undercut_px", "light", "Width", 14.0, "Width of undercuts", 0.0, 100.0, 50.0),
    share("undercut_contact", "light", "Contact", 0.5,
          "How near what lies behind a fold must be for an undercut: at 0 anywhere, at 1 touching"),
    pixels("cell_px", "light", "Cells", 64.0, "Largest cells that light is measured in",
            min=0.25, max=64.0),
)  # fmt: skip

DRAW = (*LINES, *HATCHING, *LIGHT, THREADS)

WIDTHS = ("line_width_px", "feature_width_px", "hatch_width_px", "hidden_width_scale")
"""Native options of the drawing that change widths and nothing else."""

STYLE_DEFAULTS = {
    "ignore": False,
    "occlude_only": False,
    "see_through": False,
    "lines": True,
    "hatching": True,
    "loose_edges": False,
    "spacing_scale": 1.0,
    "width_scale": 1.0,
    "pen": 0,
    "shadow_only": False,
    "shadow_catcher": False,
    "materials": [],
}
"""Of `illustrate_native.ObjectStyle`."""

STYLES_FROM_ELSEWHERE = {
    "shadow_only": "what the camera does not see: the object's visibility, and indirect only",
    "shadow_catcher": "the object's visibility",
    "materials": "the styles of materials",
    "pen": "nowhere: plots tell objects apart without it",
}
"""Of these, what no style of an object or collection holds, and where it comes from instead."""

# Native options without a property of their own, and where their values come from instead.
FROM_ELSEWHERE = {
    "field": "hatching",
    "guides": "the collection of guides",
    "singularities": "the empties in the collection of guides",
    "hidden_lines": "hidden, hidden_layers",
    "highlight_share": "tones, highlight_share",
    "shadow_share": "tones, shadow_share",
    "auto_exposure": "auto_exposure, where the light is the scene's",
    "tone_image": "tone_source, tone_image",
    "styles": "the styles of objects and collections",
    "visibility": "nothing: the vote of the paper is there for comparison",
    "scan_silhouettes": "nothing: what the search finds is compared with it",
}


def properties() -> dict[str, Any]:
    """All properties by name."""
    found = {}
    for option in (*PREPARE, *DRAW):
        found[option.key] = option.prop
        if option.prop_mm is not None:
            found[option.key_mm] = option.prop_mm
    return found


def values(options: tuple[NativeOption, ...], settings: Any, px_per_mm: float) -> dict[str, Any]:
    """Native values by native names. px_per_mm: of the page; 0: lengths are in pixels."""
    return {option.native: value_of(option, settings, px_per_mm) for option in options}
