"""Text: letters of Blender's own font.

Outlines and creases, hatches round the bows of the letters, and the shadow that the word casts on
the ground.
"""

import bpy
import scenes


def build() -> None:
    """One word that stands on the ground."""
    curve = bpy.data.curves.new("Line", "FONT")
    curve.body, curve.extrude = "Line", 0.14
    curve.resolution_u = 24
    word = bpy.data.objects.new("Line", curve)
    word.rotation_euler[0] = 1.5708
    bpy.context.scene.collection.objects.link(word)
    bpy.ops.object.select_all(action="DESELECT")
    word.select_set(True)
    bpy.context.view_layer.objects.active = word
    bpy.ops.object.convert(target="MESH")
    word.data.polygons.foreach_set("use_smooth", [False] * len(word.data.polygons))
    bpy.ops.mesh.primitive_plane_add(size=1, location=(0.95, -0.05, -0.012))
    ground = bpy.context.object
    ground.scale = (2.5, 1.2, 1)
    scenes.finish([bpy.data.objects["Line"], ground], toward_camera=(-0.4, -1.3, 0.4),
                  size=(1600, 850))  # fmt: skip
    settings = bpy.context.scene.illustrate
    settings.lighting, settings.spacing_px, settings.line_width_px = "SIDE", 7.0, 3.0
    settings.undercut_px, settings.mach_band_px, settings.scheme = 12.0, 4.0, "none"
