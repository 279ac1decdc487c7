"""What the artist sees of the add-on: panels, menus, presets."""

from . import menus, panel, presets, style_panel

PARTS = (presets, panel, style_panel, menus)
