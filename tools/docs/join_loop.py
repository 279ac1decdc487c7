"""Joins the pictures of blender_tests/window/live_loop.py to one that moves, an animated PNG.

    build/docs/venv/bin/python tools/docs/join_loop.py out/live-loop docs/pictures/live.png

The pace is that of a view turned by hand; a real window draws its lines at every redraw.
"""

from __future__ import annotations

import sys
from pathlib import Path

from PIL import Image

MOVING_MS, RESTING_MS = 80, 1600
GREYS = 6
DARK, WHITE = 80, 250  # of a line's middle, and what the paper is at least
MOST_BYTES = 200_000


def in_few_greys(picture: Image.Image) -> Image.Image:
    """With lines of full black on paper of full white."""
    steps = GREYS - 1
    shares = [min(max((value - DARK) / (WHITE - DARK), 0), 1) for value in range(256)]
    greys = [round(round(share * steps) * 255 / steps) for share in shares]
    return picture.convert("L").point(greys).quantize(GREYS)


def join(folder: Path, path: Path) -> None:
    """Writes the loop. Raises ValueError: it is too large for a page."""
    names = sorted(folder.glob("?_*.png"))
    pictures = [in_few_greys(Image.open(name)) for name in names]
    times = [RESTING_MS if name.stem.endswith("resting") else MOVING_MS for name in names]
    first, *rest = pictures
    first.save(path, save_all=True, append_images=rest, duration=times, loop=0, optimize=True)
    if path.stat().st_size > MOST_BYTES:
        raise ValueError(f"{path} has {path.stat().st_size} bytes: more than {MOST_BYTES}")


if __name__ == "__main__":
    join(Path(sys.argv[1]), Path(sys.argv[2]))
