"""Illustrate: line illustrations of smooth surfaces, as editable strokes."""

from . import operators, panel, settings

bl_info = {
    "name": "Illustrate",
    "author": "The Illustrate authors",
    "description": "Line illustrations of smooth surfaces, as editable strokes",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Side panel > Illustrate",
    "category": "Render",
}


def register() -> None:
    """Registers settings, operators and the panel."""
    settings.register()
    operators.register()
    panel.register()


def unregister() -> None:
    """Takes back all that `register` did."""
    panel.unregister()
    operators.unregister()
    settings.unregister()
