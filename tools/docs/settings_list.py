"""What each setting of the add-on does to a drawing: the one list that its pictures are made from.

A setting has an `Effect`: a scene and values to be shown side by side; or, where a drawing does not
show what it does, the reason in words. A test holds the list together with the add-on's own
definitions, and `make docs` fails where two pictures of an effect are the same.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

LIGHTS_ONLY = "needs a light other than the camera's, see the drawing beside"
WHERE = "says where, not what, is drawn"
HOW_LONG = "changes how long it takes, not what is drawn"


@dataclass(frozen=True)
class Effect:
    """Drawings of one scene that differ in one setting.

    values: caption and native options, by stage: 'prepare', 'draw', 'ball' (style of one object),
    'lights' (kinds). always: what all of them have.
    """

    scene: str
    values: tuple[tuple[str, dict[str, Any]], ...]
    always: dict[str, Any] = field(default_factory=dict)


def _caption(value: Any) -> str:
    """As the panels say it."""
    return {True: "on", False: "off"}[value] if isinstance(value, bool) else f"{value}"


def drawn(scene: str, name: str, *values: Any, **always: Any) -> Effect:
    """Values of a native option of the drawing."""
    return Effect(scene, tuple((_caption(value), {name: value}) for value in values), always)


def prepared(scene: str, name: str, *values: Any, **always: Any) -> Effect:
    """Values of a native option of the preparation."""
    shown = tuple((_caption(value), {"prepare": {name: value}}) for value in values)
    return Effect(scene, shown, always)


def style(name: str, *values: Any) -> Effect:
    """Values of the style of one object, the ball."""
    return Effect("ring", tuple((_caption(value), {"ball": {name: value}}) for value in values))


LINES_ONLY = {"hatching": False}
HIDDEN = {"hatching": False, "hidden_lines": (1, 3)}
SPARSE_CAGE = {"spacing_px": 9.0}

NATIVE: dict[str, Effect | str] = {
    # Surface
    "scheme": prepared("cage", "scheme", "catmull-clark", "loop", "none"),
    "level": prepared("cage", "level", 0, 1, -1),
    "edge_length": prepared("cage", "edge_length", 0.5, 0.0),
    "triangle_budget": prepared("cage", "triangle_budget", 100, 250_000),
    "most_intersections": Effect(
        "ring",
        (("500,000", {}), ("10", {"prepare": {"most_intersections": 10}})),
        LINES_ONLY,
    ),
    "threads": HOW_LONG,
    "rings": prepared("corner", "rings", 1, 3, prepare={"scheme": "none"}),
    "parabolic_ratio": prepared("corner", "parabolic_ratio", 0.0, 0.2, 1.0),
    "least_curvature": prepared("corner", "least_curvature", 0.0, 20.0),
    "largest_energy": prepared("corner", "largest_energy", 0.0, 0.05),
    "alignment_weight": prepared("cloth", "alignment_weight", 0.0, 1.0),
    "inverse_length_weights": prepared("corner", "inverse_length_weights", False, True),
    "field_start": prepared("ring", "field_start", "search", "principal"),
    "guide_radius": "needs guides: how far from them they alone say where hatches run",
    "max_evaluations": prepared(
        "ring", "max_evaluations", 0, 500, prepare={"field_start": "principal"}
    ),
    "default_direction": prepared("tube", "default_direction", (0.0, 0.0, 1.0), (1.0, 0.0, 1.0)),
    # Lines
    "line_width_px": drawn("ring", "line_width_px", 1.0, 2.0, 4.0),
    "feature_width_px": drawn("box", "feature_width_px", 0.7, 1.4, 3.0, **LINES_ONLY),
    "line_width_by_light": drawn("ring", "line_width_by_light", 0.0, 1.0, line_width_px=2.5),
    "line_width_by_depth": drawn("ring", "line_width_by_depth", 0.0, 0.8, line_width_px=2.5),
    "inner_width_scale": drawn("ring", "inner_width_scale", 1.0, 0.3, line_width_px=2.5),
    "line_width_by_crowding": drawn("fan", "line_width_by_crowding", 0.0, 1.0, **LINES_ONLY),
    "hidden_width_scale": drawn("ring", "hidden_width_scale", 0.2, 0.5, 1.0, **HIDDEN),
    "taper_px": drawn("ring", "taper_px", 0.0, 6.0, 40.0, line_width_px=3.0, hatching=False),
    "speck_px": drawn("cloth", "speck_px", 0.0, 60.0, suggestive_contours=True, hatching=False),
    "simplify_px": drawn("ring", "simplify_px", 0.1, 6.0),
    "marks": drawn("box", "marks", False, True, **LINES_ONLY),
    "materials": drawn("box", "materials", False, True, **LINES_ONLY),
    "flat_outlines": drawn(
        "prism", "flat_outlines", False, True, prepare={"scheme": "none"}, cage=True
    ),
    "loose_edges": drawn("box", "loose_edges", False, True, **LINES_ONLY),
    "terminators": drawn("floor", "terminators", False, True, **LINES_ONLY),
    "shadow_outlines": drawn("floor", "shadow_outlines", False, True, **LINES_ONLY),
    "suggestive_contours": drawn("cloth", "suggestive_contours", False, True, **LINES_ONLY),
    "suggestive_threshold": drawn(
        "cloth", "suggestive_threshold", 1.0, 2000.0, suggestive_contours=True, hatching=False
    ),
    "ridges": drawn("cloth", "ridges", False, True, **LINES_ONLY),
    "ridge_threshold": drawn("cloth", "ridge_threshold", 5.0, 60.0, ridges=True, hatching=False),
    "valleys": drawn("cloth", "valleys", False, True, **LINES_ONLY),
    "valley_threshold": drawn("cloth", "valley_threshold", 5.0, 60.0, valleys=True, hatching=False),
    # Hatching
    "hatching": drawn("ring", "hatching", True, False),
    "spacing_px": drawn("ring", "spacing_px", 5.0, 8.0, 16.0),
    "hatch_width_px": drawn("ring", "hatch_width_px", 0.5, 1.0, 2.0),
    "hatch_width_by_light": drawn("ring", "hatch_width_by_light", 0.0, 0.9, hatch_width_px=1.6),
    "undercut_spacing_px": drawn("ring", "undercut_spacing_px", 3.0, 5.0, 8.0),
    "least_spacing_px": drawn("ring", "least_spacing_px", 6.0, 12.0, 24.0, spacing_px=24.0),
    "test_factor": drawn("ring", "test_factor", 0.3, 0.9, hatch_seeding="critical-curves"),
    "min_length_px": drawn("ring", "min_length_px", 0.0, 40.0, hatch_seeding="critical-curves"),
    "max_length_px": drawn("ring", "max_length_px", 2500.0, 30.0),
    "hatch_seeding": drawn("ring", "hatch_seeding", "surface-curves", "critical-curves"),
    "max_turn_deg": drawn("ring", "max_turn_deg", 150.0, 20.0),
    "step_px": drawn("ring", "step_px", 0.5, 4.0, hatch_seeding="critical-curves", spacing_px=16.0),
    # Light
    "highlight_threshold": drawn("ring", "highlight_threshold", 0.6, 0.85, 1.0),
    "shadow_threshold": drawn("ring", "shadow_threshold", 0.1, 0.45, 0.7),
    "smallest_tone": drawn("floor", "smallest_tone", 0.0, 6.0, cast_shadows=True, spacing_px=10.0),
    "extra_levels": drawn("floor", "extra_levels", 0, 1, 3, cast_shadows=True),
    "reflectance": drawn("floor", "reflectance", 0.0, 1.0),
    "exposure": drawn("floor", "exposure", 0.5, 1.0, 2.0),
    "cast_shadows": drawn("floor", "cast_shadows", False, True),
    "mach_bands": drawn("ring", "mach_bands", False, True),
    "mach_band_px": drawn("ring", "mach_band_px", 2.0, 6.0, 14.0),
    "undercuts": drawn("ring", "undercuts", False, True),
    "undercut_px": drawn("ring", "undercut_px", 7.0, 14.0, 28.0),
    "undercut_contact": drawn("ring", "undercut_contact", 0.0, 0.5, 1.0),
    "cell_px": drawn("floor", "cell_px", 0.5, 64.0, cast_shadows=True, smallest_tone=0.0),
}
"""By the names of native options."""

AREA = {"highlight_share": 0.3, "shadow_share": 0.35}
SCENE: dict[str, Effect | str] = {
    "source": WHERE,
    "output": WHERE,
    "tone_source": "an image or a render in place of the lights: see the artists' guide, Film",
    "tone_image": "the image that *Tone From: Image* takes",
    "lighting": Effect(
        "ring",
        (
            ("Scene Lights", {"lights": "sun"}),
            ("Headlight", {"lights": "head"}),
            ("Side Light", {"lights": "side"}),
        ),
    ),
    "auto_exposure": drawn("floor", "auto_exposure", False, True, exposure=0.4),
    "tones": Effect("ring", (("By Brightness", {}), ("By Area", AREA))),
    "highlight_share": drawn("ring", "highlight_share", 0.1, 0.6, shadow_share=0.3),
    "shadow_share": drawn("ring", "shadow_share", 0.1, 0.6, highlight_share=0.3),
    "unit": "the same drawing, its lengths told in pixels or in millimetres of the page",
    "page_width_mm": "how many millimetres wide the picture is on paper",
    "hidden": Effect(
        "ring", (("off", {}), ("on", {"hidden_lines": (1, 1)})), LINES_ONLY
    ),
    "hidden_layers": Effect(
        "ring", (("1", {"hidden_lines": (1, 1)}), ("3", {"hidden_lines": (1, 3)})), LINES_ONLY
    ),
    "crease_angle": Effect(
        "faceted", (("0", {"crease_angle_deg": 1.0}), ("90", {"crease_angle_deg": 90.0}))
    ),
    "cut_by_alpha": "leaves, fences and decals have the outline of what their images show",
    "guides": "a collection of curves: see the artists' guide, Characters",
    "guide_weight": "how closely hatches follow the guides",
    "paper": "the colour behind the drawing in a viewport on paper",
    "line_color": "a colour",
    "feature_color": "a colour",
    "hatch_color": "a colour",
    "hidden_color": "a colour",
    "fill_regions": "fills below the lines in the colours of materials: see Plot, Regions",
    "in_front": "shows strokes over surfaces in the viewport",
    "keep_frames": WHERE,
    "use_scene_range": WHERE,
    "frame_start": WHERE,
    "frame_end": WHERE,
    "frame_step": WHERE,
    "keep_strokes": "between frames: strokes stay in place, or are placed anew",
}  # fmt: skip
"""Of the scene, that the native module does not know."""

OBJECTS: dict[str, Effect | str] = {
    "ignore": style("ignore", False, True),
    "occlude_only": style("occlude_only", False, True),
    "see_through": style("see_through", False, True),
    "lines": style("lines", True, False),
    "hatching": style("hatching", True, False),
    "loose_edges": "as Loose Edges of the scene, for this object alone",
    "spacing_scale": style("spacing_scale", 1.0, 2.0),
    "width_scale": style("width_scale", 1.0, 2.0),
    "form": Effect(
        "prism", (("Cage", {"cage": True}), ("Mesh", {"cage": False}))
    ),
    "scheme": "as Subdivision of the scene, for this object alone",
    "use_crease_angle": "its own Crease Angle instead of the scene's",
    "crease_angle": "as Crease Angle of the scene, for this object alone",
}  # fmt: skip
"""Of objects and collections."""
