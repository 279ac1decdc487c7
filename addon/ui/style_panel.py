"""Panels in the properties of objects, collections and materials: their styles, and guides."""

from typing import Any

import bpy

from ..guides import is_guide, shown_of
from ..styles import OPTIONS, SURFACE


class _StylePanel:
    """A closed panel with a tick for its own style."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_label = "Illustrate"
    bl_options = {"DEFAULT_CLOSED"}
    layout: Any

    @staticmethod
    def owner(context: Any) -> Any:
        """Whose style is shown, or None."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is an owner."""
        return cls.owner(context) is not None

    def draw_header(self, context: Any) -> None:
        """Shows the tick."""
        self.layout.prop(self.owner(context).illustrate, "use_own", text="")

    def draw(self, context: Any) -> None:
        """Shows the style, grey where it does not count."""
        style = self.owner(context).illustrate
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.layout.active = style.use_own
        for name in (*OPTIONS, *SURFACE):
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
    def owner(context: Any) -> Any:
        """The object."""
        return context.object


class ILLUSTRATE_PT_collection_style(_StylePanel, bpy.types.Panel):
    """Of the collection."""

    bl_idname = "ILLUSTRATE_PT_collection_style"
    bl_context = "collection"

    @staticmethod
    def owner(context: Any) -> Any:
        """The collection."""
        return context.collection


class ILLUSTRATE_PT_material_style(bpy.types.Panel):
    """Of the material."""

    bl_idname = "ILLUSTRATE_PT_material_style"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_label = "Illustrate"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        """There is a material, and not one of strokes."""
        material = context.material
        return material is not None and not material.is_grease_pencil

    def draw_header(self, context: Any) -> None:
        """Shows the tick."""
        self.layout.prop(context.material.illustrate_material, "use_own", text="")

    def draw(self, context: Any) -> None:
        """Shows the style, grey where it does not count."""
        style = context.material.illustrate_material
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.layout.active = style.use_own
        self.layout.prop(style, "ignore")
        column = self.layout.column()
        column.active = not style.ignore
        for name in ("lines", "hatching", "spacing_scale", "width_scale"):
            column.prop(style, name)


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
    ILLUSTRATE_PT_guide,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
