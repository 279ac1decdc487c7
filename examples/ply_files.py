"""Reads PLY files: text and binary of either byte order, whatever their elements and properties."""

import pathlib
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

TYPES = {
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
BYTE_ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}
CORNERS = ("vertex_indices", "vertex_index")


class Property(NamedTuple):
    """A number, or a list: then `size` is the type of the number of its items."""

    name: str
    type: str
    size: str | None


class Element(NamedTuple):
    """What the header says of rows of one kind."""

    name: str
    rows: int
    properties: list[Property]


Rows = dict[str, list[Any]]


def read_ply(path: pathlib.Path) -> tuple[list[Any], list[Any]]:
    """Positions and faces, lists of vertex numbers.

    Raises ValueError, which names the file, where it is damaged or holds no mesh.
    """
    header, end, data = path.read_bytes().partition(b"end_header")
    try:
        encoding, elements = _read_header(header.decode("ascii", "replace"))
        data = data.partition(b"\n")[2]
        rows = dict(_rows(encoding, elements, data))
        if not end or "vertex" not in rows:
            raise ValueError("it holds no vertices")
        positions = np.column_stack([rows["vertex"][axis] for axis in "xyz"])
        faces = rows.get("face", {})
        return positions.tolist(), next((faces[name] for name in CORNERS if name in faces), [])
    except (ValueError, KeyError, IndexError) as error:
        raise ValueError(f"{path.name} cannot be read as PLY: {error}") from error


def _read_header(text: str) -> tuple[str, list[Element]]:
    encoding, elements = "", list[Element]()
    for words in (line.split() for line in text.splitlines()):
        if words[:1] == ["format"]:
            encoding = words[1]
        elif words[:1] == ["element"]:
            elements.append(Element(words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1].properties.append(Property(words[4], TYPES[words[3]], TYPES[words[2]]))
        elif words[:1] == ["property"]:
            elements[-1].properties.append(Property(words[2], TYPES[words[1]], None))
    if encoding not in BYTE_ORDERS:
        raise ValueError(f"its format is '{encoding}'")
    return encoding, elements


def _rows(encoding: str, elements: list[Element], data: bytes) -> Iterator[tuple[str, Rows]]:
    words, offset = data.split() if encoding == "ascii" else [], 0
    for element in elements:
        if encoding == "ascii":
            rows, offset = _text_rows(element, words, offset)
        else:
            rows, offset = _binary_rows(element, data, offset, BYTE_ORDERS[encoding])
        yield element.name, rows


def _text_rows(element: Element, words: list[bytes], at: int) -> tuple[Rows, int]:
    rows: Rows = {p.name: [] for p in element.properties}
    for _ in range(element.rows):
        for p in element.properties:
            if p.size is None:
                rows[p.name].append(float(words[at]))
                at += 1
            else:
                count = int(words[at])
                rows[p.name].append([int(float(word)) for word in words[at + 1 : at + 1 + count]])
                at += 1 + count
    return rows, at


def _binary_rows(element: Element, data: bytes, at: int, order: str) -> tuple[Rows, int]:
    """All rows at once where every list is as long as in the first, as most often."""
    lengths = _lengths_of_first(element, data, at, order) if element.rows else {}
    fields: list[Any] = []
    for number, p in enumerate(element.properties):  # names may stand twice
        if p.size is not None:
            fields.append((f"size{number}", order + p.size))
        fields.append((f"value{number}", order + p.type, (lengths.get(number, ()))))
    table = np.dtype(fields)
    if at + element.rows * table.itemsize <= len(data):
        values = np.frombuffer(data, table, element.rows, at)
        if all((values[f"size{n}"] == length).all() for n, (length,) in lengths.items()):
            named = {p.name: f"value{n}" for n, p in reversed([*enumerate(element.properties)])}
            rows = {name: values[field].tolist() for name, field in named.items()}
            return rows, at + values.nbytes
    return _uneven_rows(element, data, at, order)


def _lengths_of_first(element: Element, data: bytes, at: int, order: str) -> dict[int, tuple[int]]:
    lengths = {}
    for number, p in enumerate(element.properties):
        if p.size is not None:
            size = np.dtype(order + p.size)
            lengths[number] = (int(np.frombuffer(data, size, 1, at)[0]),)
            at += size.itemsize
        at += np.dtype(order + p.type).itemsize * lengths.get(number, (1,))[0]
    return lengths


def _uneven_rows(element: Element, data: bytes, at: int, order: str) -> tuple[Rows, int]:
    rows: Rows = {p.name: [] for p in element.properties}
    types = [
        (p.name, np.dtype(order + p.type), None if p.size is None else np.dtype(order + p.size))
        for p in element.properties
    ]
    for _ in range(element.rows):
        for name, item, size in types:
            count = 1
            if size is not None:
                count = int(np.frombuffer(data, size, 1, at)[0])
                at += size.itemsize
            values = np.frombuffer(data, item, count, at).tolist()
            rows[name].append(values if size is not None else values[0])
            at += item.itemsize * count
    return rows, at
