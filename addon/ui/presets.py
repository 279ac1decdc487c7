"""Presets of the settings: those that come with the add-on, and the artist's own."""

import pathlib
from typing import Any

import bpy
from bl_operators.presets import AddPresetBase
from bl_ui.utils import PresetPanel

from ..messages import IllustrateError, quoted, said
from ..plot.settings import preset_fields as plot_preset_fields
from ..settings.scene_settings import preset_fields

FOLDER, PLOT_FOLDER = "illustrate", "illustrate_plot"
"""Below the presets of the artist's scripts, and below those of the add-on."""


def shipped_folder(kind: str = FOLDER) -> str:
    """Where the presets of the add-on are."""
    return str(pathlib.Path(__file__).parents[1] / "presets" / kind)


def find(name: str, kind: str = FOLDER) -> str:
    """The file of a preset by the name that the menu shows or its file has; empty: none such."""
    wanted = name.casefold().replace("_", " ")
    for folder in (*bpy.utils.preset_paths(kind), shipped_folder(kind)):
        for path in sorted(pathlib.Path(folder).glob("*.py")):
            if wanted in (_title(path), path.stem.casefold().replace("_", " ")):
                return str(path)
    return ""


def apply(name: str, kind: str = FOLDER) -> None:
    """Sets the scene's settings to a preset's. Raises IllustrateError when there is none such."""
    path = find(name, kind)
    if not path:
        listed = quoted(titles(kind), 20)
        raise IllustrateError(
            said('There is no preset "{name}": choose one of {listed}', name=name, listed=listed)
        )
    bpy.utils.execfile(path)


def titles(kind: str = FOLDER) -> list[str]:
    """Names of all presets as the menu shows them."""
    folders = (shipped_folder(kind), *bpy.utils.preset_paths(kind))
    paths = [path for folder in folders for path in sorted(pathlib.Path(folder).glob("*.py"))]
    return [bpy.path.display_name(str(path)) for path in paths]


def _title(path: pathlib.Path) -> str:
    title: str = bpy.path.display_name(str(path))
    return title.casefold()


class _PresetMenu:
    """A menu of presets."""

    preset_subdir = FOLDER
    preset_operator = "script.execute_preset"
    preset_add_operator = ""
    bl_idname = ""
    path_menu: Any

    def draw(self, _context: Any) -> None:
        """Shows the add-on's presets and the artist's."""
        self.path_menu(
            [shipped_folder(self.preset_subdir), *bpy.utils.preset_paths(self.preset_subdir)],
            self.preset_operator,
            props_default={"menu_idname": self.bl_idname},
            filter_ext=lambda extension: extension.lower() == ".py",
            add_operator=self.preset_add_operator,
        )


class ILLUSTRATE_MT_presets(_PresetMenu, bpy.types.Menu):
    """The menu of presets."""

    bl_idname = "ILLUSTRATE_MT_presets"
    bl_label = "Illustrate Presets"
    preset_add_operator = "illustrate.add_preset"


class ILLUSTRATE_MT_plot_presets(_PresetMenu, bpy.types.Menu):
    """The menu of presets of plots."""

    bl_idname = "ILLUSTRATE_MT_plot_presets"
    bl_label = "Plot Presets"
    preset_subdir = PLOT_FOLDER
    preset_add_operator = "illustrate.add_plot_preset"


class _PresetPanel(PresetPanel):
    """The presets that open from the head of a panel."""

    preset_operator = "script.execute_preset"

    def draw(self, context: Any) -> None:
        """Shows the menu."""
        layout = self.layout
        layout.emboss = "PULLDOWN_MENU"
        layout.operator_context = "EXEC_DEFAULT"
        _PresetMenu.draw(self, context)


class ILLUSTRATE_PT_presets(_PresetPanel, bpy.types.Panel):
    """Presets of the drawing."""

    bl_idname = "ILLUSTRATE_PT_presets"
    bl_label = "Illustrate Presets"
    preset_subdir = FOLDER
    preset_add_operator = "illustrate.add_preset"


class ILLUSTRATE_PT_plot_presets(_PresetPanel, bpy.types.Panel):
    """Presets of plots."""

    bl_idname = "ILLUSTRATE_PT_plot_presets"
    bl_label = "Plot Presets"
    preset_subdir = PLOT_FOLDER
    preset_add_operator = "illustrate.add_plot_preset"


class ILLUSTRATE_OT_add_preset(AddPresetBase, bpy.types.Operator):
    """Keeps the settings under a name."""

    bl_idname = "illustrate.add_preset"
    bl_label = "Add Illustrate Preset"
    bl_description = "Add or remove a preset of the settings"
    preset_menu = "ILLUSTRATE_MT_presets"
    preset_subdir = FOLDER

    @property
    def preset_values(self) -> list[str]:
        """What a preset holds. Blender 4.3 with Python 3.13 knows no names of `preset_defines`."""
        return [f"bpy.context.scene.illustrate.{name}" for name in preset_fields()]


class ILLUSTRATE_OT_add_plot_preset(AddPresetBase, bpy.types.Operator):
    """Keeps the settings of the plot under a name."""

    bl_idname = "illustrate.add_plot_preset"
    bl_label = "Add Plot Preset"
    bl_description = "Add or remove a preset of page, pens and order"
    preset_menu = "ILLUSTRATE_MT_plot_presets"
    preset_subdir = PLOT_FOLDER

    @property
    def preset_values(self) -> list[str]:
        """What a preset holds."""
        return [f"bpy.context.scene.illustrate_plot.{name}" for name in plot_preset_fields()]


CLASSES = (
    ILLUSTRATE_OT_add_preset,
    ILLUSTRATE_OT_add_plot_preset,
    ILLUSTRATE_MT_presets,
    ILLUSTRATE_MT_plot_presets,
    ILLUSTRATE_PT_presets,
    ILLUSTRATE_PT_plot_presets,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
