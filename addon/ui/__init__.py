"""What the artist sees of the add-on: panels, menus, presets."""

from . import gallery, menus, panel, plot_panel, presets, style_panel

PARTS = (presets, gallery, panel, plot_panel, style_panel, menus)
