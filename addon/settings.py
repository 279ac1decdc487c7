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
]

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

    line_width_px: FloatProperty(
        name="Line Width",
        default=2.0,
        min=0.05,
        max=100.0,
        soft_max=10.0,
        subtype="PIXEL",
        description="Width of silhouettes and boundaries, pixels of the render",
    )
    feature_width_px: FloatProperty(
        name="Feature Width",
        default=1.4,
        min=0.05,
        max=100.0,
        soft_max=10.0,
        subtype="PIXEL",
        description="Width of all other lines but hatches, pixels of the render",
    )
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
    spacing_px: FloatProperty(
        name="Spacing",
        default=8.0,
        min=1.0,
        max=200.0,
        soft_max=40.0,
        subtype="PIXEL",
        description="Distance between neighbouring hatches, pixels of the render",
    )
    hatch_width_px: FloatProperty(
        name="Hatch Width",
        default=1.0,
        min=0.05,
        max=100.0,
        soft_max=10.0,
        subtype="PIXEL",
        description="Width of hatches in middling light, pixels of the render",
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
    undercuts: BoolProperty(
        name="Undercuts", default=True, description="Hatch densely what lies just behind a fold"
    )
    mach_bands: BoolProperty(
        name="Mach Bands",
        default=True,
        description="Leave a narrow band along the near side of a fold white",
    )

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


def draw_options(settings: Any) -> Any:
    """`illustrate_native.DrawOptions` of the settings (an ILLUSTRATE_PG_settings)."""
    names = (
        "line_width_px",
        "feature_width_px",
        *LINE_KINDS,
        "hatching",
        "spacing_px",
        "hatch_width_px",
        "highlight_threshold",
        "shadow_threshold",
        "undercuts",
        "mach_bands",
        "threads",
    )
    options = _fill(native.load().DrawOptions(), settings, names)
    if settings.hidden:
        options.hidden_lines = (1, settings.hidden_layers)
    return options


def register() -> None:
    """Puts the settings on every scene, as `scene.illustrate`."""
    bpy.utils.register_class(ILLUSTRATE_PG_settings)
    bpy.types.Scene.illustrate = PointerProperty(type=ILLUSTRATE_PG_settings)


def unregister() -> None:
    """Takes the settings away again."""
    del bpy.types.Scene.illustrate
    bpy.utils.unregister_class(ILLUSTRATE_PG_settings)
