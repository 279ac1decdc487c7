"""Properties that hold for any mesh, over files that are kept outside the checkout."""

from __future__ import annotations

import os
from pathlib import Path

import illustrate_native as ill
import numpy as np
import pytest
from checker import check_drawing, check_offsets, check_strokes, digest
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
        drawing = ill.draw(prepared, camera)
        check_drawing(drawing, camera)
        assert len(drawing.kinds) > 0
    once_more = ill.draw(ill.prepare([shape.mesh()], options), camera)
    assert digest(once_more) == digest(drawing)


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
        check_drawing(ill.draw(prepared, camera), camera)


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", small_files("bad"))
def test_broken_meshes_give_sound_strokes(name: str) -> None:
    shape, prepared = coarse(name)
    for camera in cameras(shape):
        drawing = ill.draw(prepared, camera)
        check_strokes(drawing, camera)
        check_offsets(drawing.graph)
