"""Reads OBJ and PLY files and writes OBJ, the same way with every Blender and without one."""

import pathlib
from collections.abc import Iterable
from typing import Any

import numpy as np

PLY_TYPES = {
    "char": "i1",
    "uchar": "u1",
    "short": "i2",
    "ushort": "u2",
    "int": "i4",
    "uint": "u4",
    "float": "f4",
    "double": "f8",
    "int8": "i1",
    "uint8": "u1",
    "int16": "i2",
    "uint16": "u2",
    "int32": "i4",
    "uint32": "u4",
    "float32": "f4",
    "float64": "f8",
}


def read_mesh(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    """Positions and faces, lists of vertex numbers, of an .obj or binary little-endian .ply file.

    Raises ValueError for other files.
    """
    readers = {".obj": _read_obj, ".ply": _read_ply}
    if path.suffix not in readers:
        raise ValueError(f"{path.name} is neither .obj nor .ply")
    return readers[path.suffix](path)


def read_corner_normals(path: pathlib.Path) -> list[Any] | None:
    """Normals of the corners of an .obj file's faces, in their order; None where it has none.

    A corner without one, in a file with others, has the normal zero: it is not known.
    """
    if path.suffix != ".obj":
        return None
    lines = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    normals = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["vn"]]
    corners = [corner.split("/") for words in lines if words[:1] == ["f"] for corner in words[1:]]
    if not any(len(parts) == 3 for parts in corners):
        return None
    return [normals[int(parts[2]) - 1] if len(parts) == 3 else [0, 0, 0] for parts in corners]


def write_obj(path: pathlib.Path, positions: Iterable[Any], faces: Iterable[Any]) -> None:
    """Writes positions and faces, lists of vertex numbers."""
    lines = [" ".join(["v", *map(str, position)]) for position in positions]
    lines += [" ".join(["f", *(str(corner + 1) for corner in face)]) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _read_obj(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    lines = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    positions = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]]
    faces = [
        [int(corner.split("/")[0]) - 1 for corner in words[1:]]
        for words in lines
        if words[:1] == ["f"]
    ]
    return positions, faces


def _read_ply(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    """Vertices of plain properties, then triangles as the one list of the faces."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in header.decode("ascii").splitlines()]
    if ["format", "binary_little_endian", "1.0"] not in lines:
        raise ValueError(f"{path.name} is not a binary little-endian PLY file")
    counts = {words[1]: int(words[2]) for words in lines if words[0] == "element"}
    vertex = np.dtype(
        [
            (words[2], "<" + PLY_TYPES[words[1]])
            for words in lines
            if words[0] == "property" and words[1] != "list"
        ]
    )
    size, index = next(words[2:4] for words in lines if words[:2] == ["property", "list"])
    face = np.dtype([("size", "<" + PLY_TYPES[size]), ("corners", "<" + PLY_TYPES[index], 3)])
    vertices = np.frombuffer(data, vertex, counts["vertex"])
    faces = np.frombuffer(data, face, counts["face"], offset=vertices.nbytes)
    if not (faces["size"] == 3).all():
        raise ValueError(f"{path.name} has faces that are not triangles")
    positions = np.stack([vertices[axis] for axis in "xyz"], axis=1)
    return positions.tolist(), faces["corners"].tolist()
