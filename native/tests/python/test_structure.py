"""The directions of the architecture: who may include or import whom.

core <- mesh <- surface <- field, core <- view, and so on to the pipeline, the bindings and the
add-on; third-party libraries stay where they belong. The table stands here once more, apart from
CMakeLists.txt, so that neither can drift without the other.
"""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
NATIVE = ROOT / "native"

# The stages that each stage builds on directly; what those build on is allowed too.
BUILDS_ON = {
    "core": [],
    "mesh": ["core"],
    "control": ["mesh"],
    "surface": ["control"],
    "field": ["surface"],
    "view": ["core"],
    "occlusion": ["surface", "view"],
    "contour": ["mesh", "surface", "view", "occlusion"],
    "visibility": ["contour"],
    "tone": ["surface", "view", "occlusion", "visibility"],
    "hatch": ["field", "tone", "visibility"],
    "stroke": ["hatch", "visibility", "tone"],
    "pipeline": ["field", "hatch", "stroke"],
    "bindings": ["pipeline"],
}
STAGES = [stage for stage in BUILDS_ON if stage != "bindings"]

# Third-party headers and the one folder that may include them.
HOME_OF_LIBRARY = {"opensubdiv": "surface", "nlopt": "field", "pybind11": "bindings"}
PRIVATE_LIBRARIES = ("opensubdiv", "nlopt")

# A stage reads no file, prints nothing, and no chance or clock enters its result.
FORBIDDEN_HEADERS = {"iostream", "fstream", "cstdio", "stdio.h", "filesystem", "random", "ctime"}

BLENDER_MODULES = {"bpy", "bpy_extras", "bmesh", "mathutils", "gpu", "blf"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def may_include(stage: str) -> set[str]:
    """The stage itself and all that it builds on, directly or not."""
    allowed = {stage}
    for earlier in BUILDS_ON[stage]:
        allowed |= may_include(earlier)
    return allowed


def include_violations(stage: str, text: str) -> list[str]:
    """What is wrong with the includes of a source file of `stage`."""
    wrong = []
    for bracket, path in INCLUDE.findall(text):
        folder, _, rest = path.partition("/")
        if bracket == '"':
            if not rest:
                wrong.append(f'"{path}" is not relative to native/')
            elif folder not in may_include(stage):
                wrong.append(f'"{path}" is not before {stage}')
        library = folder.removesuffix(".h").removesuffix(".hpp")
        if HOME_OF_LIBRARY.get(library, stage) != stage:
            wrong.append(f"<{path}> belongs to {HOME_OF_LIBRARY[library]} alone")
        if path in FORBIDDEN_HEADERS and stage != "bindings":
            wrong.append(f"<{path}> has no place in a stage")
    return wrong


def imported_modules(text: str) -> Iterator[str]:
    """Full names of the modules that a Python file imports; relative ones begin with a dot."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield "." * node.level + (node.module or "")


def import_violations(folder: str, text: str) -> list[str]:
    """What is wrong with the imports of a Python file below `folder`, a path from the root."""
    wrong = []
    for module in imported_modules(text):
        package = module.partition(".")[0]
        if folder.startswith(("native", "tools")) and package in BLENDER_MODULES:
            wrong.append(f"{module}: Blender is known to the add-on, its tests and examples alone")
        if folder == "native/illustrate_native" and not (
            not package
            or package in sys.stdlib_module_names
            or package in ("numpy", "illustrate_native")
        ):
            wrong.append(f"{module}: the package needs numpy and nothing else")
        if folder.startswith(("native", "addon")) and package in ("blender_tests", "examples"):
            wrong.append(f"{module}: comes after {folder}")
        if folder.startswith("native") and package in ("addon", "illustrate"):
            wrong.append(f"{module}: comes after {folder}")
    return wrong


def sources(stage: str) -> list[Path]:
    return sorted(p for p in (NATIVE / stage).rglob("*") if p.suffix in (".h", ".cpp"))


@pytest.mark.parametrize("stage", BUILDS_ON)
def test_includes_follow_the_directions(stage: str) -> None:
    files = sources(stage)
    assert files, f"native/{stage} has no sources"
    wrong = [
        f"{path.relative_to(ROOT)}: {violation}"
        for path in files
        for violation in include_violations(stage, path.read_text(encoding="utf-8"))
    ]
    assert not wrong, "\n".join(wrong)


def headers_with(library: str, stage: str) -> set[str]:
    """Headers of `stage` that include `library`, by themselves or through another of the stage."""
    includes = {
        f"{stage}/{path.relative_to(NATIVE / stage)}": {
            name for _, name in INCLUDE.findall(path.read_text(encoding="utf-8"))
        }
        for path in sources(stage)
        if path.suffix == ".h"
    }
    found = {h for h, names in includes.items() if any(n.startswith(library) for n in names)}
    while grown := {h for h, names in includes.items() if names & found} - found:
        found |= grown
    return found


@pytest.mark.parametrize("library", PRIVATE_LIBRARIES)
def test_library_types_do_not_leave_their_stage(library: str) -> None:
    home = HOME_OF_LIBRARY[library]
    private = headers_with(library, home)
    for stage in BUILDS_ON:
        for path in sources(stage) if stage != home else []:
            names = {name for _, name in INCLUDE.findall(path.read_text(encoding="utf-8"))}
            leaks = names & private
            assert not leaks, f"{path.relative_to(ROOT)} sees {library} through {sorted(leaks)}"


def test_only_core_and_pipeline_know_the_clock() -> None:
    for stage in STAGES:
        for path in sources(stage) if stage not in ("core", "pipeline") else []:
            assert "<chrono>" not in path.read_text(encoding="utf-8"), path.relative_to(ROOT)


def test_cmake_links_the_same_directions() -> None:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    linked = {
        name: set(rest.partition("USES")[0].split())
        for name, rest in re.findall(r"^illustrate_stage\((\w+)([^)]*)\)", text, re.MULTILINE)
    }
    assert list(linked) == STAGES
    for stage, earlier in linked.items():
        reached = {stage}.union(*(may_include(name) for name in earlier))
        assert reached == may_include(stage), stage


@pytest.mark.parametrize(
    "folder",
    ["native/illustrate_native", "native/tests", "native/benchmarks", "tools", "addon"],
)
def test_imports_follow_the_directions(folder: str) -> None:
    files = sorted((ROOT / folder).rglob("*.py"))
    assert files, f"{folder} has no Python files"
    wrong = [
        f"{path.relative_to(ROOT)}: {violation}"
        for path in files
        for violation in import_violations(folder, path.read_text(encoding="utf-8"))
    ]
    assert not wrong, "\n".join(wrong)


def test_only_one_file_of_the_addon_imports_the_module() -> None:
    importing = [
        path.relative_to(ROOT / "addon").as_posix()
        for path in sorted((ROOT / "addon").rglob("*.py"))
        if any(
            "illustrate_native" in module.split(".")
            for module in imported_modules(path.read_text(encoding="utf-8"))
        )
    ]
    assert set(importing) <= {"native.py"}


# What the platform for extensions refuses: threads, other search paths and modules, sudden ends,
# text that is run. headless.py is started from outside and finds the add-on.
REFUSED_MODULES = {"threading", "_thread", "concurrent", "multiprocessing", "asyncio"}
REFUSED_NAMES = {"sys.path", "sys.modules", "sys.meta_path", "os._exit", "site.addsitedir"}
REFUSED_CALLS = {"eval", "exec", "compile", "__import__"}
STARTED_FROM_OUTSIDE = {"headless.py": {"sys.path", "os._exit"}}


def refused(text: str) -> set[str]:
    """What of it a Python file uses, under whatever name it is imported."""
    tree, found = ast.parse(text), set()
    imported = {m.partition(".")[0] for m in imported_modules(text) if not m.startswith(".")}
    found |= imported & REFUSED_MODULES
    owners = {name.partition(".")[0] for name in REFUSED_NAMES}
    alias = {
        (a.asname or a.name): a.name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import)
        for a in node.names
        if a.name in owners
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            found |= {f"{alias.get(node.value.id)}.{node.attr}"} & REFUSED_NAMES
        elif isinstance(node, ast.ImportFrom):
            found |= {f"{node.module}.{a.name}" for a in node.names} & REFUSED_NAMES
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            found |= {node.func.id} & REFUSED_CALLS
    return found


def test_the_addon_has_nothing_that_extensions_may_not_have() -> None:
    for path in sorted((ROOT / "addon").rglob("*.py")):
        name = path.relative_to(ROOT / "addon").as_posix()
        wrong = refused(path.read_text(encoding="utf-8")) - STARTED_FROM_OUTSIDE.get(name, set())
        assert not wrong, f"{name}: {sorted(wrong)}"


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("import threading", "threading"),
        ("from concurrent.futures import Future", "concurrent"),
        ("import sys\nsys.path.insert(0, '')", "sys.path"),
        ("import sys as s\ns.modules['a'] = 1", "sys.modules"),
        ("from sys import modules", "sys.modules"),
        ("def late():\n    import os\n    os._exit(0)", "os._exit"),
        ("exec('pass')", "exec"),
    ],
)
def test_what_extensions_may_not_have_is_found(text: str, name: str) -> None:
    assert refused(text) == {name}


def test_versions_agree() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    manifest = tomllib.loads((ROOT / "addon/blender_manifest.toml").read_text(encoding="utf-8"))
    assert project["project"]["version"] == manifest["version"]


@pytest.mark.parametrize(
    ("stage", "line"),
    [
        ("mesh", '#include "surface/surface.h"'),
        ("view", '#include "mesh/bvh.h"'),
        ("tone", '#include "hatch/hatches.h"'),
        ("contour", '#include "field/cross_field.h"'),
        ("core", '#include "types.h"'),
        ("field", "#include <opensubdiv/far/topologyRefiner.h>"),
        ("surface", "#include <nlopt.hpp>"),
        ("pipeline", "#include <pybind11/pybind11.h>"),
        ("stroke", "#include <iostream>"),
    ],
)
def test_a_wrong_include_is_found(stage: str, line: str) -> None:
    assert include_violations(stage, f"#pragma once\n{line}\n")


@pytest.mark.parametrize(
    ("folder", "line"),
    [
        ("native/illustrate_native", "import bpy"),
        ("native/illustrate_native", "from scipy import sparse"),
        ("native/tests", "from mathutils.bvhtree import BVHTree"),
        ("addon", "import blender_tests.conftest"),
        ("native/benchmarks", "import illustrate"),
    ],
)
def test_a_wrong_import_is_found(folder: str, line: str) -> None:
    assert import_violations(folder, f"def late():\n    {line}\n")
