"""Meshes that are no cages: the normals that they are shaded with, and what their styles say."""

import math
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Matrix

import tools
from tools import read

HARD_DEG = 5.0
CUBE = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def only_mesh(scene: Any) -> Any:
    bpy.context.view_layer.update()
    (mesh,) = read(scene).meshes
    return mesh


def hard_edges(mesh: Any) -> set[frozenset[Any]]:
    """Edges, as pairs of places, where the normals of two faces differ at either end.

    Vertices at the same place count as one.
    """
    at: dict[Any, list[Any]] = {}
    start = 0
    places = [tuple(np.round(p, 5)) for p in mesh.positions]
    normals = mesh.corner_normals / np.linalg.norm(mesh.corner_normals, axis=1)[:, None]
    for size in mesh.face_sizes:
        corners = np.arange(start, start + size)
        for a, b in zip(corners, np.roll(corners, -1), strict=True):
            ends = {places[mesh.corner_vertices[c]]: normals[c] for c in (a, b)}
            at.setdefault(frozenset(ends), []).append(ends)
        start += size
    least = math.cos(math.radians(HARD_DEG))
    return {
        edge
        for edge, sides in at.items()
        if len(sides) == 2 and any(sides[0][end] @ sides[1][end] < least for end in edge)
    }


def smooth_cube(scene: Any) -> Any:
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [True] * 6)
    return cube


def use_auto_smooth(thing: Any, degrees: float) -> None:
    """What Blender's Shade Auto Smooth does, up to 4.0 and after."""
    if hasattr(thing.data, "use_auto_smooth"):
        thing.data.use_auto_smooth = True
        thing.data.auto_smooth_angle = math.radians(degrees)
        return
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.shade_smooth_by_angle(angle=math.radians(degrees))


def test_a_mesh_that_is_shaded_flat_has_an_angle_and_no_normals(scene: Any) -> None:
    tools.cube_scene(scene)
    mesh = only_mesh(scene)
    assert not mesh.cage
    assert mesh.corner_normals is None
    assert mesh.crease_angle_deg == 30
    assert not len(mesh.edge_vertices)


def test_a_smooth_mesh_has_no_hard_edge(scene: Any) -> None:
    smooth_cube(scene)
    mesh = only_mesh(scene)
    assert not mesh.cage
    assert mesh.corner_normals.shape == (24, 3)
    assert not hard_edges(mesh)


def test_one_flat_face_of_a_smooth_object_is_hard_all_round(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [i != 2 for i in range(6)])
    corners = {tuple(cube.data.vertices[v].co) for v in cube.data.polygons[2].vertices}
    found = hard_edges(only_mesh(scene))
    assert len(found) == 4
    assert set().union(*found) == corners


def mark_sharp(thing: Any, edges: Any) -> None:
    if hasattr(thing.data, "use_auto_smooth"):
        thing.data.use_auto_smooth, thing.data.auto_smooth_angle = True, math.pi
    for edge in edges:
        thing.data.edges[edge].use_edge_sharp = True


def test_sharp_edges_of_smooth_faces_are_hard(scene: Any) -> None:
    cube = smooth_cube(scene)
    ring = [
        e.index for e in cube.data.edges if all(cube.data.vertices[v].co.z > 0 for v in e.vertices)
    ]
    mark_sharp(cube, ring)
    found = hard_edges(only_mesh(scene))
    assert found == {
        frozenset(tuple(cube.data.vertices[v].co) for v in cube.data.edges[e].vertices)
        for e in ring
    }


def test_sharp_edges_of_flat_faces_are_creases(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    cube.data.edges[4].use_edge_sharp = True
    mesh = only_mesh(scene)
    assert mesh.edge_vertices.tolist() == [list(cube.data.edges[4].vertices)]
    assert mesh.edge_sharpness.tolist() == [10]


@pytest.mark.parametrize(("degrees", "count"), [(30, 12), (80, 12), (100, 0)])
def test_auto_smooth_makes_edges_hard(scene: Any, degrees: float, count: int) -> None:
    use_auto_smooth(smooth_cube(scene), degrees)
    assert len(hard_edges(only_mesh(scene))) == count


def add_smooth_by_angle(thing: Any, degrees: float) -> None:
    """The modifier that Blender's Shade Auto Smooth adds from 4.1 on."""
    group = bpy.data.node_groups.new("Smooth by Angle", "GeometryNodeTree")
    for direction in ("INPUT", "OUTPUT"):
        group.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
    nodes = {
        name: group.nodes.new(kind)
        for name, kind in (
            ("in", "NodeGroupInput"),
            ("angle", "GeometryNodeInputMeshEdgeAngle"),
            ("more", "FunctionNodeCompare"),
            ("smooth", "GeometryNodeSetShadeSmooth"),
            ("out", "NodeGroupOutput"),
        )
    }
    nodes["smooth"].domain = "EDGE"
    nodes["more"].operation = "LESS_EQUAL"
    nodes["more"].inputs[1].default_value = math.radians(degrees)
    group.links.new(nodes["angle"].outputs[0], nodes["more"].inputs[0])
    group.links.new(nodes["more"].outputs[0], nodes["smooth"].inputs["Shade Smooth"])
    group.links.new(nodes["in"].outputs[0], nodes["smooth"].inputs["Geometry"])
    group.links.new(nodes["smooth"].outputs[0], nodes["out"].inputs[0])
    thing.modifiers.new("Smooth by Angle", "NODES").node_group = group


@pytest.mark.skipif(bpy.app.version < (4, 1, 0), reason="the modifier came with Blender 4.1")
@pytest.mark.parametrize(("degrees", "count"), [(30, 12), (100, 0)])
def test_a_modifier_that_marks_sharp_edges_counts(scene: Any, degrees: float, count: int) -> None:
    add_smooth_by_angle(smooth_cube(scene), degrees)
    assert len(hard_edges(only_mesh(scene))) == count


def test_weighted_normals_count(scene: Any) -> None:
    cube = smooth_cube(scene)
    if hasattr(cube.data, "use_auto_smooth"):
        cube.data.use_auto_smooth, cube.data.auto_smooth_angle = True, math.pi
    bevel = cube.modifiers.new("Bevel", "BEVEL")
    bevel.width, bevel.segments, bevel.limit_method = 0.3, 1, "NONE"
    tilted = only_mesh(scene).corner_normals
    cube.modifiers.new("Weighted", "WEIGHTED_NORMAL").weight = 100
    upright = only_mesh(scene).corner_normals
    assert np.abs(upright).max(axis=1).min() > np.abs(tilted).max(axis=1).min() + 0.1


@pytest.mark.parametrize("smooth", [True, False])
def test_custom_normals_are_read(scene: Any, smooth: bool) -> None:
    """Of flat faces too: files without smoothing groups hold nothing else, and renders show it."""
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [smooth] * 6)
    if hasattr(cube.data, "use_auto_smooth"):
        cube.data.use_auto_smooth = True
    wanted = np.random.default_rng(2).normal(size=(24, 3)) + 3 * np.array(
        [cube.data.polygons[i // 4].normal for i in range(24)]
    )
    wanted /= np.linalg.norm(wanted, axis=1)[:, None]
    for edge in cube.data.edges:
        edge.use_edge_sharp = True
    cube.data.normals_split_custom_set(wanted.tolist())
    assert only_mesh(scene).corner_normals == pytest.approx(wanted, abs=1e-3)


def test_custom_normals_that_blur_folds_do_not_count(scene: Any) -> None:
    """As of files that hold one normal for each vertex of a machine's part."""
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [False] * 6)
    if hasattr(cube.data, "use_auto_smooth"):
        cube.data.use_auto_smooth = True
    means = [cube.data.vertices[loop.vertex_index].co.normalized() for loop in cube.data.loops]
    cube.data.normals_split_custom_set([tuple(mean) for mean in means])
    mesh = only_mesh(scene)
    assert mesh.corner_normals is None
    assert mesh.crease_angle_deg == pytest.approx(31)


def test_vertices_that_an_importer_split_are_hard_by_their_normals(scene: Any) -> None:
    tools.add_camera(scene)
    points = [CUBE[v] for face in FACES for v in face]
    faces = [tuple(range(4 * i, 4 * i + 4)) for i in range(6)]
    split = tools.add_mesh("Split", points, faces)
    tools.shade_smooth(split, [True] * 6)
    assert len(hard_edges(only_mesh(scene))) == 12


PLACES = {
    "turned": Matrix.Rotation(0.7, 4, (1, 2, 3)),
    "mirrored": Matrix.Diagonal((-1, 1, 1, 1)),
    "stretched": Matrix.Diagonal((0.2, 2, 1, 1)) @ Matrix.Rotation(0.5, 4, "Z"),
    "mirrored and stretched": Matrix.Rotation(0.5, 4, "X") @ Matrix.Diagonal((2, -0.5, 1, 1)),
    "sheared": Matrix(((1, 0.5, 0, 0), (0, 1, 0.3, 0), (0, 0, 1, 0), (0, 0, 0, 1))),
    "tiny": Matrix.Diagonal((1e-5, 1e-5, 1e-5, 1)),
    "huge": Matrix.Diagonal((1e6, -1e6, 1e6, 1)),
    "flattened": Matrix.Diagonal((1, 1, 0, 1)),
}


@pytest.mark.parametrize("place", PLACES)
def test_normals_go_with_the_object(scene: Any, place: str) -> None:
    """Those of a flat face stay at right angles to it, on the side that it winds round."""
    cube = tools.cube_scene(scene)
    tools.shade_smooth(cube, [False] * 5 + [True])
    cube.matrix_world = PLACES[place]
    mesh = only_mesh(scene)
    corners = mesh.positions[mesh.corner_vertices].reshape(6, 4, 3)[:5]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = mesh.corner_normals.reshape(6, 4, 3)[:5]
    lengths = np.linalg.norm(across, axis=1)[:, None] * np.linalg.norm(normals, axis=2)
    along = np.einsum("fi,fci->fc", across, normals)
    seen = lengths > 1e-4 * lengths.max()
    assert seen.all() or place == "flattened"
    assert along[seen] == pytest.approx(lengths[seen], rel=1e-4)


def test_a_form_says_what_a_mesh_is(scene: Any) -> None:
    cube = smooth_cube(scene)
    style = cube.illustrate
    style.use_own, style.form = True, "CAGE"
    mesh = only_mesh(scene)
    assert mesh.cage and mesh.corner_normals is None
    assert (mesh.crease_angle_deg, mesh.boundary, mesh.scheme) == (180, "edges", None)
    style.form = "AUTO"
    assert not only_mesh(scene).cage
    tools.subdivide(cube, levels=2)
    mesh = only_mesh(scene)
    assert mesh.cage and len(mesh.positions) == 8
    style.form = "CAGE"
    assert len(only_mesh(scene).positions) == 8
    style.form = "MESH"
    mesh = only_mesh(scene)
    assert not mesh.cage and len(mesh.positions) == 98
    assert mesh.corner_normals.shape == (96 * 4, 3)


def test_modifiers_of_normals_alone_leave_a_cage_a_cage(scene: Any) -> None:
    cube = smooth_cube(scene)
    tools.subdivide(cube, levels=2)
    cube.modifiers.new("Weighted", "WEIGHTED_NORMAL")
    if bpy.app.version >= (4, 1, 0):
        add_smooth_by_angle(cube, 30)
    mesh = only_mesh(scene)
    assert mesh.cage and len(mesh.positions) == 8


def test_crease_angles_of_scene_collection_and_object(scene: Any) -> None:
    cube = tools.cube_scene(scene)

    def angle() -> float:
        return float(only_mesh(scene).crease_angle_deg)

    scene.illustrate.crease_angle = math.radians(50)
    assert angle() == 50
    scene.collection.illustrate.use_own = True
    assert angle() == 50
    scene.collection.illustrate.use_crease_angle = True
    assert angle() == 30
    cube.illustrate.use_own = cube.illustrate.use_crease_angle = True
    cube.illustrate.crease_angle = math.pi
    assert angle() == 180
    cube.illustrate.crease_angle = 0
    assert angle() == 0.1  # below it, what is cut of a flat face turns by rounding


def test_schemes_of_collection_and_object(scene: Any) -> None:
    cube = tools.cube_scene(scene)
    scene.illustrate.scheme = "loop"  # of all, through the options
    assert only_mesh(scene).scheme is None
    scene.collection.illustrate.use_own = True
    scene.collection.illustrate.scheme = "none"
    assert only_mesh(scene).scheme == "none"
    cube.illustrate.use_own = True
    assert only_mesh(scene).scheme is None
    cube.illustrate.scheme = "catmull-clark"
    assert only_mesh(scene).scheme == "catmull-clark"
    cube.illustrate.scheme = "none"
    tools.subdivide(cube)
    assert only_mesh(scene).scheme == "catmull-clark"  # as the modifier says


def test_a_crease_angle_decides_which_lines_are_drawn(scene: Any) -> None:
    """A prism of twelve sides, flat: its sides turn by 30 degrees, its ends by 90."""
    from illustrate import native
    from illustrate.running import illustration

    tools.add_camera(scene)
    bpy.ops.mesh.primitive_cylinder_add(vertices=12)

    def creases() -> int:
        made = illustration.illustrate(scene, bpy.context.evaluated_depsgraph_get())
        kinds = made.prepared.surface.feature_kinds
        return int((kinds == int(native.load().Kind.CREASE)).sum())

    found = []
    for degrees in (180, 89, 29):
        scene.illustrate.crease_angle = math.radians(degrees)
        found.append(creases())
    assert found[0] == 0 < found[1] < found[2]
