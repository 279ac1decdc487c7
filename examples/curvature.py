"""Draws the curvature of smooth surfaces as pictures.

    .venv/bin/python examples/curvature.py [--out DIR] [--toward-camera X Y Z] SURFACE ...

SURFACE: an .obj or .ply file whose y axis is up, or the name of a formula. Each leaves six .png in
DIR (out), `curvature-NAME-CURVATURE-MAP.png`:

    line-...       the curvature for silhouettes and cusps
    hatch-...      the curvature for hatching
    ...mean        red where the surface bulges, blue where it is hollow; only how much, in red,
                   on a surface with one side
    ...gaussian    red where it is a dome or a bowl, blue where it is a saddle
    ...directions  the first principal direction; red and blue as for the mean

A colour is full from the 95th percentile of what is seen of the curvature for lines; that value is
printed, for an object whose bounding box has the diagonal 1.
"""

import argparse
import pathlib
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import formulas
import illustrate_native as ill
import numpy as np
from mesh_files import read_mesh
from raster import SIZE_PX, View, rasterise, write_png

FORMULAS: dict[str, Callable[[], tuple[Any, Any]]] = {
    "klein": formulas.klein_bottle,
    "torus": lambda: formulas.torus(1.0, 0.36),
    "sphere": lambda: formulas.sphere(1.0),
    "drape": formulas.drape,
}
FULL_COLOUR_PERCENTILE, LEAST_FULL_COLOUR = 95, 1e-6  # the latter: a plane stays pale
LIGHT_IN_VIEW = np.array([-0.45, 0.5, 0.74])  # unit; right, up, towards the viewer
PLACES = (-1.0, -0.5, 0.0, 0.5, 1.0)
COLOURS = np.array(
    [(25, 55, 150), (120, 165, 220), (246, 246, 242), (238, 150, 115), (165, 15, 30)]
)
STROKE_STEP_PX, STROKE_LENGTH_PX = 12, 9


@dataclass(frozen=True)
class Pixels:
    """What is seen of a surface, for m pixels.

    rows, columns: (m,). corners: (m, 3) vertices of the nearest triangle, weights: (m, 3) of them.
    signs: (m, 3) -1 where a vertex's normal belongs to the other sheet of a one-sided surface.
    """

    rows: Any
    columns: Any
    corners: Any
    weights: Any
    signs: Any

    def mix(self, values: Any, signed: bool = False) -> Any:
        """Values (n, ...) of the vertices, interpolated; signed: of the triangle's own sheet."""
        weights = self.weights * self.signs if signed else self.weights
        return np.einsum("mk,mk...->m...", weights, values[self.corners])


def see(surface: Any, view: View, one_sided: bool) -> Pixels:
    """What a view shows of a surface."""
    nearest, weights = rasterise(view.project(surface.positions), surface.triangles)
    rows, columns = np.nonzero(nearest >= 0)
    corners = surface.triangles[nearest[rows, columns]]
    signs = np.ones(corners.shape)
    if one_sided:
        a, b, c = (surface.positions[corners[:, k]] for k in range(3))
        facing = np.einsum("mkx,mx->mk", surface.normals[corners], np.cross(b - a, c - a))
        signs[facing < 0] = -1.0
    return Pixels(rows, columns, corners, weights[rows, columns], signs)


def shade(normals: Any, view: View) -> Any:
    """(m, 1) a light factor for normals (m, 3) of either side."""
    in_view = normals @ view.axes.T
    in_view /= np.linalg.norm(in_view, axis=1, keepdims=True).clip(1e-300)
    in_view *= np.where(in_view[:, 2:] < 0, -1.0, 1.0)
    return 0.6 + 0.4 * (in_view @ LIGHT_IN_VIEW).clip(0)[:, None]


def colour(values: Any) -> Any:
    """(m, 3) of values (m,), full at -1 and 1."""
    return np.stack([np.interp(values, PLACES, channel) for channel in COLOURS.T], axis=1)


def paint_strokes(image: Any, pixels: Pixels, view: View, bulge: Any, w1: Any) -> None:
    """Short strokes along w1 (n, 3) on a grid of the pixels, coloured by the sign of bulge (m,)."""
    seeds = (pixels.rows % STROKE_STEP_PX == 0) & (pixels.columns % STROKE_STEP_PX == 0)
    at = np.stack([pixels.rows, pixels.columns], axis=1)[seeds]
    main = pixels.weights[seeds].argmax(axis=1)[:, None]
    vertex = np.take_along_axis(pixels.corners[seeds], main, axis=1)[:, 0]
    across, up = (w1[vertex] @ view.axes[:2].T).T
    for t in np.linspace(-0.5, 0.5, 2 * STROKE_LENGTH_PX) * STROKE_LENGTH_PX:
        spot = np.rint(at + t * np.stack([-up, across], axis=1)).astype(int)
        image[spot[:, 0], spot[:, 1]] = colour(np.where(bulge[seeds] < 0, -1.0, 1.0))


def load(surface: str) -> ill.PolygonMesh:
    """The mesh of a formula, or of a file; y up. Raises OSError and ValueError for bad files."""
    if surface in FORMULAS:
        positions, faces = FORMULAS[surface]()
        positions = positions @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
        return ill.PolygonMesh(positions, [4] * len(faces), faces.ravel(), name=surface)
    path = pathlib.Path(surface)
    if not path.suffix:
        raise ValueError(f"there is no such formula, only {', '.join(FORMULAS)}")
    positions, faces = read_mesh(path)
    corners = [corner for face in faces for corner in face]
    return ill.PolygonMesh(positions, [len(face) for face in faces], corners, name=path.stem)


def maps_of(surface: Any, prefix: str, pixels: Pixels, one_sided: bool) -> dict[str, Any]:
    """Mean and Gaussian curvature and the bulge along w1, each (m,), at pixels.

    prefix: of the attributes of `surface`, '' or 'hatch_'.
    """
    k1, k2 = (getattr(surface, prefix + name) for name in ("k1", "k2"))
    mean, along = (-pixels.mix(k, signed=True) for k in ((k1 + k2) / 2, k1))
    if one_sided:
        mean, along = abs(mean), abs(along)
    return {"mean": mean, "gaussian": pixels.mix(k1 * k2), "directions": along}


def draw(mesh: ill.PolygonMesh, toward_camera: list[float], out: pathlib.Path) -> str:
    """Writes the pictures of one surface; a line that sums them up. Raises OSError, ValueError."""
    prepared = ill.prepare([mesh], ill.PrepareOptions(field=False))
    surface, one_sided = prepared.surface, prepared.report["covered_parts"] > 0
    if not len(surface.triangles):
        raise ValueError("it has no faces that can be drawn")
    view = View.of(surface.positions, toward_camera)
    pixels = see(surface, view, one_sided)
    light = shade(pixels.mix(surface.normals, signed=True), view)
    diagonal = np.linalg.norm(np.ptp(surface.positions, axis=0))
    unit = {"mean": diagonal, "gaussian": diagonal**2}  # makes curvature that of diagonal 1
    full: dict[str, float] = {}
    for curvature, prefix in (("line", ""), ("hatch", "hatch_")):
        for name, values in maps_of(surface, prefix, pixels, one_sided).items():
            image = np.full((SIZE_PX, SIZE_PX, 3), 255.0)
            if name in unit:
                values = values * unit[name]
                usual = np.percentile(abs(values), FULL_COLOUR_PERCENTILE)
                full.setdefault(name, max(usual, LEAST_FULL_COLOUR))
                image[pixels.rows, pixels.columns] = light * colour(values / full[name])
            else:
                image[pixels.rows, pixels.columns] = 255 * light
                paint_strokes(image, pixels, view, values, getattr(surface, prefix + "w1"))
            write_png(out / f"curvature-{mesh.name}-{curvature}-{name}.png", image)
    return f"{mesh.name}: full colour at mean {full['mean']:.3g}, Gaussian {full['gaussian']:.3g}"


def main() -> int:
    """Draws what the command line names; the exit code."""
    parser = argparse.ArgumentParser(prog="curvature.py", description="Curvature as pictures.")
    parser.add_argument("--out", default="out", type=pathlib.Path, metavar="DIR")
    parser.add_argument(
        "--toward-camera", nargs=3, type=float, default=[0.5, 0.3, 1.0], metavar=("X", "Y", "Z")
    )
    parser.add_argument(
        "surfaces", nargs="+", metavar="SURFACE", help=f"a file, or of {', '.join(FORMULAS)}"
    )
    chosen = parser.parse_args()
    if not np.hypot(chosen.toward_camera[0], chosen.toward_camera[2]) > 0:
        parser.error("--toward-camera must not be vertical")
    for surface in chosen.surfaces:
        try:
            chosen.out.mkdir(parents=True, exist_ok=True)
            print(draw(load(surface), chosen.toward_camera, chosen.out))
        except (OSError, ValueError) as error:
            print(f"curvature.py: error: {surface}: {error}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
