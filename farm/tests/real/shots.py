"""Small files to draw, and the command as one machine runs it."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[3]
SCRIPT = ROOT / "build" / "addons" / "illustrate" / "headless.py"
BLENDER = os.environ.get("BLENDER", "blender")


@dataclass(frozen=True)
class Shot:
    """A file to draw."""

    blend: Path
    frames: int

    def names(self, *extensions: str) -> list[str]:
        """Of all files that drawing it makes, sorted."""
        return sorted(
            f"{self.blend.stem}_{frame:04}.{extension}"
            for frame in range(1, self.frames + 1)
            for extension in extensions
        )


def make_shot(folder: Path, kind: str, frames: int) -> Shot:
    """Saves a file of one of the kinds of make_shot.py."""
    shot = Shot(folder / f"{kind}.blend", frames)
    script = str(Path(__file__).parent / "make_shot.py")
    start = [BLENDER, "-b", "--factory-startup", "--python-exit-code", "3", "--python", script]
    run([*start, "--", str(shot.blend), str(frames), kind])
    return shot


def command(blend: Path | None, *arguments: object) -> list[str]:
    """The headless command of a file, as words."""
    opened = [] if blend is None else [str(blend)]
    start = [BLENDER, "-b", *opened, "--python-exit-code", "3", "--python", str(SCRIPT), "--"]
    return [*start, *map(str, arguments)]


def draw(shot: Shot, out: Path, *arguments: object) -> dict[str, bytes]:
    """All frames of a shot, drawn by one command on this machine; the files."""
    run(command(shot.blend, "--out", out, "--frames", f"1-{shot.frames}", *arguments))
    return contents(out)


def run(words: list[str], code: int = 0) -> str:
    """What a program that ends with `code` prints."""
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    assert ran.returncode == code, f"{words}\n{ran.stdout}{ran.stderr}"
    return ran.stdout + ran.stderr


def contents(out: Path) -> dict[str, bytes]:
    """The files of a folder, also those whose names begin with a dot."""
    return {path.name: path.read_bytes() for path in out.iterdir() if path.is_file()}
