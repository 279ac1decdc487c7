"""The views that the pictures of docs/ are made of: meshes from formulas, and a camera."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from typing import Any

import illustrate_native as ill
import numpy as np
from paths import ROOT

__all__ = ["ROOT", "View", "formulas", "look_at", "mesh", "ring_and_ball"]


sys.path.insert(0, str(ROOT / "examples"))

import formulas

SIZE_PX = (400, 280)


def look_at(
    toward_camera: tuple[float, float, float],
    radius: float,
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0),
    size_px: tuple[int, int] = SIZE_PX,
) -> ill.Camera:
    """A parallel camera, z up, whose picture is two radii wide."""
    back = np.array(toward_camera) / np.linalg.norm(toward_camera)
    right = np.cross([0.0, 0.0, 1.0], back)
    right /= np.linalg.norm(right)
    view, projection = np.eye(4), np.eye(4)
    view[:3, :3] = right, np.cross(back, right), back
    view[:3, 3] = -view[:3, :3] @ (np.array(centre) + 3 * radius * back)
    projection[0, 0], projection[1, 1] = 1 / radius, size_px[0] / size_px[1] / radius
    projection[2, 2:] = -1 / (2 * radius), -2
    return ill.Camera(projection, view, *size_px)


@dataclass
class View:
    """What is drawn: meshes, a camera, options, lights."""

    meshes: list[ill.PolygonMesh]
    camera: ill.Camera
    prepare: dict[str, Any] = field(default_factory=dict)
    draw: dict[str, Any] = field(default_factory=dict)
    lights: list[ill.Light] = field(default_factory=lambda: [ill.Light("side")])

    def drawn(self) -> tuple[ill.Prepared, ill.Drawing]:
        """The scene and its drawing."""
        prepared = ill.prepare(self.meshes, ill.PrepareOptions(**self.prepare))
        return prepared, ill.draw(
            prepared, self.camera, ill.DrawOptions(**self.draw), lights=self.lights
        )


def mesh(positions: Any, faces: Any, **more: Any) -> ill.PolygonMesh:
    """A mesh of faces (f, corners)."""
    return ill.PolygonMesh(positions, np.full(len(faces), faces.shape[1]), np.ravel(faces), **more)


def ring_and_ball(size_px: tuple[int, int] = SIZE_PX, **draw: Any) -> View:
    """A ball that pierces a ring: every kind of node, layers one behind the other."""
    positions, faces = formulas.torus(1.0, 0.42, 24, 12)
    ball, quads = formulas.sphere(0.5, 6)
    meshes = [
        mesh(positions, faces, name="ring"),
        mesh(ball + np.array((0.9, -0.5, 0.35)), quads, name="ball"),
    ]
    return View(
        meshes, look_at((1, -2.2, 1.2), 1.75, size_px=size_px), prepare={"level": 1}, draw=draw
    )
