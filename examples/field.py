"""Draws the cross field that hatches follow, as SVG.

    .venv/bin/python examples/field.py [--out DIR] [--toward-camera X Y Z]
        [OPTION=VALUE ...] SURFACE ...

SURFACE: an .obj or .ply file whose y axis is up, or the name of a formula. Each leaves
`field-NAME.svg` in DIR (out): crosses, black where curvature was kept, grey where the field was
free; a red disc where it turns by a quarter round a point, a blue one where it turns the other way.

OPTION: of `illustrate_native.PrepareOptions`, such as parabolic_ratio=0 (everything free, as in the
paper's figure 8 e), largest_energy=2 or field_start=principal.
"""

import argparse
import ast
import pathlib
import sys
from typing import Any

import formulas
import illustrate_native as ill
import numpy as np
from illustrate_native import field_svg
from mesh_files import read_mesh

SIZE_PX = 1000
FORMULAS: dict[str, Any] = {
    "klein": formulas.klein_bottle,
    "torus": lambda: formulas.torus(1.0, 0.36),
    "sphere": lambda: formulas.sphere(1.0),
    "cylinder": formulas.cylinder,
    "corner": formulas.smooth_corner,
    "drape": formulas.drape,
}


def load(surface: str) -> ill.PolygonMesh:
    """The mesh of a formula, or of a file; z up. Raises OSError and ValueError for bad files."""
    if surface in FORMULAS:
        positions, faces = FORMULAS[surface]()
        return ill.PolygonMesh(positions, [4] * len(faces), faces.ravel(), name=surface)
    path = pathlib.Path(surface)
    if not path.suffix:
        raise ValueError(f"there is no such formula, only {', '.join(FORMULAS)}")
    positions, listed = read_mesh(path)
    corners = [corner for face in listed for corner in face]
    upright = np.asarray(positions) @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    return ill.PolygonMesh(upright, [len(face) for face in listed], corners, name=path.stem)


def look(positions: Any, toward_camera: Any) -> ill.Camera:
    """An orthographic camera that sees all positions (n, 3)."""
    back = np.asarray(toward_camera, float) / np.linalg.norm(toward_camera)
    right = np.cross((0.0, 0.0, 1.0), back)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(back, right), back])
    low, high = (positions @ axes.T).min(axis=0), (positions @ axes.T).max(axis=0)
    half = 0.54 * (high - low)[:2].max()
    depth = 2 * max(high[2] - low[2], half)
    view = np.eye(4)
    view[:3, :3], view[:3, 3] = axes, -(low + high) / 2 - (0, 0, depth)
    projection = np.diag([1 / half, 1 / half, -1 / depth, 1.0])
    projection[2, 3] = -1.0
    return ill.Camera(projection, view, SIZE_PX, SIZE_PX)


def options(settings: list[str]) -> ill.PrepareOptions:
    """OPTION=VALUE as options; values that are no Python literals are words."""
    chosen: dict[str, Any] = {}
    for setting in settings:
        name, _, value = setting.partition("=")
        try:
            chosen[name] = ast.literal_eval(value)
        except (ValueError, SyntaxError):
            chosen[name] = value
    return ill.PrepareOptions(**chosen)


def main(arguments: list[str]) -> int:
    """Draws what the command line names; the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out"), metavar="DIR")
    parser.add_argument("--toward-camera", type=float, nargs=3, default=(0.8, -1.6, 0.9))
    parser.add_argument("surfaces", nargs="+", metavar="OPTION=VALUE or SURFACE")
    chosen = parser.parse_args(arguments)
    settings = options([word for word in chosen.surfaces if "=" in word])
    chosen.out.mkdir(parents=True, exist_ok=True)
    for name in (word for word in chosen.surfaces if "=" not in word):
        try:
            mesh = load(name)
        except (OSError, ValueError) as error:
            print(f"{name}: {error}", file=sys.stderr)
            return 1
        prepared = ill.prepare([mesh], settings)
        camera = look(prepared.surface.positions, chosen.toward_camera)
        path = chosen.out / f"field-{mesh.name}.svg"
        path.write_text(field_svg.field_to_svg(prepared.surface, prepared.field, camera))
        indices = prepared.field.singular_indices
        print(f"{path}: {(indices > 0).sum()} positive, {(indices < 0).sum()} negative")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
