"""The lines of Line Art and Freestyle in frames of one surface, for bench_motion.py.

    blender -b --factory-startup --python peers_in_blender.py -- SCENE.npz STROKES.json

SCENE: positions (n, 3), triangles (t, 3), views (frames, 4, 4), projection (4, 4), size in pixels.
STROKES: for each method the world points of each stroke of each frame.
"""

import json
import sys
from typing import Any

import bpy
import mathutils
import numpy as np

GIVEN, FOUND = sys.argv[sys.argv.index("--") + 1 :]


def build(given: Any) -> Any:
    """An empty scene with the surface and a camera; the camera."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene, data = bpy.context.scene, bpy.data.meshes.new("surface")
    data.from_pydata(given["positions"].tolist(), [], given["triangles"].tolist())
    data.polygons.foreach_set("use_smooth", np.ones(len(data.polygons), bool))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.angle = 2 * np.arctan(1 / given["projection"][1, 1])
    camera.data.clip_start, camera.data.clip_end = 0.1, 100
    for thing in (bpy.data.objects.new("surface", data), camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = int(given["size"])
    return camera


def line_art() -> Any:
    """A function that gives the strokes of the scene as it is."""
    pencil, ink = bpy.data.grease_pencils.new("lines"), bpy.data.materials.new("ink")
    pencil.layers.new("Lines").frames.new(1)
    bpy.data.materials.create_gpencil_data(ink)
    pencil.materials.append(ink)
    thing = bpy.data.objects.new("lines", pencil)
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.evaluated_depsgraph_get().update()
    lines = thing.grease_pencil_modifiers.new("lines", "GP_LINEART")
    lines.use_contour = lines.use_crease = lines.use_intersection = True
    lines.use_loose = lines.use_material = lines.use_edge_mark = False
    lines.source_type, lines.target_layer, lines.target_material = "SCENE", "Lines", ink

    def strokes() -> list[Any]:
        thing.update_tag(refresh={"DATA"})
        graph = bpy.context.evaluated_depsgraph_get()
        graph.update()
        frame = thing.evaluated_get(graph).data.layers[0].frames[0]
        return [[list(point.co) for point in stroke.points] for stroke in frame.strokes]

    return strokes


def freestyle() -> Any:
    """The same; each call renders."""
    import parameter_editor  # type: ignore[import-not-found]
    from freestyle.types import StrokeShader  # type: ignore[import-not-found]

    scene, layer, found = bpy.context.scene, bpy.context.view_layer, []
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 1, False
    scene.render.use_freestyle = layer.use_freestyle = True
    sets = layer.freestyle_settings.linesets
    lines = sets[0] if len(sets) else sets.new("lines")
    lines.select_silhouette = lines.select_border = lines.select_crease = True
    lines.linestyle = bpy.data.linestyles.new("lines")

    class Collect(StrokeShader):
        def shade(self, stroke: Any) -> None:
            place = scene.camera.matrix_world  # Freestyle's world is the camera's space
            found.append([list(place @ vertex.point_3d) for vertex in stroke])

    collect = Collect()  # Freestyle does not hold what it is handed
    parameter_editor.callbacks_modifiers_post.append(lambda *_: [collect])

    def strokes() -> list[Any]:
        found.clear()
        bpy.ops.render.render()
        return list(found)

    return strokes


def main() -> None:
    """Writes the strokes of all frames."""
    given = dict(np.load(GIVEN))
    camera = build(given)
    told: dict[str, list[Any]] = {}
    for name, method in {"line art": line_art, "freestyle": freestyle}.items():
        strokes, told[name] = method(), []
        for view in given["views"]:
            camera.matrix_world = mathutils.Matrix(np.linalg.inv(view).tolist())
            bpy.context.view_layer.update()
            told[name].append(strokes())
    with open(FOUND, "w", encoding="utf-8") as file:
        json.dump(told, file)


main()
