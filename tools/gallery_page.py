"""Writes docs/gallery.md from the scripts of the figures, and copies their pictures there."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAPER = """klein_bottle torus_knot bent_torus directions smooth_corner cylinder_joints drapes
    four_surfaces"""
OWN = """portrait_bust machine vehicle interior plant drapery anatomy map_relief text glass night
    motion_strip"""
MOST_BYTES = 200_000
START = """# Gallery

Every picture is made by the script below it, from formulas or Blender's own primitives:
`make gallery` draws all of them, as `.svg`, `.png` and `.blend`, into `out/gallery`. To look around
in one:

    blender --factory-startup --python examples/gallery.py -- klein_bottle
"""


def section(name: str) -> str:
    """What the page says of one figure: its script's own words."""
    path = ROOT / "examples" / "figures" / f"{name}.py"
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    title, _, words = text.partition(".\n\n")
    parts = [f"## {title}", " ".join(words.split()), f"![{title}](gallery/{name}.png)"]
    return "\n\n".join([*parts, f"`examples/figures/{name}.py`\n"])


def copy_picture(name: str) -> None:
    """Copies the small picture if it was drawn. Raises ValueError when it is too large."""
    drawn = ROOT / "out" / "gallery" / f"{name}.small.png"
    if not drawn.is_file():
        return
    if drawn.stat().st_size > MOST_BYTES:
        raise ValueError(f"{drawn} has {drawn.stat().st_size} bytes: more than {MOST_BYTES}")
    shutil.copyfile(drawn, ROOT / "docs" / "gallery" / f"{name}.png")


def main() -> None:
    """Writes the page."""
    pictures = ROOT / "docs" / "gallery"
    pictures.mkdir(exist_ok=True)
    names = [*PAPER.split(), *OWN.split()]
    for name in names:
        copy_picture(name)
    parts = [section(name) for name in names]
    (ROOT / "docs" / "gallery.md").write_text("\n".join([START, *parts]), encoding="utf-8")


if __name__ == "__main__":
    main()
