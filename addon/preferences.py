"""Preferences of the add-on. With --addons it is registered and has none: the defaults count."""
# mypy: disable-error-code="valid-type"
# Blender reads properties from annotations.

from typing import Any

import bpy
from bpy.props import IntProperty

DEFAULTS: dict[str, Any] = {
    "live_triangles": 100_000,
}


class ILLUSTRATE_AP_preferences(bpy.types.AddonPreferences):
    """What is the artist's, not the scene's."""

    bl_idname = __package__
    live_triangles: IntProperty(
        name="Live Triangles",
        default=DEFAULTS["live_triangles"],
        min=1_000,
        soft_max=1_000_000,
        description="Most triangles that surfaces are refined to for the live drawing",
    )

    def draw(self, _context: Any) -> None:
        """Shows them one below the other."""
        self.layout.use_property_split = True
        for name in DEFAULTS:
            self.layout.prop(self, name)


def preference(name: str) -> Any:
    """A preference, or its default where the add-on has none."""
    addon = bpy.context.preferences.addons.get(__package__)
    chosen = getattr(addon, "preferences", None)
    value = DEFAULTS[name] if chosen is None else getattr(chosen, name)
    return value if isinstance(value, int | float) else tuple(value)


register, unregister = bpy.utils.register_classes_factory((ILLUSTRATE_AP_preferences,))
