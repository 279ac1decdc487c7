"""What the artist sees of the add-on: panels, menus, presets."""

from . import menus, panel, plot_panel, presets, style_panel

PARTS = (presets, panel, plot_panel, style_panel, menus)
