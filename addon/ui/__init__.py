"""What the artist sees of the add-on: panels, menus, presets."""

from . import menus, panel, presets, style_panel

PARTS = (presets, panel, style_panel, menus)


def register() -> None:
    """Registers panels, menus and presets."""
    for part in PARTS:
        part.register()


def unregister() -> None:
    """Takes them away again."""
    for part in reversed(PARTS):
        part.unregister()
