"""Properties that hold for any mesh, over files that are kept outside the checkout."""

from __future__ import annotations

import os
from itertools import pairwise
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_offsets, check_strokes, digest, draw
from numpy.typing import NDArray
from shapes import Shape, look_at

SHARED = Path(os.environ.get("ILLUSTRATE_SHARED", Path(__file__).parents[4] / "shared"))
MESHES = SHARED / "meshes"

# Few and small enough for every run; of each kind of trouble at least one.
FILES = [
    "smooth/spot_cage.obj", "smooth/blub_cage.obj", "smooth/cat_head.obj",
    "smooth/gen_klein_bottle.obj", "smooth/gen_drape.obj", "smooth/quadknot.obj",
    "smooth/rabbit_parts.obj", "smooth/hand_1602_open.obj", "smooth/spot_loop_1654.obj",
]  # fmt: skip
LARGEST_BYTES = 400_000
CREASE_ANGLE_DEG = 60


def small_files(folder: str) -> list[str]:
    """Those of a folder that can be read quickly."""
    files = sorted(MESHES.glob(f"{folder}/**/*.obj"))
    return [str(f.relative_to(MESHES)) for f in files if f.stat().st_size <= LARGEST_BYTES]


def read_obj(path: Path) -> Shape:
    """Vertices and faces as they stand in the file, defects included."""
    positions: list[list[float]] = []
    faces: list[list[int]] = []
    for line in path.read_text(errors="replace").splitlines():
        words = line.split("#")[0].split()
        try:
            if words[:1] == ["v"]:
                positions.append([np.nan] * 3)
                positions[-1] = [float(word) for word in words[1:4]]
            elif words[:1] == ["f"]:
                numbers = [int(word.split("/")[0]) for word in words[1:]]
                faces.append([n - 1 if n >= 0 else len(positions) + n for n in numbers])
        except ValueError:
            continue
    points = np.array([p if len(p) == 3 else [np.nan] * 3 for p in positions]).reshape(-1, 3)
    known = [face for face in faces if all(0 <= v < len(points) for v in face)]
    corners = [v for face in known for v in face]
    return Shape(points, np.array([len(face) for face in known], np.int32),
                 np.array(corners, np.int32))  # fmt: skip


def read_tags(path: Path) -> dict[str, Any]:
    """What the `t` lines of OpenSubdiv's own shapes say: creases, corners, holes, the boundary."""
    edges: list[list[int]] = []
    edge_sharpness: list[float] = []
    corners: dict[int, float] = {}
    more: dict[str, Any] = {}
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] != ["t"]:
            continue
        whole, real = (int(count) for count in words[2].split("/")[:2])
        numbers = [int(word) for word in words[3 : 3 + whole]]
        values = [float(word) for word in words[3 + whole : 3 + whole + real]]
        if words[1] == "crease":
            chain = [list(pair) for pair in pairwise(numbers)]
            edges += chain
            edge_sharpness += (values * len(chain))[: len(chain)]
        elif words[1] == "corner":
            corners |= dict(zip(numbers, values * len(numbers), strict=False))
        elif words[1] == "hole":
            more["hole_faces"] = numbers
        elif words[1] == "interpolateboundary":
            more["boundary"] = "corners" if numbers[0] == 1 else "edges"
    if edges:
        more |= {"edge_vertices": edges, "edge_sharpness": edge_sharpness}
    sharpness = np.zeros(len(read_obj(path).positions))
    sharpness[list(corners)] = list(corners.values())
    return more | {"vertex_sharpness": sharpness}


def cameras(shape: Shape) -> list[ill.Camera]:
    finite = shape.positions[np.isfinite(shape.positions).all(1)]
    low, high = (finite.min(0), finite.max(0)) if len(finite) else (np.zeros(3), np.ones(3))
    centre, radius = (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 1e-6)
    return [
        look_at((1, -2, 0.8), radius, tuple(centre)),
        look_at((-1.5, -0.4, -1), radius, tuple(centre), perspective=False),
    ]


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", FILES)
def test_graph_rules_hold_and_two_runs_agree(name: str) -> None:
    shape = read_obj(MESHES / name)
    options = ill.PrepareOptions(triangle_budget=40_000)
    prepared = ill.prepare([shape.mesh()], options)
    for camera in cameras(shape):
        drawing = draw(prepared, camera)
        assert len(drawing.kinds) > 0
    once_more = draw(ill.prepare([shape.mesh()], options), camera)
    assert digest(once_more) == digest(drawing)


# Sheets with boundaries, and solids and a Klein bottle that pass through themselves.
HARD_FILES = [
    "smooth/cat_head.obj", "smooth/hand_1602_open.obj", "smooth/gen_drape.obj",
    "smooth/gen_klein_bottle.obj", "smooth/rabbit_parts.obj",
]  # fmt: skip


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", HARD_FILES)
def test_hardly_a_label_needs_repair(name: str) -> None:
    shape = read_obj(MESHES / name)
    prepared = ill.prepare([shape.mesh()], ill.PrepareOptions(field=False))
    drawings = [
        ill.draw(prepared, camera, ill.DrawOptions(hatching=False)) for camera in cameras(shape)
    ]
    repairs = sum(drawing.counts["repairs"] for drawing in drawings)
    assert repairs <= 0.01 * sum(len(drawing.graph.node_kind) for drawing in drawings)


def coarse(name: str) -> tuple[Shape, ill.Prepared]:
    """A part of a machine or a broken mesh, with its sharp edges told by their angle."""
    shape = read_obj(MESHES / name)
    mesh = shape.mesh(crease_angle_deg=CREASE_ANGLE_DEG)
    return shape, ill.prepare([mesh], ill.PrepareOptions(triangle_budget=10_000))


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", small_files("cad"))
def test_graph_rules_hold_on_parts_of_machines(name: str) -> None:
    shape, prepared = coarse(name)
    for camera in cameras(shape):
        draw(prepared, camera)


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", small_files("bad"))
def test_broken_meshes_give_sound_strokes(name: str) -> None:
    shape, prepared = coarse(name)
    for camera in cameras(shape):
        drawing = ill.draw(prepared, camera)
        check_strokes(drawing, camera)
        check_offsets(drawing.graph)


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", small_files("cad/opensubdiv"))
def test_vertices_lie_on_the_limit_surface_of_opensubdiv(name: str) -> None:
    path = MESHES / name
    mesh = read_obj(path).mesh(**read_tags(path))
    scheme = "loop" if path.name.startswith("loop") else "catmull-clark"
    for level in range(3):
        options = ill.PrepareOptions(scheme=scheme, level=level, field=False)
        surface = ill.prepare([mesh], options).surface
        limit = surface.evaluate(surface.base_faces, surface.base_uv)[0]
        diagonal = np.linalg.norm(np.ptp(surface.positions, axis=0))
        assert np.abs(limit - surface.positions).max() < 1e-6 * diagonal


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", FILES)
def test_second_derivatives_are_those_of_the_first(name: str) -> None:
    options = ill.PrepareOptions(level=0, field=False)
    surface = ill.prepare([read_obj(MESHES / name).mesh()], options).surface
    random = np.random.default_rng(3)
    faces = random.integers(0, surface.base_faces.max() + 1, 2000).astype(np.int32)
    inside = random.dirichlet((1, 1, 1), 8000)  # of triangles, and so of quads
    uv = inside[inside.min(1) > 0.02][:2000, :2]
    step = 5e-6  # small: third derivatives jump inside of irregular faces

    def slopes(axis: int) -> list[NDArray[np.float64]]:
        shift = step * np.eye(2)[axis]
        low, high = surface.evaluate(faces, uv - shift), surface.evaluate(faces, uv + shift)
        return [(b - a) / (2 * step) for a, b in zip(low, high, strict=True)]

    _, du, dv, duu, duv, dvv = surface.evaluate(faces, uv)
    (_, du_u, dv_u, *_), (_, _, dv_v, *_) = slopes(0), slopes(1)
    error = np.concatenate([du_u - duu, dv_u - duv, dv_v - dvv], axis=1)
    size = np.concatenate([duu, duv, dvv, 1e-3 * du, 1e-3 * dv], axis=1)
    assert (np.linalg.norm(error, axis=1) < 1e-5 * np.linalg.norm(size, axis=1)).all()
