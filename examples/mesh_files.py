"""Reads OBJ, PLY and STL files and writes OBJ, the same way with every Blender and without one."""

import pathlib
from collections.abc import Iterable
from typing import Any

from ply_files import read_ply
from stl_files import read_stl


def read_mesh(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    """Positions and faces, lists of vertex numbers, of an .obj, .ply or .stl file.

    Raises ValueError for other files, and where a file is damaged.
    """
    readers = {".obj": _read_obj, ".ply": read_ply, ".stl": read_stl}
    kind = path.suffix.lower()
    if kind not in readers:
        raise ValueError(f"{path.name} is none of {', '.join(readers)}")
    return readers[kind](path)


def read_corner_normals(path: pathlib.Path) -> list[Any] | None:
    """Normals of the corners of an .obj file's faces, in their order; None where it has none.

    A corner without one, in a file with others, has the normal zero: it is not known.
    """
    if path.suffix.lower() != ".obj":
        return None
    lines = _obj_lines(path)
    normals = [[float(x) for x in words[1:4]] for words in lines if words[0] == "vn"]
    corners = [corner.split("/") for words in lines if words[0] == "f" for corner in words[1:]]
    if not any(len(parts) == 3 for parts in corners):
        return None
    known = [_number(parts[2], len(normals)) if len(parts) == 3 else None for parts in corners]
    return [[0, 0, 0] if number is None else normals[number] for number in known]


def write_obj(path: pathlib.Path, positions: Iterable[Any], faces: Iterable[Any]) -> None:
    """Writes positions and faces, lists of vertex numbers."""
    lines = [" ".join(["v", *map(str, position)]) for position in positions]
    lines += [" ".join(["f", *(str(corner + 1) for corner in face)]) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _read_obj(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    positions: list[Any] = []
    faces: list[Any] = []
    for words in _obj_lines(path):
        if words[0] == "v":
            positions.append([float(x) for x in words[1:4]])
        elif words[0] == "f":
            faces.append([_number(word.split("/")[0], len(positions)) for word in words[1:]])
    return positions, faces


def _obj_lines(path: pathlib.Path) -> list[list[str]]:
    """The words of each line that has some; a backslash at its end joins it with the next."""
    text = path.read_text(encoding="utf-8", errors="replace").replace("\\\n", " ")
    return [words for words in (line.split() for line in text.splitlines()) if words]


def _number(word: str, count: int) -> int:
    """Files count from 1, or with a minus sign backwards from what stands last."""
    number = int(word)
    return number - 1 if number > 0 else count + number
