"""The example's readers of mesh files, on what other programs write."""

from __future__ import annotations

import importlib
import struct
from collections.abc import Callable
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[3] / "examples"
Read = Callable[[Path], tuple[list[list[float]], list[list[int]]]]

POINTS: list[list[float]] = [[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]]
FACES = [[0, 1, 2, 3], [0, 1, 4]]
HEADER = """ply
format {} 1.0
comment colours stand twice in files of some scanners
element vertex 5
property float x
property float y
property float z
property uchar red
property uchar red
element other 1
property list uchar short values
element face 2
property list uchar int {}
property float quality
end_header
"""


@pytest.fixture
def read_mesh(monkeypatch: pytest.MonkeyPatch) -> Read:
    monkeypatch.syspath_prepend(str(EXAMPLES))
    reader: Read = importlib.import_module("mesh_files").read_mesh
    return reader


def binary_ply(order: str, faces: list[list[int]]) -> bytes:
    data = b"".join(struct.pack(f"{order}3f2B", *point, 7, 8) for point in POINTS)
    data += struct.pack(f"{order}B3h", 3, 1, 2, 3)
    for face in faces:
        data += struct.pack(f"{order}B{len(face)}if", len(face), *face, 0.5)
    return data


@pytest.mark.parametrize(("order", "name"), [("<", "little"), (">", "big")])
def test_binary_ply(read_mesh: Read, tmp_path: Path, order: str, name: str) -> None:
    path = tmp_path / "mesh.ply"
    header = HEADER.format(f"binary_{name}_endian", "vertex_indices").encode()
    path.write_bytes(header + binary_ply(order, FACES))
    assert read_mesh(path) == (POINTS, FACES)
    even = [[0, 1, 2], [0, 2, 3]]
    path.write_bytes(header + binary_ply(order, even))
    assert read_mesh(path) == (POINTS, even)


def test_text_ply(read_mesh: Read, tmp_path: Path) -> None:
    path = tmp_path / "MESH.PLY"
    rows = [f"{x} {y} {z} 7 8" for x, y, z in POINTS] + ["3 1 2 3"]
    rows += [" ".join(map(str, [len(face), *face, 0.5])) for face in FACES]
    text = HEADER.format("ascii", "vertex_index") + "\n".join(rows)
    path.write_text(text.replace("\n", "\r\n"), newline="")
    assert read_mesh(path) == (POINTS, FACES)


@pytest.mark.parametrize("damage", [b"", b"\0" * 3, b"ply\nformat odd 1.0\nend_header\n"])
def test_damaged_ply_is_named(read_mesh: Read, tmp_path: Path, damage: bytes) -> None:
    path = tmp_path / "torn.ply"
    whole = HEADER.format("binary_little_endian", "vertex_indices").encode()
    path.write_bytes(damage or whole + binary_ply("<", FACES)[:-9])
    with pytest.raises(ValueError, match=r"torn\.ply cannot be read as PLY"):
        read_mesh(path)


def test_obj_numbers_may_count_backwards(read_mesh: Read, tmp_path: Path) -> None:
    path = tmp_path / "mesh.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 \\\n -1\nv 2 0 0\nf -1/5 1 3//2\n")
    positions, faces = read_mesh(path)
    assert len(positions) == 4 and faces == [[0, 1, 2], [3, 0, 2]]


def test_stl(read_mesh: Read, tmp_path: Path) -> None:
    triangles = [[(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0), (0, 1, 0)]]
    text, binary = tmp_path / "text.stl", tmp_path / "binary.STL"
    facets = "".join(
        "facet normal 0 0 1\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in triangle)
        + "endloop\nendfacet\n"
        for triangle in triangles
    )
    text.write_text(f"solid thing\n{facets}endsolid thing\n")
    data = b"solid is what this header says too".ljust(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        data += struct.pack("<12fH", 0, 0, 1, *(x for corner in triangle for x in corner), 0)
    binary.write_bytes(data)
    for path in (text, binary):
        positions, faces = read_mesh(path)
        assert len(positions) == 4
        read = [[tuple(positions[corner]) for corner in face] for face in faces]
        assert read == triangles


def test_other_files_are_named(read_mesh: Read, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"mesh\.fbx is none of \.obj, \.ply, \.stl"):
        read_mesh(tmp_path / "mesh.fbx")
    (tmp_path / "empty.stl").write_bytes(b"")
    with pytest.raises(ValueError, match=r"empty\.stl cannot be read as STL"):
        read_mesh(tmp_path / "empty.stl")
