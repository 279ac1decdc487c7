"""The pictures of the stages' pages, drawn by the module itself.

.venv/bin/python tools/docs/stage_pictures.py [--out docs/pictures/stages]
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
from illustrate_native import debug, svg
from sketch import beside
from views import ROOT, View, formulas, look_at, mesh, ring_and_ball

Pictures = dict[str, str]


def drawn(view: View) -> str:
    """The finished drawing."""
    camera = view.camera
    return svg.to_svg(view.drawn()[1], camera.width_px, camera.height_px, style="tapered")


def mesh_picture() -> str:
    """A surface without an inside, one mesh of faces that cannot agree on a side."""
    positions, faces = formulas.klein_bottle(64, 20)
    centre = tuple(((positions.min(axis=0) + positions.max(axis=0)) / 2).tolist())
    camera = look_at((0.6, -2.0, 0.5), 3.6, centre, (400, 300))
    view = View([mesh(positions, faces)], camera, {"level": 1}, {"spacing_px": 9.0})
    return drawn(view)


def nut(cage: bool, crease_angle_deg: float = 180.0) -> ill.PolygonMesh:
    """A prism of eight sides, shaded round at its sides and flat on top and below."""
    angle = 2 * np.pi * np.arange(8) / 8
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    positions = np.concatenate([np.column_stack([ring, np.full(8, z)]) for z in (-0.7, 0.7)])
    k = np.arange(8)
    sides = np.stack([k, (k + 1) % 8, (k + 1) % 8 + 8, k + 8], axis=1)
    corners = np.concatenate([sides.ravel(), k[::-1], k + 8])
    outward = np.column_stack([ring, np.zeros(8)])
    normals = np.concatenate(
        [outward[sides.ravel() % 8], np.tile([0, 0, -1.0], (8, 1)), np.tile([0, 0, 1.0], (8, 1))]
    )
    return ill.PolygonMesh(
        positions,
        [4] * 8 + [8, 8],
        corners,
        corner_normals=None if cage else normals,
        cage=cage,
        crease_angle_deg=crease_angle_deg,
    )


def control_picture() -> str:
    """What is drawn of one mesh: its polygons, the limit of a cage, a surface that keeps to it."""
    camera = look_at((1.0, -2.2, 1.1), 1.45, size_px=(300, 260))
    ways = (("its polygons", True, "none"), ("as a cage", True, "auto"), ("kept to", False, "auto"))
    return beside(
        (
            caption,
            drawn(
                View(
                    [nut(cage, 30 if scheme == "none" else 180)],
                    camera,
                    {"scheme": scheme},
                    {"spacing_px": 8.0},
                )
            ),
        )
        for caption, cage, scheme in ways
    )


def surface_picture() -> str:
    """One cage at levels of subdivision, and what is drawn of it."""
    cage = mesh(*formulas.torus(1.0, 0.5, 9, 5))
    camera = look_at((1.0, -2.2, 1.3), 1.6, size_px=(300, 200))
    panels = []
    for caption, options in (
        ("the cage", {"scheme": "none"}),
        ("level 1", {"level": 1}),
        ("level 2", {"level": 2}),
    ):
        view = View([cage], camera, options, {"hatching": False})
        prepared, drawing = view.drawn()
        found = debug.pictures(prepared, drawing, camera, ["surface"])["surface"]
        panels.append((caption, found))
    panels.append(("drawn", drawn(View([cage], camera, {}, {"spacing_px": 8.0}))))
    return beside(panels, 220)


def occlusion_picture() -> str:
    """A crowd, of which most is hidden."""
    positions, faces = formulas.sphere(0.5, 4)
    places = np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    balls = [mesh(positions + place, faces) for place in places]
    camera = look_at((1.0, -2.0, 0.7), 2.1, (1.0, 1.0, 1.0), (360, 330))
    view = View(balls, camera, {"level": 1}, {"hatching": False, "hidden_lines": (1, 20)})
    prepared, drawing = view.drawn()
    found = debug.pictures(prepared, drawing, camera, ["visibility"])["visibility"]
    view.draw = {"spacing_px": 7.0}
    return beside([("layers in front", found), ("drawn", drawn(view))], 360)


def of_one_view() -> Pictures:
    """The stages of one view: a ball that pierces a ring."""
    view = ring_and_ball(spacing_px=9.0)
    prepared, drawing = view.drawn()
    made = debug.pictures(prepared, drawing, view.camera)
    finished = svg.to_svg(drawing, *size_of(view), style="tapered")
    return {
        "contour": made["contour"],
        "visibility": beside([("layers in front", made["visibility"]), ("drawn", finished)], 360),
        "tone": made["tone"],
        "hatch": beside(
            [("curves on the surface", made["curves"]), ("hatches", made["hatch"])], 360
        ),
        "stroke": made["stroke"],
    }


def size_of(view: View) -> tuple[int, int]:
    """Of the picture, px."""
    return view.camera.width_px, view.camera.height_px


ALONE: dict[str, Callable[[], str]] = {
    "mesh": mesh_picture,
    "control": control_picture,
    "surface": surface_picture,
    "occlusion": occlusion_picture,
}


def main() -> None:
    """Writes every picture."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "pictures" / "stages")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    made: dict[str, Any] = {name: draw() for name, draw in ALONE.items()} | of_one_view()
    for name, text in made.items():
        (folder / f"{name}.svg").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
