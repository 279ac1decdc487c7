"""What the add-on reads of a scene."""

import itertools
from typing import Any

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from illustrate.reading import cages, mesh_arrays
from illustrate.reading.scene import NO_COLOUR, colour_of, read_camera
from mathutils import Matrix, Vector

import tools
from tools import read


def only_mesh(scene: Any) -> Any:
    meshes = read(scene).meshes
    assert len(meshes) == 1
    return meshes[0]


CAMERAS = list(
    itertools.product(
        ("PERSP", "ORTHO"),
        ("AUTO", "HORIZONTAL", "VERTICAL"),
        ((320, 240), (200, 300)),
        ((0, 0), (0.2, -0.1)),
        ((1, 1), (2, 1)),
    )
)


@pytest.mark.parametrize(("kind", "fit", "size", "shift", "aspect"), CAMERAS)
def test_camera_projects_as_blender_does(
    scene: Any, kind: str, fit: str, size: Any, shift: Any, aspect: Any
) -> None:
    eye = tools.add_camera(
        scene,
        size=size,
        type=kind,
        sensor_fit=fit,
        ortho_scale=7,
        shift_x=shift[0],
        shift_y=shift[1],
    )
    eye.scale = (2, 2, 2)
    scene.render.pixel_aspect_x, scene.render.pixel_aspect_y = aspect
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = read_camera(scene, depsgraph)
    assert (camera.width_px, camera.height_px) == size
    points = np.random.default_rng(1).uniform(-2, 2, (20, 3))
    clip = np.c_[points, np.ones(20)] @ (camera.projection @ camera.view).T
    ours = (clip[:, :2] / clip[:, 3:] + 1) / 2
    theirs = [world_to_camera_view(scene, eye, Vector(p))[:2] for p in points]
    assert np.abs(ours - theirs).max() < 1e-5
    assert camera.projection.dtype == camera.view.dtype == np.float64  # whatever Blender hands out


@pytest.mark.parametrize("kind", ["PERSP", "ORTHO"])
def test_pixel_size_is_what_a_pixel_covers(scene: Any, kind: str) -> None:
    tools.add_camera(scene, type=kind)
    scene.render.pixel_aspect_y = 2  # pixels are not square: their height counts
    camera = read_camera(scene, bpy.context.evaluated_depsgraph_get())
    up = camera.view[1, :3]
    points = np.array([[0.0, 0, 0], [1, 2, 0.5]])
    size = camera.pixel_size(points)
    clip = [
        np.c_[p, np.ones(2)] @ (camera.projection @ camera.view).T
        for p in (points, points + up * size[:, None])
    ]
    y = [(c[:, 1] / c[:, 3] + 1) / 2 * camera.height_px for c in clip]
    assert y[1] - y[0] == pytest.approx([1, 1], rel=1e-5)


def test_percentage_scales_the_image(scene: Any) -> None:
    tools.add_camera(scene, size=(320, 240))
    scene.render.resolution_percentage = 50
    camera = read_camera(scene, bpy.context.evaluated_depsgraph_get())
    assert (camera.width_px, camera.height_px) == (160, 120)


def test_meshes_are_read_in_world_space(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    cube.matrix_world = Matrix.Translation((1, 2, 3)) @ Matrix.Scale(2, 4)
    mesh = only_mesh(scene)
    assert mesh.name == "Box"
    assert mesh.positions.min(axis=0).tolist() == [-1, 0, 1]
    assert mesh.positions.max(axis=0).tolist() == [3, 4, 5]
    assert mesh.face_sizes.tolist() == [4] * 6
    assert len(mesh.corner_vertices) == 24


def halvings(scene: Any) -> int:
    """How often edges are halved until they are as short as the add-on asks."""
    mesh = only_mesh(scene)
    edge, count = 2.0, 0
    while edge > mesh.edge_length:
        edge, count = edge / 2, count + 1
    return count


def test_edges_are_three_units_at_the_nearest_point_at_most(scene: Any) -> None:
    tools.cube_scene(scene)
    for scale in (1.0, 0.3, 4.0):
        scene.camera.location = Vector((5, -6, 4)) * scale
        bpy.context.view_layer.update()
        arrays = read(scene)
        nearest = min(arrays.camera.unit_size(arrays.meshes[0].positions))
        assert 2.0 / 2 ** halvings(scene) <= 3 * nearest < 2.0 / 2 ** (halvings(scene) - 1)
    scene.camera.location = Vector((5, -6, 4)) * 1000
    bpy.context.view_layer.update()
    assert halvings(scene) == 0


def test_the_surface_is_the_same_at_any_number_of_pixels(scene: Any) -> None:
    tools.cube_scene(scene)
    lengths = []
    for percentage in (50, 100, 200, 300):
        scene.render.resolution_percentage = percentage
        lengths.append(only_mesh(scene).edge_length)
    assert len(set(lengths)) == 1


def test_a_moved_camera_asks_for_the_same_surface_until_another_level_is_due(scene: Any) -> None:
    tools.cube_scene(scene)
    lengths = []
    for i in range(30):
        scene.camera.location = Vector((5, -6, 4)) * 1.02**i
        bpy.context.view_layer.update()
        lengths.append(only_mesh(scene).edge_length)
    assert len(set(lengths)) == 2  # 1.02 ** 29 = 1.78
    assert lengths == sorted(lengths)


def mark_for_freestyle(mesh: Any, edge: int) -> None:
    if bpy.app.version >= (5, 0, 0):
        mesh.attributes.new("freestyle_edge", "BOOLEAN", "EDGE").data[edge].value = True
        return
    for _ in range(2):  # Blender 3.4 puts the very first mark elsewhere
        mesh.edges[0].use_freestyle_mark = False
        mesh.edges[edge].use_freestyle_mark = True


def test_freestyle_marks_and_materials_are_read(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    for _ in range(2):
        cube.data.materials.append(bpy.data.materials.new("Paint"))
    cube.data.polygons[3].material_index = 1
    mark_for_freestyle(cube.data, 5)
    mesh = only_mesh(scene)
    assert mesh.marked_edges.tolist() == [list(cube.data.edges[5].vertices)]
    assert mesh.face_materials.tolist() == [0, 0, 0, 1, 0, 0]


def add_wire(name: str, points: Any) -> Any:
    data = bpy.data.meshes.new(name)
    data.from_pydata(points, [(i, i + 1) for i in range(len(points) - 1)], [])
    wire = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(wire)
    return wire


def test_edges_of_no_face_are_read(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    edges = [*(tuple(edge.vertices) for edge in cube.data.edges), (0, 8)]
    places = [*(tuple(vertex.co) for vertex in cube.data.vertices), (3, 0, 0)]
    faces = [tuple(polygon.vertices) for polygon in cube.data.polygons]
    data = bpy.data.meshes.new("Hairy")
    data.from_pydata(places, edges, faces)
    cube.data = data
    assert only_mesh(scene).loose_edges.tolist() == [[0, 8]]


def test_objects_of_loose_edges_alone_are_drawn_where_that_is_asked_for(scene: Any) -> None:
    tools.cube_scene(scene)
    wire = add_wire("Wire", [(-2, 0, 0), (2, 0, 0), (2, 0, 2)])
    assert [mesh.name for mesh in read(scene).meshes] == ["Box"]
    assert read(scene).left_out == {"object without faces": ["Wire"]}
    wire.illustrate.use_own = wire.illustrate.loose_edges = True
    assert [mesh.name for mesh in read(scene).meshes] == ["Box", "Wire"]
    wire.illustrate.use_own = False
    scene.illustrate.loose_edges = True
    arrays = read(scene)
    assert [len(mesh.loose_edges) for mesh in arrays.meshes] == [0, 2]
    assert not arrays.left_out


def crease(cube: Any, edge: int, value: float) -> None:
    if bpy.app.version < (4, 0, 0):
        cube.data.edges[edge].crease = value
        return
    attribute = cube.data.attributes.get("crease_edge")
    attribute = attribute or cube.data.attributes.new("crease_edge", "FLOAT", "EDGE")
    attribute.data[edge].value = value


def test_the_cage_below_the_last_subdivision_is_read(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    crease(cube, 2, 1.0)
    crease(cube, 3, 0.5)
    tools.subdivide(cube, levels=3, boundary_smooth="PRESERVE_CORNERS")
    before = tools.snapshot()
    mesh = only_mesh(scene)
    assert tools.snapshot() == before
    assert (len(mesh.positions), mesh.scheme, mesh.boundary) == (8, "catmull-clark", "corners")
    assert mesh.crease_angle_deg == 180
    assert mesh.cage and mesh.corner_normals is None
    sharpness = {
        tuple(e): s for e, s in zip(mesh.edge_vertices.tolist(), mesh.edge_sharpness, strict=True)
    }
    assert sharpness == {
        tuple(cube.data.edges[2].vertices): 10.0,
        tuple(cube.data.edges[3].vertices): 2.5,
    }
    cube.modifiers[0].boundary_smooth = "ALL"
    cube.modifiers[0].use_creases = False
    mesh = only_mesh(scene)
    assert mesh.boundary == "edges"
    assert not len(mesh.edge_vertices)


@pytest.mark.parametrize("use_creases", [True, False])
def test_seams_of_a_cage_stay_sharp(scene: Any, use_creases: bool) -> None:
    """Its faces split apart, welded before drawing: Blender subdivides each alone."""
    cube = tools.cube_scene(scene)
    cube.modifiers.new("Split", "EDGE_SPLIT").split_angle = 0
    tools.subdivide(cube, use_creases=use_creases)
    mesh = only_mesh(scene)
    assert len(mesh.positions) == 24
    assert len(np.unique(np.sort(mesh.edge_vertices), axis=0)) == 24
    assert (mesh.edge_sharpness == 10).all()


def test_modifiers_below_the_subdivision_are_kept(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    array = cube.modifiers.new("Array", "ARRAY")
    array.count = 3
    tools.subdivide(cube)
    hidden = cube.modifiers.new("Hidden", "ARRAY")
    hidden.show_viewport = False
    mesh = only_mesh(scene)
    assert (len(mesh.positions), mesh.scheme) == (24, "catmull-clark")


def test_a_subdivision_that_is_not_the_last_is_evaluated(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    tools.subdivide(cube, levels=1)
    cube.modifiers.new("Array", "ARRAY").count = 2
    mesh = only_mesh(scene)
    assert (len(mesh.positions), mesh.scheme) == (52, None)


def test_simple_subdivision_is_drawn_as_it_is(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    tools.subdivide(cube, levels=1, subdivision_type="SIMPLE")
    mesh = only_mesh(scene)
    assert (len(mesh.positions), mesh.scheme) == (26, "none")


def test_keyframed_cages_are_read_at_their_frame(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    lift = cube.modifiers.new("Displace", "DISPLACE")
    lift.direction, lift.mid_level, lift.strength = "Z", 0, 0
    lift.keyframe_insert("strength", frame=1)
    lift.strength = 4
    lift.keyframe_insert("strength", frame=11)
    tools.subdivide(cube)
    for frame, height in ((1, 1.0), (11, 5.0)):
        scene.frame_set(frame)
        assert only_mesh(scene).positions[:, 2].max() == pytest.approx(height, abs=1e-5)


def bare(_cube: Any) -> None:
    """Nothing but the Subdivision."""


def shape_key(cube: Any) -> None:
    cube.shape_key_add(name="Basis")
    up = cube.shape_key_add(name="Up")
    for point in up.data:
        point.co.z += 2
    up.value = 0.5


def lattice_parent(cube: Any) -> None:
    lattice = bpy.data.objects.new("Lattice", bpy.data.lattices.new("Lattice"))
    lattice.scale = (2, 2, 2)
    bpy.context.scene.collection.objects.link(lattice)
    for point in lattice.data.points:
        point.co_deform.z += 0.5
    cube.parent, cube.parent_type = lattice, "LATTICE"
    bpy.context.view_layer.update()


@pytest.mark.parametrize("change", [bare, shape_key, lattice_parent])
def test_cages_are_read_with_all_that_changes_them(
    scene: Any, monkeypatch: Any, change: Any
) -> None:
    cube = tools.cube_scene(scene)
    tools.subdivide(cube)
    change(cube)
    found = only_mesh(scene)
    monkeypatch.setattr(cages, "_is_own_cage", lambda _: False)
    evaluated = only_mesh(scene)
    for name, values in vars(evaluated).items():
        np.testing.assert_array_equal(getattr(found, name), values, err_msg=name)
    assert (found.positions[:, 2].max() == 1) == (change is bare)


def test_a_subdivided_mesh_is_read_without_a_redraw(scene: Any, monkeypatch: Any) -> None:
    """Blender draws viewports anew when a scene comes or goes, and keys wait meanwhile."""
    tools.subdivide(tools.cube_scene(scene))
    monkeypatch.delattr(cages, "_evaluated_cages")
    assert len(only_mesh(scene).positions) == 8


def test_edits_in_edit_mode_are_read(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    bpy.context.view_layer.objects.active = cube
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.translate(value=(0, 0, 2))
    try:
        assert only_mesh(scene).positions[:, 2].min() == pytest.approx(1)
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.usefixtures("scene")
def test_the_colour_of_a_material_is_its_base_colour_or_in_the_viewport() -> None:
    assert colour_of(None) == NO_COLOUR
    made = bpy.data.materials.new("Red")
    made.diffuse_color = (1.0, 0.0, 0.0, 1.0)
    made.use_nodes = True
    base = next(n for n in made.node_tree.nodes if n.type == "BSDF_PRINCIPLED").inputs["Base Color"]
    base.default_value = (0.0, 0.5, 0.0, 1.0)
    assert colour_of(made) == (0.0, 0.5, 0.0, 1.0)
    if bpy.app.version < (5, 0, 0):
        made.use_nodes = False  # the nodes stay
        assert colour_of(made) == (1.0, 0.0, 0.0, 1.0)
        made.use_nodes = True
    made.node_tree.links.new(made.node_tree.nodes.new("ShaderNodeRGB").outputs[0], base)
    assert colour_of(made) == (1.0, 0.0, 0.0, 1.0)


def test_integers_are_copied_as_blender_holds_them(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    for elements, name in ((cube.data.loops, "vertex_index"), (cube.data.polygons, "loop_total")):
        values = np.zeros(len(elements), np.int32)
        held = mesh_arrays._as_held(elements, name, values)
        is_unsigned = elements[0].bl_rna.properties[name].subtype == "UNSIGNED"
        assert held.dtype == (np.uint32 if is_unsigned else np.int32)
        assert np.shares_memory(held, values)
        found = mesh_arrays._get(elements, name, np.int32)
        assert found.dtype == np.int32 and found.tolist() == [getattr(e, name) for e in elements]
    assert len(mesh_arrays._get(bpy.data.meshes.new("Empty").loops, "vertex_index", np.int32)) == 0
