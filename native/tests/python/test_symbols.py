"""What the module asks of a system and what it shows to one: its ELF symbol tables."""

from __future__ import annotations

import re
import sys
import zipfile
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import illustrate_native
import pytest
from elftools.elf.dynamic import DynamicSection
from elftools.elf.elffile import ELFFile
from elftools.elf.gnuversions import GNUVerNeedSection
from elftools.elf.sections import SymbolTableSection

ROOT = Path(__file__).resolve().parents[3]
LIBRARIES = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2"}
FLOORS = {"GLIBC": (2, 28), "GLIBCXX": (3, 4, 25), "CXXABI": (1, 3, 11)}
"""Of the oldest system that Blender itself runs on."""
GUESTS = ("OpenSubdiv", "nlopt")
ROUNDED = re.compile(
    r"(a?cosh?|a?sinh?|a?tanh?|atan2|cabs|cbrt|exp|exp2|expm1|hypot|log\w*|pow|sincos)f?"
)
"""Functions that each C library rounds in its own way, and some on each kind of processor."""


def modules() -> Iterator[tuple[str, bytes]]:
    """The module that is tested, and those in the packages of dist where they are built."""
    for path in Path(illustrate_native.__file__).parent.glob("_core*.so"):
        yield path.name, path.read_bytes()
    archives = (path for path in (ROOT / "dist").rglob("*.*") if "linux" in path.name)
    for archive in sorted(archives):
        with zipfile.ZipFile(archive) as opened:
            for name in opened.namelist():
                if name.endswith(".so"):
                    yield f"{archive.name}:{name}", opened.read(name)


MODULES = dict(modules()) if sys.platform == "linux" else {}
INSTRUMENTED = any(b"__asan_init" in data for data in MODULES.values())
pytestmark = pytest.mark.skipif(
    not MODULES or INSTRUMENTED, reason="reads ELF files without sanitizers"
)
each_module = pytest.mark.parametrize("name", MODULES)


def elf(name: str) -> ELFFile:
    return ELFFile(BytesIO(MODULES[name]))


def needed(name: str) -> set[str]:
    dynamic = elf(name).get_section_by_name(".dynamic")
    assert isinstance(dynamic, DynamicSection)
    tags: list[Any] = list(dynamic.iter_tags("DT_NEEDED"))
    return {tag.needed for tag in tags}


def exported(name: str) -> set[str]:
    symbols = elf(name).get_section_by_name(".dynsym")
    assert isinstance(symbols, SymbolTableSection)
    return {
        symbol.name
        for symbol in symbols.iter_symbols()
        if symbol.name and symbol.entry.st_shndx != "SHN_UNDEF"
    }


def imported(name: str) -> set[str]:
    symbols = elf(name).get_section_by_name(".dynsym")
    assert isinstance(symbols, SymbolTableSection)
    return {symbol.name for symbol in symbols.iter_symbols()} - exported(name)


def floors(name: str) -> dict[str, tuple[int, ...]]:
    """The highest version of each library's symbols that the module asks for."""
    section = elf(name).get_section_by_name(".gnu.version_r")
    assert isinstance(section, GNUVerNeedSection)
    highest: dict[str, tuple[int, ...]] = {}
    for _, versions in section.iter_versions():
        for version in versions:
            library, _, number = version.name.partition("_")
            parts = tuple(int(part) for part in number.split("."))
            highest[library] = max(parts, highest.get(library, ()))
    return highest


@each_module
def test_needs_nothing_but_the_system(name: str) -> None:
    assert needed(name) <= LIBRARIES


@each_module
def test_exports_its_entry_point_alone(name: str) -> None:
    assert exported(name) == {"PyInit__core"}


@each_module
def test_computes_alike_on_every_system(name: str) -> None:
    assert len(imported(name)) > 50
    assert [each for each in imported(name) if ROUNDED.fullmatch(each)] == []


@each_module
def test_loads_wherever_blender_does(name: str) -> None:
    found = floors(name)
    print(name, *(f"{key} {'.'.join(map(str, value))}" for key, value in sorted(found.items())))
    for library, floor in FLOORS.items():
        assert found[library] <= floor, library


def test_the_guests_are_inside() -> None:
    """Else the tests above would look at a module that has nothing to hide."""
    unstripped = MODULES[next(name for name in MODULES if ":" not in name)]
    for guest in GUESTS:
        assert guest.encode() in unstripped


@pytest.mark.parametrize("name", [name for name in MODULES if "manylinux" in name])
def test_the_tag_of_a_wheel_says_what_its_module_asks_for(name: str) -> None:
    tag = re.search(r"manylinux_(\d+)_(\d+)_x86_64", name)
    assert tag
    assert floors(name)["GLIBC"] <= (int(tag[1]), int(tag[2]))
