"""The settings of a scene: what is drawn, and the native options field for field."""
# mypy: disable-error-code="valid-type,misc"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty

from . import native

SOURCES = [
    ("SCENE", "Scene", "Draw every mesh that can be seen", 0),
    ("SELECTION", "Selection", "Draw the selected objects only", 1),
]
OUTPUTS = [
    ("GREASE_PENCIL", "Grease Pencil", "One Grease Pencil object with a layer per line kind", 0),
    ("CURVES", "Curves", "One curve object per line kind", 1),
]
LIGHTINGS = [
    ("SCENE", "Scene Lights", "Light the drawing with the lights of the scene", 0),
    ("HEADLIGHT", "Headlight", "Light the drawing from the camera", 1),
    ("SIDE", "Side Light", "Light the drawing from the upper left of the camera", 2),
]
TONES = [
    ("LIGHT", "By Brightness", "Highlights and shadows begin at a brightness", 0),
    ("AREA", "By Area", "Highlights and shadows cover a share of what is seen", 1),
]
UNITS = [
    ("PIXEL", "Pixels", "Lengths are pixels of the render", 0),
    ("MILLIMETRE", "Millimetres", "Lengths are millimetres on a page of the width below", 1),
]

# Lengths that are set in pixels or in millimetres, by their names without the unit.
LENGTHS = (
    "line_width",
    "feature_width",
    "spacing",
    "undercut_spacing",
    "hatch_width",
    "taper",
    "mach_band",
    "undercut",
)

LEVELS = ("highlight", "shadow")

# Optional kinds of lines, each with what it is measured by.
LINE_KINDS = (
    "marks",
    "materials",
    "suggestive_contours",
    "suggestive_threshold",
    "ridges",
    "ridge_threshold",
    "valleys",
    "valley_threshold",
)


def _threshold(name: str, lines: str, default: float) -> Any:
    return FloatProperty(
        name=f"{name} Threshold",
        default=default,
        min=0.01,
        max=100_000.0,
        soft_min=1.0,
        soft_max=100.0,
        description=f"Leave out weaker {lines}, measured against the size of the object",
    )


def _pixels(name: str, what: str, default: float, low: float = 0.05, high: float = 100.0) -> Any:
    return FloatProperty(
        name=name,
        default=default,
        min=low,
        max=high,
        soft_max=min(high, 5 * default),
        subtype="PIXEL",
        description=f"{what}, pixels of the render",
    )


def _millimetres(name: str, what: str, default: float, low: float = 0.005) -> Any:
    return FloatProperty(
        name=name,
        default=default,
        min=low,
        max=100.0,
        soft_max=5 * default,
        precision=3,
        description=f"{what}, millimetres on the page",
    )


class ILLUSTRATE_PG_settings(bpy.types.PropertyGroup):
    """How the illustration of a scene is made."""

    source: EnumProperty(
        name="Draw", items=SOURCES, default="SCENE", description="Which objects are drawn"
    )
    output: EnumProperty(
        name="Output", items=OUTPUTS, default="GREASE_PENCIL", description="What strokes become"
    )
    lighting: EnumProperty(
        name="Light",
        items=LIGHTINGS,
        default="SCENE",
        description="Where light and shadow of the hatching come from",
    )

    auto_exposure: BoolProperty(
        name="Auto Exposure",
        default=True,
        description="Scale the scene's lights so that the strongest is just white; "
        "without, light is what a white surface has in the render",
    )
    unit: EnumProperty(
        name="Unit", items=UNITS, default="PIXEL", description="What lengths are given in"
    )
    page_width_mm: FloatProperty(
        name="Page Width",
        default=200.0,
        min=1.0,
        max=10_000.0,
        description="Width of the page that the whole image fills, millimetres",
    )

    line_width_px: _pixels("Line Width", "Width of silhouettes and boundaries", 2.0)
    line_width_mm: _millimetres("Line Width", "Width of silhouettes and boundaries", 0.3)
    feature_width_px: _pixels("Feature Width", "Width of all other lines but hatches", 1.4)
    feature_width_mm: _millimetres("Feature Width", "Width of all other lines but hatches", 0.2)
    marks: BoolProperty(
        name="Marked Edges", default=False, description="Draw edges with a Freestyle mark"
    )
    materials: BoolProperty(
        name="Material Borders", default=False, description="Draw lines between materials"
    )
    suggestive_contours: BoolProperty(
        name="Suggestive Contours",
        default=False,
        description="Draw where a smooth surface nearly turns away from the camera",
    )
    suggestive_threshold: _threshold("Suggestive", "suggestive contours", 20.0)
    ridges: BoolProperty(
        name="Ridges", default=False, description="Draw where a smooth surface bulges most"
    )
    ridge_threshold: _threshold("Ridge", "ridges", 15.0)
    valleys: BoolProperty(
        name="Valleys", default=False, description="Draw where a smooth surface caves in most"
    )
    valley_threshold: _threshold("Valley", "valleys", 15.0)
    hidden: BoolProperty(
        name="Hidden Lines",
        default=False,
        description="Draw lines that lie behind other surfaces too, on a layer of their own",
    )
    hidden_layers: IntProperty(
        name="Hidden Layers",
        default=1,
        min=1,
        max=64,
        description="Draw hidden lines with at most so many surfaces in front of them",
    )

    hatching: BoolProperty(
        name="Hatching", default=True, description="Hatch midtones and cross-hatch shadows"
    )
    spacing_px: _pixels("Spacing", "Distance between neighbouring hatches", 8.0, 1.0, 200.0)
    spacing_mm: _millimetres("Spacing", "Distance between neighbouring hatches", 0.8)
    undercut_spacing_px: _pixels(
        "Undercut Spacing", "Distance between hatches just behind a fold", 5.0, 1.0, 200.0
    )
    undercut_spacing_mm: _millimetres(
        "Undercut Spacing", "Distance between hatches just behind a fold", 0.5
    )
    hatch_width_px: _pixels("Hatch Width", "Width of hatches where shadow begins", 1.0)
    hatch_width_mm: _millimetres("Hatch Width", "Width of hatches where shadow begins", 0.1)
    hatch_width_by_light: FloatProperty(
        name="Width By Light",
        default=0.4,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="How much hatches swell towards the dark and thin towards highlights",
    )
    taper_px: _pixels("Taper", "Length over which free ends thin out", 6.0, 0.0)
    taper_mm: _millimetres("Taper", "Length over which free ends thin out", 0.6, 0.0)
    tones: EnumProperty(
        name="Tones", items=TONES, default="LIGHT", description="What divides light from shadow"
    )
    cast_shadows: BoolProperty(
        name="Cast Shadows", default=False, description="Let objects keep the light from others"
    )
    highlight_threshold: FloatProperty(
        name="Highlight",
        default=0.8,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Where it is brighter there are no hatches",
    )
    shadow_threshold: FloatProperty(
        name="Shadow",
        default=0.4,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Where it is not brighter there are two directions of hatches",
    )
    highlight_share: FloatProperty(
        name="Highlight Share",
        default=0.3,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Share of what is seen that has no hatches",
    )
    shadow_share: FloatProperty(
        name="Shadow Share",
        default=0.35,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Share of what is seen that has two directions of hatches",
    )
    extra_levels: IntProperty(
        name="Extra Levels",
        default=0,
        min=0,
        max=3,
        description="Divide shadows into so many levels more, with hatches along the diagonals",
    )
    undercuts: BoolProperty(
        name="Undercuts", default=True, description="Hatch densely what lies just behind a fold"
    )
    mach_bands: BoolProperty(
        name="Mach Bands",
        default=True,
        description="Leave a narrow band along the near side of a fold white",
    )
    undercut_px: _pixels("Undercut Width", "Width of the dense hatching behind a fold", 14.0, 0.0)
    undercut_mm: _millimetres(
        "Undercut Width", "Width of the dense hatching behind a fold", 1.4, 0.0
    )
    mach_band_px: _pixels("Mach Band Width", "Width of the white band along a fold", 6.0, 0.0)
    mach_band_mm: _millimetres("Mach Band Width", "Width of the white band along a fold", 0.6, 0.0)

    guides: PointerProperty(
        type=bpy.types.Collection,
        name="Guides",
        description="Hatches follow the curves and Grease Pencil strokes of this collection, "
        "drawn on the surfaces or near them; its objects are not drawn",
    )
    guide_weight: FloatProperty(
        name="Guide Weight",
        default=10.0,
        min=0.0,
        soft_max=100.0,
        description="How closely hatches follow the guides; 10 is nearly exact",
    )
    rings: IntProperty(
        name="Smoothing",
        default=3,
        min=1,
        max=10,
        description="Rings of neighbours that directions are computed from: "
        "more for meshes with fine detail that the hatches should not follow",
    )
    parabolic_ratio: FloatProperty(
        name="Parabolic Ratio",
        default=0.2,
        min=0.0,
        soft_max=1.0,
        description="Hatches keep to the curvature where the smaller one is at most this share of "
        "the larger; 0 smooths all directions",
    )
    least_curvature: FloatProperty(
        name="Least Curvature",
        default=1.0,
        min=0.0,
        soft_max=20.0,
        description="Where an object bends less, measured against its size, directions are "
        "smoothed",
    )
    largest_energy: FloatProperty(
        name="Largest Energy",
        default=0.05,
        min=0.0,
        max=2.0,
        description="Where directions of curvature disagree more with their neighbours, they are "
        "smoothed",
    )

    triangle_budget: IntProperty(
        name="Triangle Budget",
        default=250_000,
        min=1_000,
        soft_max=2_000_000,
        description="Most triangles that surfaces are refined to, all objects together",
    )
    threads: IntProperty(
        name="Threads",
        default=0,
        min=0,
        max=1024,
        description="Threads to compute with, 0 for as many as there are cores",
    )


def _fill(options: Any, settings: Any, names: tuple[str, ...]) -> Any:
    for name in names:
        setattr(options, name, getattr(settings, name))
    return options


def prepare_options(settings: Any, guides: list[Any]) -> Any:
    """`illustrate_native.PrepareOptions` of the settings (an ILLUSTRATE_PG_settings).

    guides: polylines (k, 3) in world space.
    """
    names = (
        "rings",
        "parabolic_ratio",
        "least_curvature",
        "largest_energy",
        "triangle_budget",
        "threads",
    )
    ill = native.load()
    options = _fill(ill.PrepareOptions(), settings, names)
    options.field = settings.hatching
    options.guides = [ill.Guide(points, settings.guide_weight) for points in guides]
    return options


def draw_options(settings: Any, width_px: int) -> Any:
    """`illustrate_native.DrawOptions` of the settings (an ILLUSTRATE_PG_settings).

    width_px: of the image, which millimetres count on.
    """
    names = (
        *LINE_KINDS,
        "hatching",
        "hatch_width_by_light",
        "cast_shadows",
        "extra_levels",
        "undercuts",
        "mach_bands",
        "threads",
    )
    options = _fill(native.load().DrawOptions(), settings, names + tone_fields(settings))
    for name, length in _lengths(settings, width_px).items():
        setattr(options, name, length)
    if settings.hidden:
        options.hidden_lines = (1, settings.hidden_layers)
    return options


def tone_fields(settings: Any) -> tuple[str, str]:
    """What divides highlights, midtones and shadows."""
    kind = "share" if settings.tones == "AREA" else "threshold"
    return f"highlight_{kind}", f"shadow_{kind}"


def unused_fields(settings: Any) -> set[str]:
    """Settings that others make meaningless: lengths in the other unit, the other tones."""
    unit = "px" if settings.unit == "MILLIMETRE" else "mm"
    unused = {f"{name}_{unit}" for name in (*LENGTHS, "page_width")}
    kinds = {f"{level}_{kind}" for level in LEVELS for kind in ("share", "threshold")}
    return unused | (kinds - set(tone_fields(settings)))


def _lengths(settings: Any, width_px: int) -> dict[str, float]:
    """All lengths in pixels, by the names of the native options."""
    if settings.unit == "PIXEL":
        return {f"{name}_px": getattr(settings, f"{name}_px") for name in LENGTHS}
    millimetres = {f"{name}_mm": getattr(settings, f"{name}_mm") for name in LENGTHS}
    scale = width_px / settings.page_width_mm
    pixels: dict[str, float] = native.load().lengths_in_pixels(scale, **millimetres)
    return pixels


def register() -> None:
    """Puts the settings on every scene, as `scene.illustrate`."""
    bpy.utils.register_class(ILLUSTRATE_PG_settings)
    bpy.types.Scene.illustrate = PointerProperty(type=ILLUSTRATE_PG_settings)


def unregister() -> None:
    """Takes the settings away again."""
    del bpy.types.Scene.illustrate
    bpy.utils.unregister_class(ILLUSTRATE_PG_settings)
