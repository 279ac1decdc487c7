"""Builds the figures of the gallery and draws them without a window, or leaves one open.

    blender -b --factory-startup --python-exit-code 3 --python examples/gallery.py -- [ARGUMENTS]
    blender --factory-startup --python examples/gallery.py -- FIGURE        (to look around in it)
    python examples/gallery.py [ARGUMENTS]         (a Python that has the module bpy)

ARGUMENTS: [--out DIR] [FIGURE ...]; a figure is a file of examples/figures.

Each leaves an .svg, a .png and a .blend in DIR (out/gallery), of several panels those of each, and
a .small.png for a page, of all panels side by side.
"""

import argparse
import importlib
import pathlib
import sys
from types import ModuleType
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "examples"))

import bpy  # noqa: E402
import demo  # noqa: E402
import numpy as np  # noqa: E402
import small_png  # noqa: E402

WIDTH_PX, ROW_WIDTH_PX = 900, 1600  # of small pictures: one panel, several

FIGURES = sorted(path.stem for path in (ROOT / "examples" / "figures").glob("[!_]*.py"))


def build(figure: ModuleType) -> Any:
    """Empties the open file and builds the figure in it; the scene."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    figure.build()
    return bpy.context.scene


def draw(headless: ModuleType, figure: ModuleType, name: str, out: str) -> int:
    """Draws all panels of a figure; the exit code."""
    code = 0
    panels: tuple[dict[str, Any], ...] = getattr(figure, "PANELS", ({},))
    names = [name if len(panels) == 1 else f"{name}-{letter}" for letter in "abcdefgh"]
    for panel, changes in zip(names, panels, strict=False):
        scene = build(figure)
        for setting, value in changes.items():
            owner = scene if setting == "frame_current" else scene.illustrate
            setattr(owner, setting, value)
        frame = str(scene.frame_current)
        command = ["--out", out, "--format", "svg,png,blend", "--frames", frame, "--name", panel]
        code |= headless.main(command)
    if not code:
        rows = [read_grey(pathlib.Path(out, f"{panel}.png")) for panel in names[: len(panels)]]
        width = WIDTH_PX if len(panels) == 1 else ROW_WIDTH_PX
        small = small_png.shrunk(np.concatenate(rows, axis=1), width)
        small_png.write(pathlib.Path(out, f"{name}.small.png"), small)
    return code


def read_grey(path: pathlib.Path) -> Any:
    """The rows of a picture, the top one first; grey in [0, 1]."""
    image = bpy.data.images.load(str(path))
    pixels = np.empty(4 * image.size[0] * image.size[1], np.float32)
    image.pixels.foreach_get(pixels)
    rows = pixels.reshape(image.size[1], image.size[0], 4)[::-1]
    return rows[..., :3].mean(axis=-1)


def main(headless: ModuleType) -> int:
    """Draws what the command line names; the exit code."""
    parser = argparse.ArgumentParser(prog="gallery.py", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--out", default=str(ROOT / "out" / "gallery"), metavar="DIR")
    parser.add_argument("figures", nargs="*", metavar="FIGURE", default=[])
    chosen = parser.parse_args(headless.own_arguments())
    for name in chosen.figures:
        if name not in FIGURES:
            parser.error(f"there is no figure {name}, only {', '.join(FIGURES)}")
    headless.find_package()
    code = 0
    for name in chosen.figures or FIGURES:
        figure = importlib.import_module(f"figures.{name}")
        if not bpy.app.background:
            build(figure)
            return 0
        code |= draw(headless, figure, name, chosen.out)
    return code


if __name__ == "__main__":
    command = demo.load_headless()
    command.leave(main(command))
