"""The built package as a new user meets it."""

import os
import pathlib
import re
import sys
import zipfile
from typing import Any

import bpy
import pytest

import tools

ARCHIVE = os.environ.get("ILLUSTRATE_ZIP", "")
USER = pathlib.Path(__file__).parent / "user.py"
PYTHON = "{}.{}".format(*sys.version_info[:2])

pytestmark = pytest.mark.skipif(not ARCHIVE, reason="needs a built package: make matrix")


def test_installs_draws_and_goes_without_a_trace(tmp_path: Any) -> None:
    ran = tools.run_script(USER, ARCHIVE, user=tmp_path)
    told = re.findall(r"^([a-z ]+): ?(.*)$", ran.stdout, re.MULTILINE)
    lines = dict(told)
    assert "Traceback" not in ran.stderr, ran.stdout + ran.stderr
    assert lines["drew"] == "FINISHED"
    assert pathlib.Path(lines["module"]).is_relative_to(tmp_path)
    assert lines["left after disabling"] == lines["left after removing"] == ""
    assert lines["same after enabling"] == lines["same after another install"] == "True"


@pytest.fixture
def package_for_others(tmp_path: Any) -> pathlib.Path:
    """The package without its module for this Python; its only one goes as another Python's."""
    digits, another = PYTHON.replace(".", ""), "39"
    path = pathlib.Path(tmp_path) / "illustrate-for-others.zip"
    with zipfile.ZipFile(ARCHIVE) as source, zipfile.ZipFile(path, "w") as target:
        pythons = set(re.findall(r"cp(?:ython-)?(3\d+)-", " ".join(source.namelist())))
        for name in source.namelist():
            data = source.read(name)
            if re.search(rf"cp(ython-)?{digits}-", name):
                if pythons == {digits}:
                    target.writestr(name.replace(f"-{digits}-", f"-{another}-"), data)
                continue
            if name == "blender_manifest.toml":
                data = re.sub(rb".*-cp" + digits.encode() + rb"-.*\n", b"", data)
            target.writestr(name, data)
    return path


def test_a_package_without_the_module_says_so(package_for_others: Any, tmp_path: Any) -> None:
    ran = tools.run_script(USER, str(package_for_others), user=tmp_path / "user")
    said = ran.stdout + ran.stderr
    names = " ".join(zipfile.ZipFile(package_for_others).namelist())
    others = set(re.findall(r"cp(?:ython-)?3(\d+)-", names))
    assert others and "drew: FINISHED" not in said
    assert PYTHON in said, said
    for minor in others:
        assert re.search(rf"\b3[.]{minor}\b", said), said
    if bpy.app.version < (4, 2, 0):
        assert "native module of Illustrate is missing" in said
        assert f"Blender {bpy.app.version_string} runs Python {PYTHON}" in said
