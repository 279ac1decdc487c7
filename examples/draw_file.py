"""Draws a mesh file as SVG, with the module alone: draw_file.py MESH DRAWING.svg [--cage].

MESH: .obj, .ply or .stl. A file with normals is drawn as it is shaded: sharp where its normals
differ, its vertices on the surface; so is one of triangles, sharp where they meet at more than 30
degrees. Of others without normals, or with --cage, the vertices are a cage, which the surface goes
near.
"""

import pathlib
import sys

import illustrate_native as ill
import numpy as np
from illustrate_native import svg
from mesh_files import read_corner_normals, read_mesh

SIZE_PX = 1000

if len(sys.argv) < 3:
    sys.exit("draw_file.py MESH DRAWING.svg [--cage]")
path = pathlib.Path(sys.argv[1])
try:
    positions, faces = read_mesh(path)
    normals = None if "--cage" in sys.argv else read_corner_normals(path)
except (OSError, ValueError) as error:
    sys.exit(f"draw_file.py: {error}")
cage = "--cage" in sys.argv or (normals is None and any(len(face) > 3 for face in faces))
middle = (np.max(positions, axis=0) + np.min(positions, axis=0)) / 2
radius = np.linalg.norm(positions - middle, axis=1).max() * 1.05
mesh = ill.PolygonMesh(
    positions,
    list(map(len, faces)),
    np.concatenate(faces),
    corner_normals=normals,
    cage=cage,
    crease_angle_deg=180 if cage else 30,
    edge_length=3 * 2 * radius / SIZE_PX,  # finer roundings are lines
)
prepared = ill.prepare([mesh])
turn = np.array([[0.8, 0.0, -0.6], [-0.36, 0.8, -0.48], [0.48, 0.6, 0.64]])  # right, up, to the eye
view, projection = np.eye(4), np.diag([1 / radius, 1 / radius, -1 / radius, 1.0])
view[:3, :3], view[:3, 3] = turn, -turn @ middle
drawing = ill.draw(prepared, ill.Camera(projection, view, SIZE_PX, SIZE_PX))
pathlib.Path(sys.argv[2]).write_text(svg.to_svg(drawing, SIZE_PX, SIZE_PX), encoding="utf-8")
