"""Checks what modules for Windows and macOS ask of a system, by their own tables.

    check_binaries.py PLATFORM FILE...

A module may link the system's own libraries and Python, and shows nothing but its start. One for
Windows has the functions inside that systems round in ways of their own, so that it draws as that
for Linux does. On macOS it must load from version 11 on and carry a signature: an Apple processor
runs nothing without.
Python's functions are found in the program, not in a library that is named.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import lief

OF_WINDOWS = re.compile(r"(kernel32|ntdll|api-ms-win-crt-[a-z0-9-]+)\.dll", re.IGNORECASE)
OF_MACOS = {"/usr/lib/libSystem.B.dylib"}
OF_THE_LINKER = {"___dso_handle", "__mh_dylib_header"}
OLDEST_MACOS = [11, 0, 0]
# Weak: the operators new and delete and what types are called; the first that a program loads are
# everyone's.
WEAK = re.compile(r"__Z(nw|na|dl|da)[mP]\w*|__ZT[IS]\w+")
NO_LIBRARY = {0, 254}  # the module itself, or whichever has the symbol when it is loaded
ROUNDED = re.compile(
    r"(a?cos|a?sin|a?tan|atan2|cabs|cbrt|exp2?|expm1|hypot|log(10|1p|2)?|pow|sincos)f?"
)
PROCESSORS = {
    "windows-x64": lief.PE.Header.MACHINE_TYPES.AMD64,
    "macos-arm64": lief.MachO.Header.CPU_TYPE.ARM64,
    "macos-x64": lief.MachO.Header.CPU_TYPE.X86_64,
}


def problems_on_windows(path: Path, platform: str) -> Iterator[str]:
    """What is wrong with a .pyd, a sentence each."""
    module = lief.PE.parse(str(path))
    if module.header.machine != PROCESSORS[platform]:
        yield f"is for the processor {module.header.machine}"
    number = re.search(r"\.cp(\d+)-", path.name)
    python = f"python{number[1]}.dll" if number else ""
    for library in [entry.name for entry in module.imports]:
        if library != python and not OF_WINDOWS.fullmatch(library):
            yield f"links {library}"
    asked = {each.name for library in module.imports for each in library.entries}
    rounded = sorted(name for name in asked if ROUNDED.fullmatch(name))
    if rounded:
        yield f"asks the system for {', '.join(rounded)}"
    exported = [entry.name for entry in module.get_export().entries]
    if exported != ["PyInit__core"]:
        yield f"exports {', '.join(exported)}"


def problems_on_macos(path: Path, platform: str) -> Iterator[str]:
    """What is wrong with a .so, a sentence each."""
    binaries = lief.MachO.parse(str(path))
    module = binaries.at(0)
    if len(binaries) != 1 or module.header.cpu_type != PROCESSORS[platform]:
        yield f"is for the processor {module.header.cpu_type}"
    foreign = {library.name for library in module.libraries} - OF_MACOS
    # Its own name is among them, and is no library that it asks for.
    foreign -= {module.get(lief.MachO.LoadCommand.TYPE.ID_DYLIB).name}
    if foreign:
        yield f"links {', '.join(sorted(foreign))}"
    if list(module.build_version.minos) > OLDEST_MACOS:
        yield f"asks for macOS {module.build_version.minos}"
    names = {symbol.name for symbol in module.exported_symbols} - OF_THE_LINKER
    exported = {name for name in names if not WEAK.fullmatch(name)}
    if exported != {"_PyInit__core"}:
        yield f"exports {', '.join(sorted(exported))}"
    if platform == "macos-arm64" and not module.has_code_signature:
        yield "has no signature, without which Apple's processors run nothing"
    yield from _homeless(module, names)


def _homeless(module: lief.MachO.Binary, own: set[str]) -> Iterator[str]:
    """Symbols that no library is named for, but for Python's and its own."""
    for symbol in module.imported_symbols:
        library = symbol.description >> 8 & 0xFF  # by its number among those that are linked
        found = symbol.name in own or re.match(r"__?Py", symbol.name)
        if library in NO_LIBRARY and not found:
            yield f"needs {symbol.name}, and names no library for it"


def main() -> int:
    """Prints what is wrong; the exit code is 0 when nothing is."""
    platform, *names = sys.argv[1:]
    problems = problems_on_windows if platform.startswith("windows") else problems_on_macos
    modules = [Path(name) for name in names if name.endswith((".pyd", ".so"))]
    found = [f"{path.name} {what}" for path in modules for what in problems(path, platform)]
    print(*found, f"{len(modules)} modules for {platform}, {len(found)} problems", sep="\n")
    return 1 if found or not modules else 0


if __name__ == "__main__":
    sys.exit(main())
