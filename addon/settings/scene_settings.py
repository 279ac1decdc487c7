"""The settings of a scene: what is drawn, into what, and the native options field for field."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
)

from .. import native
from ..output import restyle
from ..reading.guide_arrays import GuideArrays
from ..reading.tone_images import SOURCES as TONE_SOURCES
from . import native_options
from .option_kinds import typed
from .styles import crease_angle

# A file keeps the number of a choice, the last of each entry here: numbers never change.
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
    ("PIXEL", "Pixels", "Widths and distances are pixels of the render", 0),
    ("MILLIMETRE", "Millimetres", "Widths and distances are millimetres on the page", 1),
]
PAPERS = [
    ("WHITE", "White", "White paper", 0),
    ("WORLD", "World", "Paper of the world's colour", 1),
]
BLACK = (0.0, 0.0, 0.0, 1.0)


# Blender registers an update function with exactly two positional arguments, and no other.
def _restyle(settings: Any, _context: Any) -> None:
    restyle(settings.id_data)


def _on_paper(settings: Any, _context: Any) -> None:
    for function in when_paper_changes:
        function(settings.id_data)


when_paper_changes: list[Any] = []
"""Called with the scene."""


def _colour(name: str, strokes: str, default: Any = BLACK) -> Any:
    return FloatVectorProperty(
        name=name,
        size=4,
        default=default,
        min=0.0,
        max=1.0,
        subtype="COLOR",
        description=f"Colour of {strokes}",
        update=_restyle,
    )


OWN: dict[str, Any] = {
    "source": EnumProperty(
        name="Draw", items=SOURCES, default="SCENE", description="Which objects are drawn"
    ),
    "output": EnumProperty(
        name="Output", items=OUTPUTS, default="GREASE_PENCIL", description="What strokes become"
    ),
    "tone_source": EnumProperty(
        name="Tone From",
        items=TONE_SOURCES,
        default="LIGHTS",
        description="What says how dark the hatching is",
    ),
    "tone_image": PointerProperty(
        type=bpy.types.Image,
        name="Image",
        description="As dark as this image the drawing is; it fills the picture. Of a sequence, "
        "the image of the frame",
    ),
    "lighting": EnumProperty(
        name="Light",
        items=LIGHTINGS,
        default="SCENE",
        description="Where light and shadow of the hatching come from",
    ),
    "auto_exposure": BoolProperty(
        name="Auto Exposure",
        default=True,
        description="Make the scene's light as strong as suits what is seen: the lightest places "
        "white, not most of it shadow; a sequence keeps what its first frame has",
    ),
    "tones": EnumProperty(
        name="Tones", items=TONES, default="LIGHT", description="What divides light from shadow"
    ),
    "highlight_share": FloatProperty(
        name="Highlight",
        default=0.3,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Share of what is seen that has no hatches",
    ),
    "shadow_share": FloatProperty(
        name="Shadow",
        default=0.35,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        description="Share of what is seen that has two directions of hatches",
    ),
    "unit": EnumProperty(
        name="Unit", items=UNITS, default="PIXEL", description="What widths and distances count in"
    ),
    "page_width_mm": FloatProperty(
        name="Page Width",
        default=200.0,
        min=1.0,
        max=100_000.0,
        soft_max=1000.0,
        description="Width of the page that the picture fills, millimetres",
    ),
    "hidden": BoolProperty(
        name="Hidden Lines",
        default=False,
        description="Draw lines that lie behind other surfaces too, on a layer of their own",
    ),
    "hidden_layers": IntProperty(
        name="Layers",
        default=1,
        min=1,
        max=64,
        description="Draw hidden lines with at most so many surfaces in front of them",
    ),
    "crease_angle": crease_angle("Flat-shaded faces that turn more make a hard edge"),
    "cut_by_alpha": BoolProperty(
        name="Cut By Alpha",
        default=True,
        description="Draw leaves, fences and decals with the outline of what their images show: "
        "nothing is where alpha is below 0.5, or below the threshold of a clipped material",
    ),
    "guides": PointerProperty(
        type=bpy.types.Collection,
        name="Guides",
        description="Hatches follow the curves and Grease Pencil strokes of this collection, "
        "drawn on the surfaces or near them, and turn round its empties; its objects are not drawn",
    ),
    "guide_weight": FloatProperty(
        name="Weight",
        default=10.0,
        min=0.0,
        soft_max=100.0,
        description="How closely hatches follow the guides; 10 is nearly exact",
    ),
    "paper": EnumProperty(
        name="Paper",
        items=PAPERS,
        default="WHITE",
        description="The colour behind the drawing in a viewport that is on paper",
        update=_on_paper,
    ),
    "line_color": _colour("Lines", "silhouettes and boundaries"),
    "feature_color": _colour("Features", "all other lines but hatches"),
    "hatch_color": _colour("Hatches", "hatches"),
    "hidden_color": _colour("Hidden", "hidden lines", (0.3, 0.3, 0.3, 1.0)),
    "fill_regions": BoolProperty(
        name="Fill Objects",
        default=False,
        description="Fill what is seen of objects with their materials' colours, on a layer below "
        "the lines, in Grease Pencil; needs the Python package shapely",
    ),
    "in_front": BoolProperty(
        name="In Front",
        default=True,
        description="Show strokes over the surfaces that they lie on",
        update=_restyle,
    ),
    "keep_frames": BoolProperty(
        name="Keep Frames",
        default=False,
        description="Leave drawings on other frames instead of replacing them all",
    ),
    "use_scene_range": BoolProperty(
        name="Scene Range", default=True, description="Bake the frames that the scene plays"
    ),
    "frame_start": IntProperty(name="Start", default=1, description="First frame to bake"),
    "frame_end": IntProperty(name="End", default=250, description="Last frame to bake"),
    "frame_step": IntProperty(
        name="Every",
        default=1,
        min=1,
        max=1000,
        description="Bake a drawing on every so many frames",
    ),
    "keep_strokes": BoolProperty(
        name="Keep Strokes",
        default=True,
        description="Start each frame from the strokes of the last one, so that they stay in place",
    ),
}
"""The add-on's own settings, that the native module does not know."""

SHARES = ("highlight_share", "shadow_share")
NOT_IN_PRESETS = {
    "source",
    "guides",
    "tone_image",
    "use_scene_range",
    "frame_start",
    "frame_end",
    "frame_step",
}


class ILLUSTRATE_PG_settings(bpy.types.PropertyGroup):
    """How the illustration of a scene is made."""

    __annotations__ = {**OWN, **native_options.properties()}

    def restore_defaults(self) -> None:
        """Sets all that presets hold to what it is in a new scene."""
        for name in preset_fields():
            self.property_unset(name)


def preset_fields() -> list[str]:
    """Names of the settings that a preset holds."""
    names = (*OWN, *native_options.properties())
    return [name for name in names if name not in NOT_IN_PRESETS]


def px_per_mm(settings: Any, width_px: int) -> float:
    """Pixels of a picture of width_px for a millimetre of the page; 0 where pixels are the unit."""
    return width_px / settings.page_width_mm if settings.unit == "MILLIMETRE" else 0.0


def prepare_values(settings: Any) -> dict[str, Any]:
    """Values of `illustrate_native.PrepareOptions` but its guides, by their names."""
    return native_options.values(native_options.PREPARE, settings, 0.0)


def draw_values(settings: Any, width_px: int) -> dict[str, Any]:
    """Values of `illustrate_native.DrawOptions` but its styles, by their names."""
    values = native_options.values(native_options.DRAW, settings, px_per_mm(settings, width_px))
    values["hidden_lines"] = (1, settings.hidden_layers) if settings.hidden else None
    for name in SHARES:
        by_area = settings.tones == "AREA"
        values[name] = typed(getattr(settings, name)) if by_area else None
    return values


def live_values(chosen: Any) -> tuple[Any, Any]:
    """What live drawings look at: values that decide about shapes, and about all else."""
    guides = chosen.guides.name if chosen.guides is not None else ""
    shaping: tuple[Any, ...] = (prepare_values(chosen), chosen.source, guides, chosen.guide_weight)
    image = chosen.tone_image.name if chosen.tone_image is not None else ""
    look = (draw_values(chosen, 1000), chosen.lighting, chosen.tone_source, image)
    shaping += (chosen.crease_angle, chosen.loose_edges, chosen.cut_by_alpha)
    return shaping, (*look, chosen.auto_exposure)


def prepare_options(values: dict[str, Any], guides: GuideArrays, guide_weight: float) -> Any:
    """`illustrate_native.PrepareOptions`. guide_weight: of strokes that weigh 1."""
    ill = native.load()
    strokes = zip(guides.strokes, guides.weights, strict=True)
    return ill.PrepareOptions(
        **values,
        guides=[ill.Guide(points, guide_weight * weight) for points, weight in strokes],
        singularities=(guides.turn_places, guides.turns) if guides.turns else None,
    )


def draw_options(values: dict[str, Any], styles: list[dict[str, Any]]) -> Any:
    """`illustrate_native.DrawOptions`. styles: arguments of ObjectStyle, one for each mesh."""
    ill = native.load()
    chosen = [_object_style(ill, style) for style in styles] if any(styles) else None
    return ill.DrawOptions(**values, styles=chosen)


def _object_style(ill: Any, style: dict[str, Any]) -> Any:
    materials = [ill.MaterialStyle(**own) for own in style.get("materials", ())]
    return ill.ObjectStyle(**{**style, "materials": materials})


def register() -> None:
    """Puts the settings on every scene, as `scene.illustrate`."""
    bpy.utils.register_class(ILLUSTRATE_PG_settings)
    bpy.types.Scene.illustrate = PointerProperty(type=ILLUSTRATE_PG_settings)


def unregister() -> None:
    """Takes the settings away again."""
    del bpy.types.Scene.illustrate
    bpy.utils.unregister_class(ILLUSTRATE_PG_settings)
