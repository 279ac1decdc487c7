"""What the pages show in Python runs."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from shapes import look_at, sphere, torus

ROOT = Path(__file__).resolve().parents[3]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
SNIPPETS = {
    f"{page.name} {number}": found
    for page in PAGES
    for number, found in enumerate(BLOCK.findall(page.read_text(encoding="utf-8")), 1)
    if "import bpy" not in found
}
STAGES = ("mesh", "control", "surface", "field", "contour", "visibility", "tone", "hatch", "stroke")


@cache
def names() -> dict[str, Any]:
    """What snippets take as given."""
    ball, camera = sphere(), look_at()
    prepared = ill.prepare([torus().mesh()])  # it has all kinds of nodes, and layers behind others
    turn = np.linspace(0, 1, 9)
    return {
        "ill": ill,
        "np": np,
        "positions": ball.positions,
        "face_sizes": ball.face_sizes,
        "corner_vertices": ball.corner_vertices,
        "normals": ball.positions[ball.corner_vertices],
        "mesh": ball.mesh(),
        "meshes": [ball.mesh()],
        "stroke": np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1),
        "projection": camera.projection,
        "view": camera.view,
        "camera": camera,
        "cameras": [camera, camera],
        "kept": True,
        "prepared": prepared,
        "drawing": ill.draw(prepared, camera),
    }


@pytest.mark.parametrize("name", SNIPPETS)
def test_snippets_run(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    before = names()
    after = dict(before)
    exec(compile(SNIPPETS[name], name, "exec"), after)
    made = {key: after[key] for key in after if key not in before}
    for key, value in made.items():
        if isinstance(value, np.ndarray | list | tuple):
            assert len(value), f"{key} is empty: the snippet shows nothing"


def test_each_stage_is_shown_in_python() -> None:
    assert {f"{stage}.md 1" for stage in STAGES} <= set(SNIPPETS)
