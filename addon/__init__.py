"""Illustrate: line illustrations of smooth surfaces, as editable strokes."""

from . import preferences, translations, ui, viewport
from .farm import command
from .farm import operator as farm_operator
from .plot import export, pens
from .plot import settings as plot_settings
from .running import bake, cache, first_use, jobs, operators, tasks
from .settings import guides, styles
from .settings import scene_settings as settings

bl_info = {
    "name": "Illustrate",
    "author": "The Illustrate authors",
    "description": "Line illustrations of smooth surfaces, as editable strokes",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Side panel > Illustrate",
    "category": "Render",
}

PARTS = (
    preferences,
    settings,
    styles,
    guides,
    cache,
    operators,
    first_use,
    bake,
    farm_operator,
    plot_settings,
    pens,
    export,
    *viewport.PARTS,
    *ui.PARTS,
    translations,
    command,
)


def register() -> None:
    """Registers all parts."""
    for part in PARTS:
        part.register()


def unregister() -> None:
    """Takes back all that `register` did, and waits for what still runs."""
    tasks.stop_all()
    jobs.stop_all()
    for part in reversed(PARTS):
        part.unregister()
