"""Packages as they are handed out, made of a folder that stands for a built module."""

from __future__ import annotations

import ast
import sys
import tomllib
import zipfile
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools"))

import package  # noqa: E402

WEBSITE = "https://example.org/illustrate/"


def built(folder: Path, *pythons: str) -> Path:
    for python in pythons:
        (folder / f"_core.cpython-{python}-x86_64-linux-gnu.so").write_bytes(b"")
    return folder


def manifest_of(archive: Path) -> dict[str, Any]:
    with zipfile.ZipFile(archive) as opened:
        return tomllib.loads(opened.read("blender_manifest.toml").decode())


def bl_info_of(archive: Path) -> dict[str, Any]:
    with zipfile.ZipFile(archive) as opened:
        tree = ast.parse(opened.read("illustrate/__init__.py"))
    found = [node.value for node in tree.body if isinstance(node, ast.Assign)]
    return next(ast.literal_eval(value) for value in found if isinstance(value, ast.Dict))


@pytest.mark.parametrize("website", ["", WEBSITE])
def test_packages_say_where_their_documentation_is(website: str, tmp_path: Path) -> None:
    linux = package.PLATFORMS["linux-x64"]
    new = manifest_of(package.make_extension(linux, [], tmp_path, website))
    old = bl_info_of(package.make_legacy(linux, built(tmp_path, "311"), tmp_path, website))
    assert new.get("website", "") == old.get("doc_url", "") == website
    assert new["name"] == old["name"] == "Illustrate"


@pytest.mark.parametrize("name", ["macos-arm64", "macos-x64"])
def test_packages_for_macos_say_that_they_are_untested(name: str, tmp_path: Path) -> None:
    made = manifest_of(package.make_extension(package.PLATFORMS[name], [], tmp_path, WEBSITE))
    assert made["name"] == "Illustrate (untested on macOS)"
    assert made["platforms"] == [name]


def test_a_module_for_no_wanted_python_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="no module for Python 310, 311"):
        package.pythons_of(built(tmp_path, "39"), ("310", "311"))
