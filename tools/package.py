"""Makes what is handed to people: wheels of the module, and the add-on as a zip for Blender.

Two runs on the same files make the same bytes.
"""

from __future__ import annotations

import argparse
import base64
import hashlib
import os
import re
import tomllib
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LEFT_OUT = ("__pycache__", ".pyc")


@dataclass(frozen=True)
class Platform:
    """A system that packages are made for, under the name that Blender gives it.

    wheel: its tag. pythons: those of the Blenders, 4.2 and later, that there are for it. legacy:
    those of Blender 3.4 to 4.1, which takes no wheels. remark: what its users must know.
    """

    name: str
    wheel: str
    pythons: tuple[str, ...]
    legacy: tuple[str, ...] = ()
    remark: str = ""


PLATFORMS = {
    platform.name: platform
    for platform in (
        # A test holds the module's symbols against the tag. Debian's own Blender runs Python 3.14.
        Platform("linux-x64", "manylinux_2_28_x86_64", ("311", "313", "314"), ("310", "311")),
        Platform("windows-x64", "win_amd64", ("311", "313")),
        Platform("macos-arm64", "macosx_11_0_arm64", ("311", "313"), remark="untested on macOS"),
        Platform("macos-x64", "macosx_11_0_x86_64", ("311", "313"), remark="untested on macOS"),
    )
}

Files = dict[str, bytes]
"""What is in an archive: contents by path."""


def manifest() -> str:
    """The text of the add-on's manifest, which says the version of all."""
    return (ROOT / "addon" / "blender_manifest.toml").read_text(encoding="utf-8")


def version() -> str:
    """Such as '0.1.0'."""
    return str(tomllib.loads(manifest())["version"])


def files_below(folder: Path, prefix: str = "") -> Files:
    """All files of a folder by their paths in it, after `prefix`."""
    return {
        prefix + path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and not any(mark in path.as_posix() for mark in LEFT_OUT)
    }


def write_zip(path: Path, files: Files) -> Path:
    """Writes an archive whose bytes depend on `files` alone."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = 0o644 << 16
            is_packed = name.endswith(".whl")
            entry.compress_type = zipfile.ZIP_STORED if is_packed else zipfile.ZIP_DEFLATED
            archive.writestr(entry, data, compresslevel=9)
    return path


def pythons_of(installed: Path, wanted: tuple[str, ...]) -> tuple[str, ...]:
    """Those of the wanted Pythons that there is a binary for. Raises FileNotFoundError: none."""
    there = {_python_of(path.name) for path in installed.glob("_core.*")}
    found = tuple(python for python in wanted if python in there)
    if not found:
        raise FileNotFoundError(f"{installed} has no module for Python {', '.join(wanted)}")
    return found


def module_files(installed: Path, pythons: tuple[str, ...]) -> Files:
    """The package illustrate_native with its binaries for these Pythons."""
    files = files_below(installed, "illustrate_native/")
    return {name: data for name, data in files.items() if _python_of(name) in ("", *pythons)}


def _python_of(name: str) -> str:
    found = re.search(r"\.cp(?:ython-)?(\d+)-", name)
    return found[1] if found else ""


def metadata() -> str:
    """The wheel's METADATA, from pyproject.toml."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lines = [
        "Metadata-Version: 2.4",
        f"Name: {project['name']}",
        f"Version: {version()}",
        f"Summary: {project['description']}",
        f"License-Expression: {project['license']}",
        "License-File: LICENSE",
        *(f"Classifier: {name}" for name in project["classifiers"]),
        f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {name}" for name in project["dependencies"]),
        "Description-Content-Type: text/markdown",
    ]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    return "\n".join([*lines, "", readme])


def _record(files: Files, name: str) -> Iterator[str]:
    for path, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        yield f"{path},sha256={digest},{len(data)}"
    yield f"{name},,"


def make_wheel(platform: Platform, installed: Path, python: str, folder: Path) -> Path:
    """Writes the wheel for one Python, such as '313'; its path."""
    tag = f"cp{python}-cp{python}-{platform.wheel}"
    info = f"illustrate_native-{version()}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: illustrate\nRoot-Is-Purelib: false\nTag: {tag}\n"
    files = module_files(installed, (python,)) | {
        f"{info}/METADATA": metadata().encode(),
        f"{info}/WHEEL": wheel.encode(),
        f"{info}/licenses/LICENSE": (ROOT / "LICENSE").read_bytes(),
    }
    record = "\n".join([*_record(files, f"{info}/RECORD"), ""])
    files[f"{info}/RECORD"] = record.encode()
    return write_zip(folder / f"illustrate_native-{version()}-{tag}.whl", files)


def manifest_with(platform: Platform, wheels: list[Path], website: str = "") -> str:
    """The manifest as it ships: with the platform, the wheels and where its documentation is."""
    listed = "".join(f'  "./wheels/{wheel.name}",\n' for wheel in wheels)
    added = f'platforms = ["{platform.name}"]\nwheels = [\n{listed}]\n\n'
    head, table, tail = manifest().partition("[permissions]")
    if platform.remark:
        head = re.sub(r'(?m)^name = "(.*)"$', rf'name = "\1 ({platform.remark})"', head)
    if website:
        head = re.sub(r"(?m)^tagline = .*$", rf'\g<0>\nwebsite = "{website}"', head)
    return head + added + table + tail


def with_doc_url(source: bytes, website: str) -> bytes:
    """addon/__init__.py, whose bl_info says in Blender 3.4 to 4.1 where the documentation is."""
    line = f'    "doc_url": "{website}",\n' if website else ""
    return source.replace(b'    "category": ', f'{line}    "category": '.encode())


def make_extension(platform: Platform, wheels: list[Path], folder: Path, website: str = "") -> Path:
    """Writes the extension for Blender 4.2 and later; its path."""
    files = files_below(ROOT / "addon") | {
        "blender_manifest.toml": manifest_with(platform, wheels, website).encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
    }
    files |= {f"wheels/{wheel.name}": wheel.read_bytes() for wheel in wheels}
    return write_zip(folder / f"illustrate-{version()}-{platform.name}.zip", files)


def make_legacy(platform: Platform, installed: Path, folder: Path, website: str = "") -> Path:
    """Writes the add-on for Blender 3.4 to 4.1, with the module inside; its path."""
    pythons = pythons_of(installed, platform.legacy)
    files = files_below(ROOT / "addon") | module_files(installed, pythons)
    files["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files["__init__.py"] = with_doc_url(files["__init__.py"], website)
    del files["blender_manifest.toml"]
    name = f"illustrate-{version()}-legacy-{platform.name}.zip"
    # Blender removes an older installation, the module in memory too, by the entry of its folder;
    # without one it would write into the file that is mapped.
    inside = {f"illustrate/{path}": data for path, data in sorted(files.items())}
    return write_zip(folder / name, {"illustrate/": b"", **inside})


def main() -> None:
    """Makes all of them and says how large they are."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--platform", choices=PLATFORMS, required=True)
    parser.add_argument("--installed", type=Path, required=True, help="illustrate_native, built")
    parser.add_argument("--out", type=Path, default=ROOT / "dist")
    arguments = parser.parse_args()
    website = os.environ.get("ILLUSTRATE_WEBSITE", "")
    platform, installed, out = PLATFORMS[arguments.platform], arguments.installed, arguments.out
    wheels = {
        python: make_wheel(platform, installed, python, out / "wheels")
        for python in pythons_of(installed, tuple(sorted({*platform.legacy, *platform.pythons})))
    }
    inside = [wheels[python] for python in pythons_of(installed, platform.pythons)]
    made = [make_extension(platform, inside, out, website)]
    if platform.legacy:
        made.append(make_legacy(platform, installed, out, website))
    made += wheels.values()
    for path in made:
        print(f"{path.relative_to(out)}: {path.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
