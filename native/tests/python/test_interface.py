"""The public interface: names, shapes, dtypes, messages, progress, threads."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import LEVEL, arrays_of, digest, draw, prepared_of
from shapes import SIZE_PX, Shape, cube, drape, klein_bottle, look_at, sphere, torus


@pytest.fixture(scope="module")
def prepared() -> ill.Prepared:
    return prepared_of(torus())


@pytest.fixture(scope="module")
def drawing(prepared: ill.Prepared) -> ill.Drawing:
    return draw(prepared, look_at())


def public_names(names: Iterable[str]) -> set[str]:
    return {name for name in names if not name.startswith("_")}


def test_stub_says_what_the_module_has() -> None:
    stub = ast.parse((Path(ill.__file__).parent / "_core.pyi").read_text())
    for node in stub.body:
        if not isinstance(node, ast.ClassDef) or issubclass(getattr(ill, node.name), Exception):
            continue
        said = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
        said |= {
            n.target.id
            for n in node.body
            if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name)
        }
        said |= {
            t.id
            for n in node.body
            if isinstance(n, ast.Assign)
            for t in n.targets
            if isinstance(t, ast.Name)
        }
        assert public_names(said) == public_names(vars(getattr(ill, node.name))), node.name


def test_every_public_name_is_there() -> None:
    for name in ill.__all__:
        assert hasattr(ill, name), name
    assert [int(kind) for kind in ill.Kind] == list(range(17))
    assert {node.name: int(node) for node in ill.Node} == {
        "CUSP": 0, "CROSSING": 1, "JOINT": 2, "END": 3,
    }  # fmt: skip
    assert int(ill.Kind.HATCH) == 4
    assert issubclass(ill.InvalidInput, ValueError)


@pytest.mark.parametrize(
    ("name", "dtype", "columns"),
    [
        ("points", "f8", 3), ("image", "f8", 2), ("widths", "f4", None),
        ("triangles", "i4", None), ("barycentrics", "f4", 2), ("offsets", "i4", None),
        ("kinds", "u1", None), ("closed", "?", None), ("objects", "i4", None),
        ("invisibility", "i4", None), ("graph.node_kind", "u1", None),
        ("graph.node_image", "f8", 2), ("graph.node_arcs", "i4", 4),
        ("graph.arc_nodes", "i4", 2), ("graph.arc_kind", "u1", None),
        ("graph.arc_invisibility", "i4", None), ("graph.arc_flush", "u1", None),
        ("graph.arc_layers_over", "i4", None), ("graph.arc_offsets", "i4", None),
        ("graph.arc_image", "f8", 2), ("graph.arc_points", "f8", 3),
    ],
)  # fmt: skip
def test_arrays_of_a_drawing(
    drawing: ill.Drawing, name: str, dtype: str, columns: int | None
) -> None:
    array = arrays_of(drawing)[name]
    assert array.dtype == np.dtype(dtype)
    assert array.ndim == (1 if columns is None else 2)
    assert columns is None or array.shape[1] == columns
    assert len(array) > 0
    with pytest.raises(ValueError, match="read-only"):
        array[0] = 0


def test_arrays_of_a_surface(prepared: ill.Prepared) -> None:
    surface = prepared.surface
    n = len(surface.positions)
    for name in ("positions", "normals", "w1", "w2", "hatch_w1", "hatch_w2"):
        assert getattr(surface, name).shape == (n, 3)
        assert getattr(surface, name).dtype == np.float64
    for name in ("k1", "k2", "hatch_k1", "hatch_k2"):
        assert getattr(surface, name).shape == (n,)
    assert surface.triangles.shape[1] == 3
    assert surface.triangles.dtype == surface.objects.dtype == surface.base_faces.dtype == np.int32
    assert surface.objects.shape == surface.base_faces.shape == (n,)
    assert surface.base_uv.shape == (n, 2)
    assert surface.feature_edges.shape == (len(surface.feature_kinds), 2)
    assert surface.triangles.max() == n - 1


def test_arrays_of_a_field(prepared: ill.Prepared) -> None:
    field, surface = prepared.field, prepared.surface
    assert field.directions.shape == surface.positions.shape
    assert field.reliable.dtype == np.bool_
    assert np.abs((field.directions * surface.normals).sum(1)).max() < 1e-9
    assert field.energy <= field.energy_initial + 1e-9 * abs(field.energy_initial)
    assert field.singular_indices.sum() == 0  # a torus: 4 chi = 0


def test_reports_counts_and_timings(prepared: ill.Prepared, drawing: ill.Drawing) -> None:
    stages = {"sanitize", "surface", "dual_surface", "intersections", "curvature", "field"}
    assert stages <= set(prepared.timings)
    assert set(drawing.timings) == {"contour", "visibility", "tone", "hatch", "stroke"}
    expected = {"triangles_visited", "silhouette_triangles", "crossings", "cusps", "rays", "loops",
                "unbalanced_loops", "repairs", "hatch_steps", "strokes"}  # fmt: skip
    assert expected <= set(drawing.counts)
    assert drawing.counts["strokes"] == len(drawing.kinds)
    assert drawing.counts["cusps"] == (drawing.graph.node_kind == ill.Node.CUSP).sum()
    assert drawing.tone.level.shape == drawing.tone.band.shape == (SIZE_PX, SIZE_PX)
    assert drawing.tone.level.dtype == np.uint8
    assert drawing.tone.cell_px == 1
    assert drawing.repair_max_px >= 0


def test_mended_mesh_is_named() -> None:
    broken = cube().positions.copy()
    broken[3] = np.nan
    bad = Shape(broken, cube().face_sizes, cube().corner_vertices)
    found = ill.prepare([cube().mesh(name="whole"), bad.mesh(name="torn")],
                        ill.PrepareOptions(level=LEVEL))  # fmt: skip
    whole, torn = found.reports
    assert (whole["name"], torn["name"]) == ("whole", "torn")
    assert torn["nan_vertices"] == 1
    assert whole.get("nan_vertices", 0) == 0
    assert found.report["nan_vertices"] == 1


def test_mesh_without_faces_stays_an_object() -> None:
    empty = ill.PolygonMesh(np.zeros((0, 3)), [], [])
    found = ill.prepare([empty, cube().mesh()], ill.PrepareOptions(level=LEVEL))
    assert set(found.surface.objects) == {1}
    assert set(draw(found, look_at()).objects) == {1}
    assert len(draw(ill.prepare([]), look_at()).kinds) == 0


@pytest.mark.parametrize("options", [ill.PrepareOptions, ill.DrawOptions, ill.ObjectStyle])
def test_options_have_no_other_attributes(options: Callable[..., object]) -> None:
    with pytest.raises(AttributeError):
        options().no_such_option = 1  # type: ignore[attr-defined]
    with pytest.raises(TypeError, match="no_such_option"):
        options(no_such_option=1)


def test_options_keep_what_is_set() -> None:
    prepare_options = ill.PrepareOptions(scheme="loop", default_direction=[1, 0, 0])
    assert prepare_options.scheme == "loop"
    assert list(prepare_options.default_direction) == [1, 0, 0]
    assert (prepare_options.level, prepare_options.triangle_budget) == (-1, 250_000)
    style = ill.ObjectStyle()
    options = ill.DrawOptions(hidden_lines=(1, 2), styles=[style])
    assert options.hidden_lines == (1, 2)
    assert options.styles is not None
    options.styles[0].lines = False
    assert not style.lines
    options.hidden_lines = None
    assert options.hidden_lines is None


def of_any_layout() -> list[tuple[Any, Any, Any]]:
    box = cube()
    p, f, c = box.positions, box.face_sizes, box.corner_vertices
    wide = np.full((16, 6), 7.0)
    wide[::2, ::2] = p
    return [
        (p.tolist(), f.tolist(), c.tolist()),
        (wide[::2, ::2], np.repeat(f, 2)[::2], np.repeat(c, 3)[::3]),
        (np.asfortranarray(p), f, c),
        (p[::-1].copy()[::-1], f[::-1].copy()[::-1], c[::-1].copy()[::-1]),
        (p.astype("f4"), f.astype("i8"), c.astype("u4")),
        (p.astype(int), f.astype("u1"), c.astype(">i2")),
    ]


@pytest.mark.parametrize("arrays", of_any_layout())
def test_layout_of_arrays_does_not_matter(arrays: tuple[Any, Any, Any]) -> None:
    options = ill.PrepareOptions(level=LEVEL)
    plain = draw(ill.prepare([cube().mesh()], options), look_at())
    same = draw(ill.prepare([ill.PolygonMesh(*arrays)], options), look_at())
    assert digest(plain) == digest(same)


def test_previous_is_taken_over_only_where_nothing_changed() -> None:
    options = ill.PrepareOptions(level=LEVEL)
    first = ill.prepare([torus().mesh()], options)
    again = ill.prepare([torus().mesh()], options, previous=first)
    assert again.timings["surface"] == again.timings["field"] == 0
    assert digest(draw(again, look_at())) == digest(draw(first, look_at()))
    bent = torus()
    bent.positions[0] += (0.1, 0, 0)
    other = ill.prepare([bent.mesh()], options, previous=first)
    assert other.timings["surface"] > 0
    lines = ill.DrawOptions(hatching=False)  # the field may start from the last one
    fresh = draw(prepared_of(bent), look_at(), lines)
    assert digest(draw(other, look_at(), lines)) == digest(fresh)
    kept = torus().mesh(cage=False)
    assert ill.prepare([kept], options, previous=first).timings["surface"] > 0
    turned = ill.PrepareOptions(level=LEVEL, parabolic_ratio=0)
    unreliable = ill.prepare([torus().mesh()], turned, previous=first)
    assert unreliable.timings["surface"] == 0
    assert not unreliable.field.reliable.any()


def test_what_moves_as_a_rigid_body_is_not_made_again() -> None:
    options = ill.PrepareOptions(level=LEVEL)
    first = ill.prepare([sphere().mesh(name="ball"), torus().mesh(name="ring")], options)
    shift = np.array((0.1, 0, 0))
    meshes = [torus().moved(tuple(shift)).mesh(name="ring"), sphere().mesh(name="ball")]
    second, alone = ill.prepare(meshes, options, previous=first), ill.prepare(meshes, options)
    ring, was = second.surface.objects == 0, first.surface.objects == 1
    positions = first.surface.positions[was] + shift
    np.testing.assert_allclose(second.surface.positions[ring], positions, atol=1e-15)
    turned = first.field.directions[was]
    np.testing.assert_allclose(second.field.directions[ring], turned, atol=1e-12)
    np.testing.assert_array_equal(second.field.directions[~ring], first.field.directions[~was])
    assert second.report == alone.report
    lines = ill.DrawOptions(hatching=False)
    ours, theirs = draw(second, look_at(), lines), draw(alone, look_at(), lines)
    np.testing.assert_array_equal(ours.kinds, theirs.kinds)
    np.testing.assert_array_equal(ours.offsets, theirs.offsets)
    np.testing.assert_allclose(ours.image, theirs.image, atol=1e-6)


def test_arrays_outlive_what_they_came_from() -> None:
    points = draw(prepared_of(cube()), look_at()).points
    positions = prepared_of(cube()).surface.positions
    assert np.isfinite(points).all()
    assert np.abs(positions).max() <= 1


def test_styles_choose_what_is_drawn() -> None:
    near, far = sphere(), sphere().moved((-2.0, 1.8, -0.4))
    found = prepared_of(near, far)

    def drawn(*styles: ill.ObjectStyle, hatching: bool = True) -> ill.Drawing:
        options = ill.DrawOptions(styles=styles, hatching=hatching)
        return draw(found, look_at(radius=4), options)

    plain, ignored = ill.ObjectStyle(), ill.ObjectStyle(ignore=True)
    assert set(drawn(plain, plain).objects) == {0, 1}
    without = drawn(ignored, plain)
    assert set(without.objects) == {1}
    lines = drawn(ignored, plain, hatching=False)
    alone = draw(prepared_of(far), look_at(radius=4), ill.DrawOptions(hatching=False))
    np.testing.assert_array_equal(lines.image, alone.image)
    on_second = found.surface.objects[found.surface.triangles[without.triangles, 0]]
    assert set(on_second) == {1}
    hiding = drawn(ill.ObjectStyle(occlude_only=True), plain)
    assert set(hiding.objects) == {1}
    assert not hiding.closed[hiding.kinds == ill.Kind.SILHOUETTE].any()
    unlined = drawn(ill.ObjectStyle(lines=False), plain)
    assert set(unlined.kinds[unlined.objects == 0]) <= {4, 5, 6}
    unhatched = drawn(ill.ObjectStyle(hatching=False), plain)
    assert set(unhatched.kinds[unhatched.objects == 0]) == {0}
    wide = drawn(ill.ObjectStyle(width_scale=3), plain, hatching=False)
    assert wide.widths.max() == pytest.approx(3 * ill.DrawOptions().line_width_px)


def test_without_hatching_there_is_no_tone() -> None:
    drawing = draw(prepared_of(sphere()), look_at(), ill.DrawOptions(hatching=False))
    assert set(drawing.kinds) == {int(ill.Kind.SILHOUETTE)}
    assert drawing.tone.level.shape == (0, 0)


def test_hidden_lines_add_to_the_visible_ones(prepared: ill.Prepared) -> None:
    options = ill.DrawOptions(hatching=False)
    visible = draw(prepared, look_at(), options)
    options.hidden_lines = (1, 9)
    every = draw(prepared, look_at(), options)
    assert (visible.invisibility == 0).all()
    assert (every.invisibility > 0).any()
    shown = np.repeat(every.invisibility == 0, np.diff(every.offsets))
    assert len(visible.points) <= shown.sum() + 8 * len(visible.kinds)
    assert every.invisibility.max() <= 9


def test_marked_edges_and_materials_are_drawn_when_asked_for() -> None:
    mesh = cube().mesh(scheme="none", marked_edges=[[0, 1]], face_materials=[0, 1, 1, 1, 1, 1])
    found = ill.prepare([mesh])
    plain = draw(found, look_at((-1, -2, 0.8)), ill.DrawOptions(hatching=False))
    assert not set(plain.kinds) & {int(ill.Kind.MARK), int(ill.Kind.MATERIAL)}
    options = ill.DrawOptions(hatching=False, marks=True, materials=True)
    asked = draw(found, look_at((-1, -2, 0.8)), options)
    assert {int(ill.Kind.MARK), int(ill.Kind.MATERIAL)} & set(asked.kinds.tolist())


def test_loose_edges_are_drawn_when_asked_for() -> None:
    string = ill.PolygonMesh([[-3, 0, 0], [3, 0, 0]], [], [], loose_edges=[[0, 1]])
    found = ill.prepare([cube().mesh(scheme="none"), string])
    camera = look_at((-1, -2, 0.8), radius=4)
    assert int(ill.Kind.LOOSE) not in draw(found, camera, ill.DrawOptions(hatching=False)).kinds
    asked = draw(found, camera, ill.DrawOptions(hatching=False, loose_edges=True))
    loose = np.flatnonzero(asked.kinds == int(ill.Kind.LOOSE))
    assert len(loose) == 2, "one on either side of the cube"
    for stroke in loose:
        assert asked.objects[stroke] == 1
        assert (asked.triangles[asked.offsets[stroke] : asked.offsets[stroke + 1]] == -1).all()
    styles = [ill.ObjectStyle(), ill.ObjectStyle(loose_edges=True)]
    styled = draw(found, camera, ill.DrawOptions(hatching=False, styles=styles))
    np.testing.assert_array_equal(styled.image, asked.image)


def test_lines_of_curvature_are_drawn_when_asked_for(prepared: ill.Prepared) -> None:
    kinds = {int(ill.Kind.SUGGESTIVE), int(ill.Kind.RIDGE), int(ill.Kind.VALLEY)}
    found = ill.prepare([drape().mesh()])
    thresholds = {"suggestive_threshold": 1.0, "ridge_threshold": 1.0, "valley_threshold": 1.0}
    options = ill.DrawOptions(hatching=False, **thresholds)
    plain = draw(found, look_at(radius=2), options)
    assert not set(plain.kinds.tolist()) & kinds
    np.testing.assert_array_equal(
        plain.image, draw(found, look_at(radius=2), ill.DrawOptions(hatching=False)).image
    )
    options.suggestive_contours = options.ridges = options.valleys = True
    asked = draw(found, look_at(radius=2), options)
    assert set(asked.kinds.tolist()) & kinds
    assert set(asked.graph.arc_kind.tolist()) >= set(asked.kinds.tolist())
    round_one = ill.DrawOptions(hatching=False, suggestive_contours=True, ridges=True, valleys=True)
    assert set(draw(prepared, look_at(), round_one).kinds) <= {0, *kinds}


def test_lines_of_light_are_drawn_when_asked_for() -> None:
    ground = Shape(
        np.array([[-4, -4, -1.5], [4, -4, -1.5], [4, 4, -1.5], [-4, 4, -1.5]], float),
        np.array([4], np.int32),
        np.arange(4, dtype=np.int32),
    )
    scene = ill.prepare([sphere().mesh(), ground.mesh(crease_angle_deg=30)])
    camera = look_at((0, -1, 1), radius=3)
    options = ill.DrawOptions(hatching=False, terminators=True, shadow_outlines=True)
    kinds = {int(ill.Kind.TERMINATOR), int(ill.Kind.SHADOW_OUTLINE)}
    for contours in (True, False):
        sun = ill.Light("sun", (1, -0.5, 2), contours=contours)
        assert sun.contours == contours
        drawn = set(draw(scene, camera, options, [sun]).kinds.tolist()) & kinds
        assert drawn == (kinds if contours else set())


@pytest.mark.parametrize("perspective", [True, False])
def test_silhouettes_are_those_of_brute_force(perspective: bool) -> None:
    for shape in (sphere(), torus(), klein_bottle(), drape()):
        found = prepared_of(shape, field=False)
        camera = look_at((0.3, 1, 2.5), perspective=perspective)
        fast, brute = (
            ill.silhouettes(found, camera, brute_force=b).triangles for b in (False, True)
        )
        np.testing.assert_array_equal(fast, brute)
        assert len(fast) > 0


def test_searched_and_scanned_silhouettes_give_the_same_drawing() -> None:
    meshes = [torus().mesh(), cube().mesh(scheme="none"), drape().moved((0, 0, 1)).mesh()]
    found = ill.prepare(meshes, ill.PrepareOptions(level=LEVEL, field=False))
    for ignored in (None, 0, 1):
        styles = [ill.ObjectStyle(ignore=i == ignored) for i in range(len(meshes))]
        searched, scanned = (
            draw(
                found,
                look_at(),
                ill.DrawOptions(hatching=False, scan_silhouettes=scan, styles=styles),
            )
            for scan in (False, True)
        )
        assert digest(searched) == digest(scanned)
        visited = [d.counts["triangles_visited"] for d in (searched, scanned)]
        assert 0 < visited[0] < 0.5 * visited[1]
        assert searched.counts["edges_visited"] <= scanned.counts["edges_visited"]


def test_field_can_be_solved_alone(prepared: ill.Prepared) -> None:
    again = ill.solve_cross_field(prepared, ill.PrepareOptions(level=LEVEL))
    np.testing.assert_array_equal(again.directions, prepared.field.directions)
    free = ill.solve_cross_field(prepared, ill.PrepareOptions(parabolic_ratio=0))
    assert not free.reliable.any()
    assert free.energy < free.energy_initial


def test_polygons_show_hatching_curvature_as_theirs() -> None:
    surface = ill.prepare([torus(96, 48).mesh()], ill.PrepareOptions(scheme="none")).surface
    np.testing.assert_array_equal(surface.k1, surface.hatch_k1)
    assert (np.abs(surface.k1) >= np.abs(surface.k2)).all()
    assert np.median(np.abs(surface.k1)) == pytest.approx(1 / 0.4, rel=0.02)


def test_objects_that_cross_too_much_are_named_and_sampled() -> None:
    ball = sphere()
    meshes = [ball.mesh(), ball.moved((9, 0, 0)).mesh(), ball.moved((0.5, 0.1, 0)).mesh()]
    prepared = ill.prepare(meshes, ill.PrepareOptions(field=False, most_intersections=3))
    assert prepared.left_out_intersections == [(0, 2)]
    without = [ill.ObjectStyle(), ill.ObjectStyle(), ill.ObjectStyle(ignore=True)]
    for styles, sampled in ((None, 1), (without, 0)):
        drawn = ill.draw(prepared, look_at(), ill.DrawOptions(hatching=False, styles=styles))
        assert drawn.counts["sampled_views"] == sampled
    with pytest.raises(ValueError, match="most_intersections"):
        ill.prepare(meshes, ill.PrepareOptions(most_intersections=-1))
