"""What a 3D viewport looks at, as the camera of a drawing, and where that drawing lies in it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..reading.scene import CameraArrays, camera_problem, frame_corners, read_camera


@dataclass(frozen=True)
class View:
    """A viewport's view. Pixels of its drawing lie at `scale` * pixel + `origin` in the region."""

    camera: CameraArrays
    scale: Any  # (2,) y turned: region rows go upwards
    origin: Any  # (2,)

    @property
    def key(self) -> bytes:
        """Tells views apart that are drawn differently."""
        camera = self.camera
        size = np.array([camera.width_px, camera.height_px], float)
        return b"".join(
            np.ascontiguousarray(part, float).tobytes()
            for part in (camera.projection, camera.view, size)
        )

    def to_region(self, pixels: Any) -> Any:
        """(n, 2) places in the region of places in the drawing."""
        return np.asarray(pixels) * self.scale + self.origin

    @property
    def zoom(self) -> float:
        """Pixels of the region for one of the drawing."""
        return float(abs(self.scale[0]))


FOREMOST = -1.0  # depth of the near plane
AHEAD = 0.02  # of the distance to the eye: surfaces of the viewport are not quite those drawn


def depths_of(points: Any, projection: Any, view: Any) -> Any:
    """(n,) depths -1 .. 1 of points (n, 3) in the world, AHEAD of where they are.

    projection, view: (4, 4) clip from view from world. In parallel views AHEAD is a share of half
    the width.
    """
    projection = np.array(projection, float)
    seen = np.c_[np.asarray(points, float), np.ones(len(points))] @ np.array(view, float).T
    if projection[3, 3] == 0:
        seen[:, :3] *= 1 - AHEAD
    else:
        seen[:, 2] += AHEAD / abs(projection[0, 0])
    depths = (seen @ projection[2]) / (seen @ projection[3])
    return np.clip(depths, FOREMOST, 1.0)


def view_of(scene: Any, depsgraph: Any, region: Any, region_data: Any) -> View | None:
    """The view of a region: the scene's camera at its own size where the region looks through it.

    None for a region without an area and for views that no matrix describes.
    """
    if min(region.width, region.height) < 2:
        return None
    if region_data.view_perspective == "CAMERA":
        if camera_problem(scene):
            return None
        return _through_camera(scene, depsgraph, region, region_data)
    projection = np.array(region_data.window_matrix, float)
    if not abs(np.linalg.det(projection)) > 0:
        return None
    size = region.width, region.height
    camera = CameraArrays(projection, np.array(region_data.view_matrix, float), *size)
    return View(camera, np.array([1.0, -1.0]), np.array([0.0, float(region.height)]))


def _through_camera(scene: Any, depsgraph: Any, region: Any, region_data: Any) -> View | None:
    camera = read_camera(scene, depsgraph)
    corners = (
        np.c_[frame_corners(scene), np.ones(3)] @ np.array(region_data.perspective_matrix, float).T
    )
    if not (corners[:, 3] > 0).all():
        return None
    half = np.array([region.width, region.height]) / 2
    top_left, top_right, bottom_left = (corners[:, :2] / corners[:, 3:] + 1) * half
    across, down = top_right[0] - top_left[0], bottom_left[1] - top_left[1]
    return View(camera, np.array([across / camera.width_px, down / camera.height_px]), top_left)
