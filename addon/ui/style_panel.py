"""Panels in the properties of objects, collections and materials: their styles, and guides."""

from typing import Any

import bpy

from ..settings.guides import is_guide, shown_of
from ..settings.styles import OPTIONS, SURFACE


class _StylePanel:
    """A closed panel with a tick for its own style."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_label = "Illustrate"
    bl_options = {"DEFAULT_CLOSED"}
    fields: tuple[str, ...] = (*OPTIONS, *SURFACE)
    layout: Any

    @staticmethod
    def style(context: Any) -> Any:
        """What is shown, or None."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a style."""
        return cls.style(context) is not None

    def draw_header(self, context: Any) -> None:
        """Shows the tick."""
        self.layout.prop(self.style(context), "use_own", text="")

    def draw(self, context: Any) -> None:
        """Shows the style, grey where it does not count."""
        style = self.style(context)
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.layout.active = style.use_own
        for name in self.fields:
            row = self.layout.row()
            row.active = name == "ignore" or not style.ignore
            if name == "crease_angle":
                row.active = row.active and style.use_crease_angle
            row.prop(style, name)


class ILLUSTRATE_PT_object_style(_StylePanel, bpy.types.Panel):
    """Of the object."""

    bl_idname = "ILLUSTRATE_PT_object_style"
    bl_context = "object"

    @staticmethod
    def style(context: Any) -> Any:
        """Of the object."""
        return context.object and context.object.illustrate


class ILLUSTRATE_PT_collection_style(_StylePanel, bpy.types.Panel):
    """Of the collection."""

    bl_idname = "ILLUSTRATE_PT_collection_style"
    bl_context = "collection"

    @staticmethod
    def style(context: Any) -> Any:
        """Of the collection."""
        return context.collection and context.collection.illustrate


class ILLUSTRATE_PT_material_style(_StylePanel, bpy.types.Panel):
    """Of the material."""

    bl_idname = "ILLUSTRATE_PT_material_style"
    bl_context = "material"
    fields = ("ignore", "lines", "hatching", "spacing_scale", "width_scale", "own_pen")

    @staticmethod
    def style(context: Any) -> Any:
        """Of the material, but of one of strokes."""
        material = context.material
        if material is None or material.is_grease_pencil:
            return None
        return material.illustrate_material


class ILLUSTRATE_PT_light_style(bpy.types.Panel):
    """What is drawn of a light."""

    bl_idname = "ILLUSTRATE_PT_light_style"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "data"
    bl_label = "Illustrate"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a light."""
        return context.light is not None

    def draw(self, context: Any) -> None:
        """Shows its settings."""
        self.layout.use_property_split = True
        self.layout.prop(context.light.illustrate, "contours")


class ILLUSTRATE_PT_guide(bpy.types.Panel):
    """What an object of the collection of guides says."""

    bl_idname = "ILLUSTRATE_PT_guide"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "object"
    bl_label = "Illustrate Guide"

    @classmethod
    def poll(cls, context: Any) -> bool:
        """The object is a guide."""
        return context.object is not None and is_guide(context.object, context.scene)

    def draw(self, context: Any) -> None:
        """Shows what counts for its type."""
        self.layout.use_property_split = True
        self.layout.prop(context.object.illustrate_guide, shown_of(context.object))


CLASSES = (
    ILLUSTRATE_PT_object_style,
    ILLUSTRATE_PT_collection_style,
    ILLUSTRATE_PT_material_style,
    ILLUSTRATE_PT_light_style,
    ILLUSTRATE_PT_guide,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
