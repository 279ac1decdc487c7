"""How much holds still while the camera turns by a degree a frame: ours, Line Art and Freestyle.

One JSON line for each shape and method: alone (each frame by itself) and as a sequence, hatches and
lines apart; with --peers the lines of Blender's Line Art and Freestyle on the same surface and
cameras, where the program Blender is found (in $BLENDER, or called blender). `steady`: share of
what is seen in both frames that is drawn within a quarter of a spacing; `turned`: share with
nothing but lines across within 3/4; `births`, `deaths`: strokes longer than two spacings that come
or go at once, for each 1000 spacings; `chamfer`: weighted Chamfer distance, in spacings; `draw_s`:
seconds a frame. Exact curves on the surface move with it; silhouettes slide, and are `steady` where
they slide less than a quarter of a spacing.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path

import illustrate_native as ill
import numpy as np
from bench_pipeline import camera, sphere, torus
from motion import Doubles, Eye, Samples, compare, samples_of, strokes_of

HATCHES = (ill.Kind.HATCH, ill.Kind.CROSS_HATCH)
LINES = (ill.Kind.SILHOUETTE, ill.Kind.BOUNDARY, ill.Kind.CREASE, ill.Kind.INTERSECTION)
SIZE_PX = 1024
ROOT = Path(__file__).resolve().parents[2]


def dented() -> tuple[Doubles, np.ndarray]:
    """A sphere with dents: singularities, seams of families, folds."""
    points, quads = sphere(16)
    x, y, z = points.T
    radius = 1 + 0.15 * np.sin(3 * x + 1) * np.cos(4 * y) + 0.1 * np.sin(5 * z)
    return points * radius[:, None], quads


SHAPES = {"torus": lambda: torus(16, 32), "dented": dented}


def orbit(frames: int, degrees: float) -> list[ill.Camera]:
    """Cameras round the z axis."""
    cameras = []
    for k in range(frames):
        turn, view = np.radians(30 + k * degrees), np.eye(4)
        view[:2, :2] = [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]
        still = camera(SIZE_PX, SIZE_PX)
        cameras.append(ill.Camera(still.projection, still.view @ view, SIZE_PX, SIZE_PX))
    return cameras


def means(rows: Iterable[dict[str, float]]) -> dict[str, float]:
    """Of each measure, over the pairs of frames."""
    found = list(rows)
    return {name: round(float(np.mean([row[name] for row in found])), 5) for name in found[0]}


def measure(frames: list[list[Doubles]], eyes: list[Eye], spacing_px: float) -> dict[str, float]:
    """frames: world points of the strokes of each."""
    samples: list[Samples] = [samples_of(f, eye) for f, eye in zip(frames, eyes, strict=True)]
    return means(
        compare(samples[k], samples[k + 1], eyes[k], eyes[k + 1], spacing_px)
        for k in range(len(samples) - 1)
    )


def ours(
    prepared: ill.Prepared, cameras: list[ill.Camera], eyes: list[Eye], follows: bool
) -> dict[str, object]:
    """Our drawings, each alone or after the one before."""
    options = ill.DrawOptions()
    drawings: list[ill.Drawing] = []
    ill.draw(prepared, cameras[0], options)  # what is made once for all views
    start = time.perf_counter()
    for view in cameras:
        previous = drawings[-1] if follows and drawings else None
        drawings.append(ill.draw(prepared, view, options, previous=previous))
    seconds = (time.perf_counter() - start) / len(cameras)
    told: dict[str, object] = {"draw_s": round(seconds, 3)}
    for name, kinds in {"hatches": HATCHES, "lines": LINES}.items():
        frames = [strokes_of(drawing, kinds) for drawing in drawings]
        told[name] = measure(frames, eyes, options.spacing_px)
    return told


def peers(prepared: ill.Prepared, cameras: list[ill.Camera], eyes: list[Eye]) -> dict[str, object]:
    """Line Art and Freestyle, by method."""
    program = shutil.which(os.environ.get("BLENDER", "blender"))
    if program is None:
        return {}
    spacing, script = ill.DrawOptions().spacing_px, ROOT / "examples" / "peers_in_blender.py"
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder, "scene.npz"), Path(folder, "strokes.json")
        np.savez(given, positions=prepared.surface.positions, triangles=prepared.surface.triangles,
                 views=[c.view for c in cameras],
                 projection=cameras[0].projection, size=SIZE_PX)  # fmt: skip
        command = [program, "-b", "--factory-startup", "--python-exit-code", "1", "--python",
                   str(script), "--", str(given), str(found)]  # fmt: skip
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        told = json.loads(found.read_text())
    return {
        method: {
            "lines": measure([[np.array(s) for s in frame] for frame in frames], eyes, spacing)
        }
        for method, frames in told.items()
    }


def main() -> None:
    """Prints one line for each shape and method."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--degrees", type=float, default=1.0)
    parser.add_argument("--level", type=int, default=3)
    parser.add_argument("--peers", action="store_true", help="Line Art and Freestyle as well")
    chosen, _ = parser.parse_known_args()
    for name, shape in SHAPES.items():
        points, quads = shape()
        options = ill.PrepareOptions()
        options.level = chosen.level
        mesh = ill.PolygonMesh(points, np.full(len(quads), 4), quads.ravel(), name=name)
        prepared = ill.prepare([mesh], options)
        cameras = orbit(chosen.frames, chosen.degrees)
        surface = prepared.surface
        eyes = [Eye(view, surface.positions, surface.triangles) for view in cameras]
        rows: dict[str, object] = {
            "alone": ours(prepared, cameras, eyes, False),
            "sequence": ours(prepared, cameras, eyes, True),
        }
        if chosen.peers:
            rows |= peers(prepared, cameras, eyes)
        for method, row in rows.items():
            print(json.dumps({"shape": name, "method": method, **dict(row)}), flush=True)  # type: ignore[call-overload]


if __name__ == "__main__":
    main()
