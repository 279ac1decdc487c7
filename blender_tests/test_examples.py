"""The example scenes: sound meshes in good frames."""

from collections import Counter
from typing import Any

import bpy
import formulas
import numpy as np
import pytest
import scenes
from bpy_extras.object_utils import world_to_camera_view
from illustrate.reading.scene import read_scene
from mathutils import Vector


def edge_counts(faces: Any) -> tuple[Counter[Any], Counter[Any]]:
    """How often each edge occurs, without and with its direction."""
    directed = [(int(f[i]), int(f[(i + 1) % 4])) for f in faces for i in range(4)]
    return Counter(frozenset(e) for e in directed), Counter(directed)


@pytest.mark.parametrize(
    ("mesh", "euler"),
    [
        (formulas.sphere(1, 6), 2),
        (formulas.torus(1, 0.3, 12, 8), 0),
        (formulas.klein_bottle(24, 8), 0),
    ],
)
def test_closed_surfaces_are_closed(mesh: Any, euler: int) -> None:
    positions, faces = mesh
    edges, _ = edge_counts(faces)
    assert set(edges.values()) == {2}
    assert len(positions) - len(edges) + len(faces) == euler


def test_the_klein_bottle_has_one_side_and_the_others_two() -> None:
    for mesh, turned in ((formulas.sphere(1, 6), 1), (formulas.torus(1, 0.3, 12, 8), 1)):
        assert max(edge_counts(mesh[1])[1].values()) == turned
    assert max(edge_counts(formulas.klein_bottle(24, 8)[1])[1].values()) == 2


def test_the_drape_has_folds_over_folds() -> None:
    positions, faces = formulas.drape()
    edges, _ = edge_counts(faces)
    assert set(edges.values()) == {1, 2}
    hem = positions.reshape(-1, 261, 3)[-1]
    assert (np.diff(hem[:, 0]) < 0).sum() > 20


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_fills_its_picture(name: str) -> None:
    if not scenes.is_available(name):
        pytest.skip(f"{scenes.FILES[name]} is not in {scenes.SHARED}")
    scene = scenes.build(name)
    arrays = read_scene(scene, bpy.context.evaluated_depsgraph_get())
    points = np.concatenate([mesh.positions for mesh in arrays.meshes])
    points = points[:: max(1, len(points) // 2000)]
    seen = np.array([world_to_camera_view(scene, scene.camera, Vector(p)) for p in points])
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    assert (low > -0.05).all() and (high < 1.05).all()  # a cage may reach past its limit
    assert (high - low).max() > 0.8
    [sun] = arrays.lights
    toward_light = arrays.camera.view[:3, :3] @ sun.vector
    assert toward_light[0] < -0.3 and toward_light[1] > 0.3 and toward_light[2] > 0.3


def test_the_camera_of_the_turntable_goes_round_evenly() -> None:
    scene = scenes.build("turntable")
    turns = []
    for frame in (1, 2, 7, 13):
        scene.frame_set(frame)
        turns.append(scene.camera.parent.matrix_world.to_euler().z)
    assert turns == pytest.approx([0, np.pi / 72, np.pi / 12, np.pi / 6], abs=1e-6)
