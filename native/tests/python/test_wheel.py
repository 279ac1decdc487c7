"""The wheel alone, as people without Blender have it."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
WHEELS = sorted((ROOT / "dist").rglob("*manylinux*.whl"))
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"

pytestmark = pytest.mark.skipif(
    not WHEELS or sys.platform != "linux" or "asan" in os.environ.get("LD_PRELOAD", ""),
    reason="needs built wheels of this system (make extension), without sanitizers",
)


def run(*command: object) -> str:
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


def pinned(package: str) -> str:
    """The requirement of .venv, such as 'mypy==2.4.1'."""
    lines = (ROOT / "tools" / "requirements.txt").read_text().splitlines()
    return next(line for line in lines if line.startswith(f"{package}=="))


@pytest.fixture(scope="module")
def bare_python(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment with the wheel and what it asks for, and nothing else."""
    folder = tmp_path_factory.mktemp("bare")
    run(sys.executable, "-m", "venv", folder)
    python = folder / "bin" / "python"
    run(python, "-m", "pip", "install", "--quiet", *(ROOT / "dist").glob("*.whl"))
    return python


def test_a_mesh_file_becomes_an_svg(bare_python: Path, tmp_path: Path) -> None:
    (tmp_path / "mesh.obj").write_text(TETRAHEDRON)
    example, drawing = ROOT / "examples" / "draw_file.py", tmp_path / "drawing.svg"
    for options, wanted in (["--cage"], ["hatch", "silhouette"]), ([], ["crease"]):
        run(bare_python, example, tmp_path / "mesh.obj", drawing, *options)
        layers = re.findall(r'<g id="([a-z]+)"[^>]*>\s*<path [^>]*d="M[^"]+"', drawing.read_text())
        assert layers == wanted
    where = run(bare_python, "-c", "import illustrate_native as i; print(i.__file__)")
    assert Path(where.strip()).is_relative_to(bare_python.parents[1])


def test_its_types_are_what_the_module_has(bare_python: Path) -> None:
    """By mypy of this environment, on what is installed in that one."""
    allowed = ROOT / "tools" / "stubtest-allowlist.txt"
    run(bare_python, "-m", "pip", "install", "--quiet", pinned("mypy"))
    run(bare_python, "-m", "mypy.stubtest", "illustrate_native", "--allowlist", allowed,
        "--ignore-unused-allowlist")  # fmt: skip
    run(bare_python, "-m", "mypy", "--strict", ROOT / "examples" / "draw_file.py")


@pytest.mark.parametrize("wheel", WHEELS, ids=lambda wheel: wheel.name)
def test_auditwheel_agrees_with_the_tag(wheel: Path) -> None:
    found = json.loads(run(sys.executable, "-m", "auditwheel", "show", "--json", wheel))
    tag = re.search(r"manylinux_2_(\d+)_x86_64", wheel.name)
    policy = re.search(r"manylinux_2_(\d+)_x86_64", json.dumps(found["overall_tag"]))
    assert tag and policy and int(policy[1]) <= int(tag[1]), found


@pytest.mark.parametrize("archive", [*WHEELS, *sorted((ROOT / "dist").glob("*legacy*.zip"))],
                         ids=lambda archive: archive.name)  # fmt: skip
def test_the_licences_of_what_is_inside_come_with_it(archive: Path) -> None:
    names = zipfile.ZipFile(archive).namelist()
    licences = {Path(name).name for name in names if "/licenses/" in name}
    inside = {"opensubdiv.txt", "opensubdiv-notice.txt", "nlopt.txt", "nlopt-luksan.txt"}
    assert inside | {"eigen.txt", "pybind11.txt"} <= licences
    assert any(Path(name).name == "LICENSE" for name in names)


# Modules for Windows and macOS hold the C++ library, too.
def test_packages_are_small() -> None:
    for archive in (ROOT / "dist").glob("*.zip"):
        with zipfile.ZipFile(archive) as package:
            modules = sum(
                "/_core." in f"/{name}" or name.endswith(".whl") for name in package.namelist()
            )
        most = 2_300_000 if "linux" in archive.name else 2_600_000
        assert archive.stat().st_size < most * modules + 400_000, archive.name
