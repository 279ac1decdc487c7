"""What a render shows is drawn; what cannot be drawn is named."""

import collections
from typing import Any, ClassVar

import bpy
import numpy as np
import pytest
from illustrate import native
from illustrate.reading import instances
from illustrate.running import illustration

import tools
from tools import read


def names(scene: Any) -> dict[str, int]:
    """How often each mesh is drawn."""
    bpy.context.view_layer.update()
    return dict(collections.Counter(mesh.name for mesh in read(scene).meshes))


def warnings(scene: Any) -> list[str]:
    made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
    return list(made.warnings)


def in_collection(thing: Any) -> Any:
    """A collection that is not in the scene, with the object moved to it."""
    inside = bpy.data.collections.new("Parts")
    for collection in thing.users_collection:
        collection.objects.unlink(thing)
    inside.objects.link(thing)
    return inside


def instance(inside: Any, x: float = 0.0) -> Any:
    owner = bpy.data.objects.new("Copy", None)
    owner.instance_type, owner.instance_collection = "COLLECTION", inside
    owner.location.x = x
    bpy.context.scene.collection.objects.link(owner)
    return owner


def test_instances_of_collections_are_drawn_where_they_are(scene: Any) -> None:
    tools.add_camera(scene)
    cube = tools.add_cube("Part")
    tools.subdivide(cube)
    inside = in_collection(cube)
    for x in (0, 4):
        instance(inside, x)
    meshes = read(scene).meshes
    assert [m.scheme for m in meshes] == ["catmull-clark"] * 2
    assert [m.positions[:, 0].min() for m in meshes] == [-1, 3]
    assert {m.name for m in meshes} == {"Part"}


def test_what_is_hidden_in_a_collection_is_not_instanced_by_it(scene: Any) -> None:
    tools.add_camera(scene)
    inside = in_collection(tools.add_cube("Part"))
    hidden = tools.add_cube("Hidden")
    hidden.hide_render = True
    inside.objects.link(hidden)
    scene.collection.objects.unlink(hidden)
    instance(inside)
    assert names(scene) == {"Part": 1}


def test_texts_and_curves_are_drawn_once(scene: Any) -> None:
    tools.add_camera(scene)
    curve = bpy.data.curves.new("Tube", "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", 0.2
    curve.splines.new("POLY").points.add(1)
    curve.splines[0].points[1].co = (1, 0, 0, 1)
    scene.collection.objects.link(bpy.data.objects.new("Tube", curve))
    bpy.ops.object.text_add()
    bpy.context.object.name = "Letters"
    bpy.ops.surface.primitive_nurbs_surface_torus_add()
    bpy.context.object.name = "Ring"
    bpy.ops.object.metaball_add()
    bpy.context.object.name = "Drop"
    assert names(scene) == {"Tube": 1, "Letters": 1, "Ring": 1, "Drop": 1}
    assert all(len(mesh.face_sizes) for mesh in read(scene).meshes)


def test_hidden_objects_are_left_out(scene: Any) -> None:
    tools.cube_scene(scene)
    tools.add_cube("No Render").hide_render = True
    tools.add_cube("No Viewport").hide_viewport = True
    inside = in_collection(tools.add_cube("In Hidden Collection"))
    scene.collection.children.link(inside)
    inside.hide_render = True
    assert names(scene) == {"Box": 1}


def particles(thing: Any, count: int, **settings: Any) -> Any:
    """Hair particles on an object."""
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.particle_system_add()
    chosen = thing.particle_systems[0].settings
    chosen.type, chosen.count = "HAIR", count
    for name, value in settings.items():
        setattr(chosen, name, value)
    return chosen


@pytest.mark.parametrize("hidden", [False, True])
def test_particles_instance_objects_that_are_hidden_themselves(scene: Any, hidden: bool) -> None:
    cube = tools.cube_scene(scene)
    ball = tools.add_cube("Ball", (0, 0, -50))
    ball.hide_render = ball.hide_viewport = hidden
    particles(cube, 20, render_type="OBJECT", instance_object=ball)
    assert names(scene) == {"Box": 1, "Ball": 20 if hidden else 21}
    cube.show_instancer_for_render = False
    assert "Box" not in names(scene)
    cube.show_instancer_for_render, cube.show_instancer_for_viewport = True, False
    assert names(scene)["Box"] == 1
    cube.hide_render = True
    tools.add_cube("Other")
    assert names(scene) == {"Other": 1} if hidden else {"Ball": 1, "Other": 1}


def add_nodes(thing: Any, *nodes: tuple[str, dict[str, Any], str, str]) -> Any:
    """A modifier of nodes in a row: type, properties, name of the input, of the output."""
    group = bpy.data.node_groups.new("Nodes", "GeometryNodeTree")
    if hasattr(group, "interface"):
        for direction in ("INPUT", "OUTPUT"):
            group.interface.new_socket(
                "Geometry", in_out=direction, socket_type="NodeSocketGeometry"
            )
    else:
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    last = group.nodes.new("NodeGroupInput").outputs[0]
    for kind, values, source, target in nodes:
        node = group.nodes.new(kind)
        for name, value in values.items():
            node.inputs[name].default_value = value
        group.links.new(last, node.inputs[source])
        last = node.outputs[target]
    group.links.new(last, group.nodes.new("NodeGroupOutput").inputs[0])
    thing.modifiers.new("Nodes", "NODES").node_group = group
    return group


def test_instances_of_nodes_are_drawn_where_they_are(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    part = tools.add_cube("Part", (0, 0, -50))
    part.hide_render = part.hide_viewport = True
    group = add_nodes(cube, ("GeometryNodeInstanceOnPoints", {}, "Points", "Instances"))
    info = group.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = part
    info.inputs["As Instance"].default_value = True
    on_points = next(n for n in group.nodes if n.bl_idname == "GeometryNodeInstanceOnPoints")
    group.links.new(info.outputs["Geometry"], on_points.inputs["Instance"])
    bpy.context.view_layer.update()
    arrays = read(scene)
    assert arrays.left_out == {}
    meshes = [mesh for mesh in arrays.meshes if mesh.name == "Part"]
    assert len(meshes) == 8
    middles = {tuple(np.round(mesh.positions.mean(axis=0))) for mesh in meshes}
    assert middles == {(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)}


def test_a_mesh_at_many_places_is_read_once(scene: Any, monkeypatch: Any) -> None:
    tools.add_camera(scene)
    inside = in_collection(tools.add_cube("Part"))
    for x in range(5):
        instance(inside, 4 * x)
    read_mesh, count = instances.read_mesh, []

    def counting(*arguments: Any) -> Any:
        count.append(arguments)
        return read_mesh(*arguments)

    monkeypatch.setattr(instances, "read_mesh", counting)
    assert names(scene) == {"Part": 5}
    assert len(count) == 1


def test_what_cannot_be_drawn_is_named_in_one_warning(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    assert warnings(scene) == []
    tools.add_mesh("Cloud", [(0, 0, 0), (1, 0, 0)], [])
    for name in ("Fog", "Smoke"):
        fog = bpy.data.objects.new(name, bpy.data.volumes.new(name))
        scene.collection.objects.link(fog)
    particles(cube, 5)
    (said,) = warnings(scene)
    assert said.startswith("Left out ")
    assert '1 object without faces ("Cloud")' in said
    assert '2 volumes ("Fog", "Smoke")' in said
    assert '1 object with particle hair ("Box")' in said
    cube.modifiers[0].show_render = False
    assert "hair" not in warnings(scene)[0]


def test_objects_that_cross_too_much_are_named_in_one_warning(scene: Any) -> None:
    tools.cube_scene(scene)
    tools.add_cube("Other").location = (0.3, 0.2, 0.1)
    bpy.context.view_layer.update()
    assert warnings(scene) == []
    scene.illustrate.most_intersections = 3
    (said,) = warnings(scene)
    assert '"Box", "Other"' in said
    assert "raise Crossings, under Surface and Field" in said


def test_points_that_nodes_make_are_named(scene: Any) -> None:
    tools.cube_scene(scene)
    add_nodes(tools.add_cube("Dust"), ("GeometryNodeMeshToPoints", {}, "Mesh", "Points"))
    bpy.context.view_layer.update()
    assert warnings(scene) == ['Left out 1 point cloud ("Dust")']


@pytest.mark.skipif(bpy.app.version < (4, 2, 0), reason="scripts cannot make hair curves before")
def test_hair_curves_are_named_where_there_are_any(scene: Any) -> None:
    tools.cube_scene(scene)
    fur = bpy.data.hair_curves.new("Fur")
    scene.collection.objects.link(bpy.data.objects.new("Fur", fur))
    assert warnings(scene) == []
    fur.add_curves([3, 4])
    bpy.context.view_layer.update()
    assert warnings(scene) == ['Left out 1 hair object ("Fur")']


class MeshesOfRender(bpy.types.RenderEngine):
    """Notes the meshes of the depsgraph that only a render gets."""

    bl_idname, bl_label = "MESHES_OF_RENDER", "Meshes of Render"
    seen: ClassVar[collections.Counter[str]] = collections.Counter()

    def render(self, depsgraph: Any) -> None:
        """Counts them by name."""
        self.seen.clear()
        self.seen.update(
            one.object.name
            for one in depsgraph.object_instances
            if one.object.type == "MESH" and one.show_self and len(one.object.data.polygons)
        )


def test_what_is_drawn_is_what_a_render_gets(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    ball = tools.add_cube("Ball", (0, 0, -50))
    ball.hide_render = ball.hide_viewport = True
    particles(cube, 7, render_type="OBJECT", instance_object=ball)
    bpy.ops.object.text_add()
    bpy.ops.object.metaball_add()
    tools.add_cube("No Render").hide_render = True
    inside = in_collection(tools.add_cube("Inside"))
    hidden = tools.add_cube("Hidden Inside")
    hidden.hide_render = True
    inside.objects.link(hidden)
    scene.collection.objects.unlink(hidden)
    instance(inside)
    dark = in_collection(tools.add_cube("Dark"))
    scene.collection.children.link(dark)
    dark.hide_render = True
    emitter = tools.add_cube("Emitter")
    particles(emitter, 3, render_type="OBJECT", instance_object=ball)
    emitter.show_instancer_for_render = False
    bpy.utils.register_class(MeshesOfRender)
    try:
        scene.render.engine = "MESHES_OF_RENDER"
        bpy.ops.render.render()
        scene.render.engine = "CYCLES"
    finally:
        bpy.utils.unregister_class(MeshesOfRender)
    assert names(scene) == dict(MeshesOfRender.seen)


class Spy:
    """The native module, which counts the meshes that are made of arrays."""

    def __init__(self) -> None:
        self.native = native.load()
        self.made = 0
        self.edge_lengths: list[float | None] = []

    def PolygonMesh(self, **arrays: Any) -> Any:  # noqa: N802
        self.made += 1
        self.edge_lengths.append(arrays["edge_length"])
        return self.native.PolygonMesh(**arrays)


def linked_copies(scene: Any, scale: tuple[float, ...] = (0.5, 0.5, 0.5)) -> list[Any]:
    """A cube with round edges, and two more objects of the same mesh, one of them turned."""
    tools.add_camera(scene)
    cube = tools.add_cube("Part")
    copies = [cube, cube.copy(), cube.copy()]
    for x, copy in enumerate(copies[1:], 1):
        scene.collection.objects.link(copy)
        copy.location.x = 4.0 * x
    copies[1].rotation_euler = (0.3, 0.5, 0.7)
    copies[2].scale = scale
    bpy.context.view_layer.update()
    return copies


def test_linked_copies_share_one_mesh(scene: Any) -> None:
    linked_copies(scene)
    arrays, spy = read(scene), Spy()
    meshes = illustration.native_meshes(spy, arrays)
    assert [mesh.name for mesh in meshes] == [mesh.name for mesh in arrays.meshes]
    assert spy.made == 1


def test_what_copies_share_is_as_fine_as_the_largest_asks(scene: Any) -> None:
    linked_copies(scene)
    arrays, spy = read(scene), Spy()
    illustration.native_meshes(spy, arrays)
    plain, turned, halved = (mesh.edge_length for mesh in arrays.meshes)
    assert spy.edge_lengths == [pytest.approx(min(plain, turned, 2 * halved))]


def test_a_mirrored_copy_is_a_mesh_of_its_own(scene: Any) -> None:
    linked_copies(scene, (-1.0, 1.0, 1.0))
    spy = Spy()
    illustration.native_meshes(spy, read(scene))
    assert spy.made == 2


def test_linked_copies_are_drawn_as_copies_of_their_own(scene: Any) -> None:
    copies = linked_copies(scene)
    shared = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get()).drawing
    for copy in copies:
        copy.data = copy.data.copy()
        copy.data.vertices[0].co.x *= 1 + 1e-4 * copies.index(copy)
    bpy.context.view_layer.update()
    own = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get()).drawing
    lines = [(d.kinds < int(native.load().Kind.HATCH)).sum() for d in (shared, own)]
    assert lines[0] == lines[1]
    assert shared.counts["crossings"] == own.counts["crossings"]
