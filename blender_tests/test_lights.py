"""Lights as they are read, and as bright as Blender's own."""

import math
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Vector

import tools
from tools import read


def add_light(scene: Any, kind: str, place: Any, energy: float) -> Any:
    light = bpy.data.objects.new(kind, bpy.data.lights.new(kind, kind))
    light.location = place
    light.data.energy = energy
    scene.collection.objects.link(light)
    return light


def test_lights_are_read_with_their_place_and_direction(scene: Any) -> None:
    tools.add_camera(scene)
    tools.add_cube()
    sun = add_light(scene, "SUN", (9, 9, 9), 2)
    sun.rotation_euler.x = math.radians(90)  # shines along +y
    spot = add_light(scene, "SPOT", (0, 0, 5), 100)
    spot.data.spot_size = math.radians(60)
    add_light(scene, "POINT", (0, 0, 5), 100)
    add_light(scene, "AREA", (0, 0, 5), 100)
    add_light(scene, "POINT", (0, 0, 2), 0)
    lights = {light.kind: light for light in read(scene).lights}
    assert set(lights) == {"sun", "spot", "point", "area"}
    assert lights["sun"].vector == pytest.approx([0, -1, 0], abs=1e-6)
    assert lights["spot"].blend == pytest.approx(0.15)
    assert lights["sun"].strength == pytest.approx(2 / math.pi)
    assert lights["spot"].vector == pytest.approx([0, 0, 5])
    assert lights["spot"].direction == pytest.approx([0, 0, -1])
    assert lights["spot"].angle_rad == pytest.approx(math.radians(30))
    brighter = 4.0 if bpy.app.version >= (4, 0, 0) else math.pi
    assert lights["area"].strength == pytest.approx(brighter * lights["point"].strength)
    assert lights["spot"].cosine == (bpy.app.version < (3, 6, 0))
    assert not read(scene, use_lights=False).lights


def test_lamps_without_strength_and_with_too_much_are_left_out(scene: Any) -> None:
    from illustrate.running import illustration

    tools.add_camera(scene)
    tools.add_cube()
    for name, energy in (("Dead", 0.0), ("Sucking", -5.0), ("Blinding", math.inf)):
        add_light(scene, "POINT", (0, 0, 2), energy).name = name
    assert not read(scene).lights
    scene.illustrate.lighting = "SCENE"
    drawn = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    assert drawn.warnings == [
        'Light "Sucking" gives no light: its strength is negative',
        'Light "Blinding" gives no light: it is infinitely strong',
    ]
    assert not read(scene, use_lights=False).unusable_lights


def add_world(scene: Any, colour: Any, strength: float) -> Any:
    scene.world = bpy.data.worlds.new("Sky")
    scene.world.use_nodes = True
    background = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (*colour, 1.0)
    background.inputs["Strength"].default_value = strength
    return background


def test_the_world_is_light_from_everywhere(scene: Any) -> None:
    tools.add_camera(scene)
    tools.add_cube()
    add_world(scene, (0.5, 0.5, 0.5), 0.4)
    (light,) = read(scene).lights
    assert (light.kind, light.casts_shadows) == ("ambient", False)
    assert light.strength == pytest.approx(0.2)
    scene.view_settings.exposure = 1.0
    assert read(scene).lights[0].strength == pytest.approx(0.4)
    add_world(scene, (0, 0, 0), 1.0)
    assert not read(scene).lights


def test_an_area_light_has_its_extent(scene: Any) -> None:
    tools.add_camera(scene)
    tools.add_cube()
    lamp = add_light(scene, "AREA", (0, 0, 5), 100)
    lamp.data.shape, lamp.data.size, lamp.data.size_y = "ELLIPSE", 2, 3
    lamp.scale = (2, 1, 1)
    lamp.data.use_shadow = False
    bpy.context.view_layer.update()
    (light,) = read(scene).lights
    assert light.edges == pytest.approx(np.array([[4, 0, 0], [0, 3, 0]]), abs=1e-6)
    assert light.ellipse and not light.casts_shadows


AREA = {"energy": 150.0, "shape": "RECTANGLE", "size": 2.5, "size_y": 0.5}
LAMPS: dict[str, tuple[str, dict[str, Any]]] = {
    "sun": ("SUN", {"energy": 2.0, "angle": 0.0}),
    "bulb": ("POINT", {"energy": 300.0, "shadow_soft_size": 0.0}),
    "spot": (
        "SPOT",
        {"energy": 600.0, "shadow_soft_size": 0.0, "spot_size": 1.2, "spot_blend": 0.6},
    ),
    "area": ("AREA", AREA),
    "disk": ("AREA", {**AREA, "shape": "DISK", "size": 0.8}),
    "softbox": ("AREA", {**AREA, "energy": 60.0, "spread": math.radians(100)}),
    "power of its area": ("AREA", {**AREA, "normalize": False}),
    "power of its ball": (
        "POINT",
        {"energy": 250.0, "shadow_soft_size": 0.25, "normalize": False},
    ),
    "warm": ("POINT", {"energy": 300.0, "use_temperature": True, "temperature": 3000.0}),
    "two stops": ("POINT", {"energy": 75.0, "shadow_soft_size": 0.0, "exposure": 2.0}),
}
"""Kinds of lamps by what their settings do; those that a Blender does not have are not tested."""


def white_sphere(scene: Any) -> None:
    """A ball, seen from above with a pixel for every sixteenth of its radius."""
    tools.add_camera(scene, (0, 0, 8), (40, 40), type="ORTHO", ortho_scale=2.5)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48)
    bpy.ops.object.shade_smooth()
    material = bpy.data.materials.new("White")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    diffuse, output = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeOutputMaterial")
    diffuse.inputs["Color"].default_value = (1, 1, 1, 1)
    material.node_tree.links.new(diffuse.outputs[0], output.inputs[0])
    bpy.context.object.data.materials.append(material)


def rendered(scene: Any, folder: Any) -> Any:
    """(h, w) what Cycles makes of the scene, direct light only, first row at the top."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.use_denoising, cycles.max_bounces = 64, False, 0
    cycles.use_adaptive_sampling, cycles.filter_width = False, 0.01
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.filepath = str(folder / "light.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    size = image.size[1], image.size[0], image.channels
    pixels = np.array(image.pixels[:]).reshape(size)[::-1]
    return pixels[..., :3] @ np.array((0.2126, 0.7152, 0.0722))


def in_render_and_drawing(scene: Any, folder: Any, kind: str, settings: Any) -> tuple[Any, Any]:
    """(h, w) the brightness of a ball under a lamp, in the render and in the drawing."""
    from illustrate import native
    from illustrate.reading.scene import read_scene

    white_sphere(scene)
    lamp = add_light(scene, kind, (1.5, 1, 2.5), 1)
    if not all(hasattr(lamp.data, setting) for setting in settings):
        pytest.skip(f"lamps of this Blender have no such settings: {', '.join(settings)}")
    lamp.rotation_euler = Vector((1.5, 1, 2.5)).to_track_quat("Z", "Y").to_euler()
    for setting, value in settings.items():
        setattr(lamp.data, setting, value)
    bpy.context.view_layer.update()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    arrays = read_scene(scene, depsgraph)
    ill = native.load()
    prepared = ill.prepare([ill.PolygonMesh(**vars(mesh)) for mesh in arrays.meshes])
    lights = [ill.Light(**vars(light)) for light in arrays.lights]
    tone = ill.draw(prepared, ill.Camera(**vars(arrays.camera)), lights=lights).tone
    picture = np.minimum(1, rendered(scene, folder))
    rows, columns = np.indices(picture.shape) + 0.5
    inside = np.hypot(rows - 20, columns - 20) < 14
    assert picture[inside].max() > 0.2
    return picture[inside], tone.brightness[inside]


@pytest.mark.parametrize("name", LAMPS)
def test_brightness_is_what_the_render_shows(scene: Any, name: str, tmp_path: Any) -> None:
    picture, brightness = in_render_and_drawing(scene, tmp_path, *LAMPS[name])
    assert np.abs(picture - brightness).max() < 0.03


@pytest.mark.parametrize("soft", [{}, {"use_soft_falloff": False}], ids=["soft", "hard"])
def test_a_large_lamp_is_as_weak_near_it_as_in_the_render(
    scene: Any, soft: Any, tmp_path: Any
) -> None:
    settings = {"energy": 200.0, "shadow_soft_size": 0.8, **soft}
    picture, brightness = in_render_and_drawing(scene, tmp_path, "POINT", settings)
    lit = picture > 0.3  # where the lamp goes down it has no edge of light, but in the drawing
    assert np.abs(picture - brightness)[lit].max() < 0.03


def test_nodes_of_a_light_count_as_far_as_they_are_constant(scene: Any) -> None:
    tools.add_camera(scene)
    tools.add_cube()
    lamp = add_light(scene, "POINT", (0, 0, 5), 100)
    (plain,) = read(scene).lights
    lamp.data.use_nodes = True
    emission = next(n for n in lamp.data.node_tree.nodes if n.type == "EMISSION")
    emission.inputs["Strength"].default_value = 3.0
    emission.inputs["Color"].default_value = (0.5, 0.5, 0.5, 1.0)
    bpy.context.view_layer.update()
    (light,) = read(scene).lights
    assert light.strength == pytest.approx(1.5 * plain.strength)


def test_chosen_lights_have_lines(scene: Any) -> None:
    tools.add_camera(scene)
    tools.add_cube()
    tools.add_mesh("Floor", [(-9, -9, -1), (9, -9, -1), (9, 9, -1), (-9, 9, -1)], [(0, 1, 2, 3)])
    sun = add_light(scene, "SUN", (0, 0, 5), 2)
    sun.rotation_euler = (math.radians(40), 0, math.radians(210))
    scene.illustrate.lighting = "SCENE"
    scene.illustrate.shadow_outlines = True
    for is_chosen in (True, False):
        sun.data.illustrate.contours = is_chosen
        assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
        layers = tools.read_pencil(bpy.data.objects["Illustration"])
        assert bool(layers.get("Shadow Outline")) == is_chosen


def test_what_the_camera_does_not_see_has_shadow_lines(scene: Any) -> None:
    tools.add_camera(scene, (0, -9, 9))
    box = tools.add_cube(place=(0, 0, 3))
    tools.add_mesh("Floor", [(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [(0, 1, 2, 3)])
    add_light(scene, "SUN", (0, 0, 5), 2)  # from straight above
    scene.illustrate.lighting = "SCENE"
    scene.illustrate.shadow_outlines = True
    scene.illustrate.hatching = False
    box.visible_camera = False
    assert bpy.ops.illustrate.illustrate() == {"FINISHED"}
    layers = tools.read_pencil(bpy.data.objects["Illustration"])
    points = np.concatenate([stroke["points"] for stroke in layers["Shadow Outline"]])
    assert points.min(axis=0) == pytest.approx([-1, -1, 0], abs=1e-4)
    assert points.max(axis=0) == pytest.approx([1, 1, 0], abs=1e-4)
    assert not any(
        (np.asarray(stroke["points"])[:, 2] > 0.1).any()
        for layer in layers.values()
        for stroke in layer
    )
