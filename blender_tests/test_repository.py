"""A repository of the built package: Blender's own tools judge it, make it and install from it."""

import os
import pathlib
import re
import subprocess
import sys
import tomllib
import zipfile
from typing import Any

import bpy
import pytest

import tools

ARCHIVE = os.environ.get("ILLUSTRATE_ZIP", "")
USER = pathlib.Path(__file__).parent / "repository_user.py"
SHORT_TEXT = 64  # characters: what the platform takes for a tagline or a reason

pytestmark = pytest.mark.skipif(
    not ARCHIVE or bpy.app.version < (4, 2, 0), reason="needs a built package and Blender 4.2"
)


def extension_tool(*words: object) -> str:
    """Blender's program for extensions, run by Python alone; what it printed."""
    system = pathlib.Path(bpy.utils.system_resource("SCRIPTS"))
    program = system / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    command = [sys.executable, program, *words]
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


def repository(folder: pathlib.Path, version: str) -> pathlib.Path:
    """A repository in the folder that has the package as this version."""
    folder.mkdir()
    with zipfile.ZipFile(ARCHIVE) as source, zipfile.ZipFile(folder / "package.zip", "w") as target:
        for name in source.namelist():
            data = source.read(name)
            if name == "blender_manifest.toml":
                data = re.sub(rb'(?m)^version = ".*"$', f'version = "{version}"'.encode(), data)
            target.writestr(name, data)
    extension_tool("server-generate", "--repo-dir", folder, "--html")
    return folder


def test_the_validator_takes_the_package() -> None:
    assert "Success" in extension_tool("validate", os.path.abspath(ARCHIVE))


def test_its_texts_are_short() -> None:
    manifest = tomllib.loads(zipfile.ZipFile(ARCHIVE).read("blender_manifest.toml").decode())
    for text in (manifest["tagline"], *manifest["permissions"].values()):
        assert 0 < len(text) <= SHORT_TEXT and text[-1].isalnum(), text


def test_installs_and_updates_from_a_repository(tmp_path: Any) -> None:
    folder = repository(pathlib.Path(tmp_path) / "repository", "0.0.1")
    update = repository(pathlib.Path(tmp_path) / "update", "99.0.0")
    assert (folder / "index.html").is_file()
    user = pathlib.Path(tmp_path) / "user"
    address = (folder / "index.json").as_uri()
    ran = tools.run_script(USER, address, str(folder), str(update), user=user)
    told = dict(re.findall(r"^([a-z ]+): (.*)$", ran.stdout, re.MULTILINE))
    assert told.get("installed") == "0.0.1", ran.stdout + ran.stderr
    assert told.get("updated") == "99.0.0", ran.stdout + ran.stderr
    assert told["registered"] == told["still registered"] == "True"
