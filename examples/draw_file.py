"""Draws a mesh file as SVG, with the module alone: python draw_file.py MESH.obj DRAWING.svg."""

import pathlib
import sys

import illustrate_native as ill
import numpy as np
from illustrate_native import svg
from mesh_files import read_mesh

positions, faces = read_mesh(pathlib.Path(sys.argv[1]))
prepared = ill.prepare([ill.PolygonMesh(positions, list(map(len, faces)), np.concatenate(faces))])
middle = (np.max(positions, axis=0) + np.min(positions, axis=0)) / 2
radius = np.linalg.norm(positions - middle, axis=1).max() * 1.05
turn = np.array([[0.8, 0.0, -0.6], [-0.36, 0.8, -0.48], [0.48, 0.6, 0.64]])  # right, up, to the eye
view, projection = np.eye(4), np.diag([1 / radius, 1 / radius, -1 / radius, 1.0])
view[:3, :3], view[:3, 3] = turn, -turn @ middle
drawing = ill.draw(prepared, ill.Camera(projection, view, 1000, 1000))
pathlib.Path(sys.argv[2]).write_text(svg.to_svg(drawing, 1000, 1000), encoding="utf-8")
