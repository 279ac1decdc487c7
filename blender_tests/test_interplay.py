"""Our module beside Blender's own copies of what it is made with, in one process."""

from typing import Any

import bpy
import pytest
from illustrate import native
from illustrate.running import illustration
from illustrate.running.cache import CACHE

import tools


def drawing_bytes(scene: Any) -> bytes:
    """The drawing as JSON, computed anew from the meshes."""
    CACHE.clear()
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    text: str = native.load_part("drawing_json").to_json(made.drawing, 320, 240, made.names)
    return text.encode()


def subdivide_by_blender() -> None:
    """OpenSubdiv of Blender, on creased edges, to a level that leaves its mark."""
    thing = tools.add_cube("Blender's")
    tools.subdivide(thing, levels=5, boundary_smooth="PRESERVE_CORNERS")
    evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert len(evaluated.data.polygons) == 6 * 4**5
    bpy.data.objects.remove(thing)


def render(scene: Any, freestyle: bool) -> None:
    """Cycles, which traces rays with Embree; with Freestyle after it."""
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_percentage = 25
    scene.render.use_freestyle = freestyle
    linesets = bpy.context.view_layer.freestyle_settings.linesets
    if freestyle and not len(linesets):
        linesets.new("All")
    for lineset in linesets:  # Blender 3.4 forgets to make a line style and misses it then
        lineset.linestyle = lineset.linestyle or bpy.data.linestyles.new("Plain")
    assert bpy.ops.render.render() == {"FINISHED"}
    scene.render.use_freestyle, scene.render.resolution_percentage = False, 100


@pytest.mark.parametrize("others", ["subdivision", "cycles", "freestyle", "all"])
def test_drawings_are_the_same_after_blenders_own_work(scene: Any, others: str) -> None:
    cube = tools.cube_scene(scene)
    tools.subdivide(cube, levels=3)
    tools.add_cube("Beside", (1.2, 0.7, 0.4))
    before = drawing_bytes(scene)
    assert len(before) > 10_000
    if others in ("subdivision", "all"):
        subdivide_by_blender()
    if others in ("cycles", "all"):
        render(scene, freestyle=False)
    if others in ("freestyle", "all"):
        render(scene, freestyle=True)
    assert drawing_bytes(scene) == before
