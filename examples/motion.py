"""Pictures of a drawn sequence.

    python examples/motion.py FOLDER NAME [--fps 12]

FOLDER has the JSON files of frames drawn one after another, as by illustrate --frames 1-12 --format
json. Beside it are written
    NAME.svg            the frames as one animated drawing
    NAME_sheet.png      all frames, small
    NAME_flicker.png    what changed that did not move: the frames in which most does, each with the
                        strokes that lived on in grey, born ones red, those that died blue, and
                        orange where a stroke grew
Needs numpy only, besides illustrate_native.
"""

import argparse
import pathlib
import re
from itertools import pairwise
from typing import Any

import illustrate_native as ill
import numpy as np
from illustrate_native import svg
from illustrate_native.drawing_json import StoredDrawing, from_json
from raster import write_png

SHEET_PX, COLUMNS = 320, 4
FLICKER_PX, SHOWN = 700, 4
GREY, RED, BLUE, ORANGE = (190, 190, 190), (214, 39, 40), (31, 119, 230), (240, 140, 0)
GROWN_PX = 4.0  # a stroke's end may creep so far
NAMES = re.compile(r'id="[^"]*" inkscape:groupmode="layer" inkscape:label="[^"]*" ')


def main() -> None:
    """Reads the frames and writes the pictures."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("name")
    parser.add_argument("--fps", type=float, default=12)
    chosen = parser.parse_args()
    frames = [from_json(p.read_text("utf-8")) for p in sorted(chosen.folder.glob("*.json"))]
    if not frames:
        parser.error(f"there are no JSON files in {chosen.folder}")
    place = chosen.folder.parent
    (place / f"{chosen.name}.svg").write_text(animated(frames, chosen.fps), encoding="utf-8")
    write_png(place / f"{chosen.name}_sheet.png", sheet(frames)[..., :3])
    write_png(place / f"{chosen.name}_flicker.png", flicker(frames)[..., :3])
    for name, share in changes(frames).items():
        print(f"{chosen.name}: {share:.2f} % of the length of strokes {name} from frame to frame")


def animated(frames: list[StoredDrawing], fps: float) -> str:
    """All frames in one SVG, each shown in its turn."""
    pages = [svg.to_svg(frame, frame.width_px, frame.height_px) for frame in frames]
    head, _, _ = pages[0].partition("<g ")
    seconds, groups = len(pages) / fps, []
    for number, page in enumerate(pages):
        body = NAMES.sub("", page[page.index("<g ") : page.rindex("</svg>")])
        times = f"0;{number / len(pages):.5f};{(number + 1) / len(pages):.5f}"
        groups.append(
            f'<g display="none"><animate attributeName="display" calcMode="discrete" '
            f'values="none;inline;none" keyTimes="{times}" dur="{seconds:.3f}s" '
            f'repeatCount="indefinite"/>\n{body}</g>'
        )
    return "\n".join([head.rstrip(), *groups, "</svg>", ""])


def sheet(frames: list[StoredDrawing]) -> Any:
    """(h, w, 4) all frames in rows."""
    return tiles([picture(frame, SHEET_PX) for frame in frames], COLUMNS)


def flicker(frames: list[StoredDrawing]) -> Any:
    """(h, w, 4) the frames of most change, in their order."""
    lengths = [_changed(a, b) for a, b in pairwise(frames)]
    worst = sorted(np.argsort(lengths, kind="stable")[::-1][:SHOWN].tolist())
    return tiles([compared(frames[k], frames[k + 1]) for k in worst], 2)


def changes(frames: list[StoredDrawing]) -> dict[str, float]:
    """Per cent of the length of strokes that are born and that die, over all pairs of frames."""
    born = died = total = 0.0
    for last, now in pairwise(frames):
        born += lengths_of(now)[~np.isin(now.stroke_ids, last.stroke_ids)].sum()
        died += lengths_of(last)[~np.isin(last.stroke_ids, now.stroke_ids)].sum()
        total += lengths_of(now).sum()
    return {"is born": 100 * born / max(total, 1e-9), "dies": 100 * died / max(total, 1e-9)}


def _changed(last: StoredDrawing, now: StoredDrawing) -> float:
    return sum(changes([last, now]).values())


def lengths_of(drawing: StoredDrawing) -> Any:
    """(s,) px."""
    steps = np.linalg.norm(np.diff(drawing.image, axis=0, append=0), axis=1)
    steps[drawing.offsets[1:] - 1] = 0
    return (
        np.add.reduceat(np.r_[steps, 0], drawing.offsets[:-1]) if len(drawing.kinds) else steps[:0]
    )


def picture(drawing: StoredDrawing, width_px: int, colours: Any = None) -> Any:
    """(h, w, 4) a drawing of that width; colours: (s, 4), black where left out."""
    scale = width_px / drawing.width_px
    if colours is None:
        colours = np.tile(np.array([0, 0, 0, 255], np.uint8), (len(drawing.kinds), 1))
    height_px = round(drawing.height_px * scale)
    widths = np.maximum(drawing.widths * scale, 0.6)
    return ill.rasterise(
        drawing.image * scale, widths, drawing.offsets, drawing.closed, colours, width_px, height_px
    )


def compared(last: StoredDrawing, now: StoredDrawing) -> Any:
    """(h, w, 4) what lived on, was born, died and grew."""
    there = [_part(now, s) for s in range(len(now.kinds))]
    before = {int(last.stroke_ids[s]): _part(last, s) for s in range(len(last.kinds))}
    lines: list[tuple[Any, tuple[int, int, int]]] = []
    for number, (image, along) in zip(now.stroke_ids.tolist(), there, strict=True):
        if number not in before:
            lines.append((image, RED))
            continue
        old = before[number][1]
        lines.append((image, GREY))
        ends = along < old[0] - GROWN_PX, along > old[-1] + GROWN_PX
        lines += [(image[grown], ORANGE) for grown in ends]
    died = set(before) - set(now.stroke_ids.tolist())
    lines += [(before[number][0], BLUE) for number in sorted(died)]
    lines = sorted((line for line in lines if len(line[0]) > 1), key=lambda line: line[1] != GREY)
    scale = FLICKER_PX / now.width_px
    image = np.concatenate([line for line, _ in lines]) * scale
    widths = np.concatenate([np.full(len(line), 1.0 if c == GREY else 2.2) for line, c in lines])
    offsets = np.cumsum([0, *(len(line) for line, _ in lines)])
    colours = np.array([(*colour, 255) for _, colour in lines], np.uint8)
    height_px = round(now.height_px * scale)
    closed = np.zeros(len(lines), bool)
    return ill.rasterise(image, widths, offsets, closed, colours, FLICKER_PX, height_px)


def _part(drawing: StoredDrawing, stroke: int) -> tuple[Any, Any]:
    """Points of a stroke in the image, and what each counts as along it."""
    image = drawing.image[drawing.offsets[stroke] : drawing.offsets[stroke + 1]]
    steps = np.linalg.norm(np.diff(image, axis=0), axis=1)
    return image, drawing.stroke_starts[stroke] + np.r_[0, np.cumsum(steps)]


def tiles(pictures: list[Any], columns: int) -> Any:
    """(h, w, 4) pictures of one size in rows, the last filled up with white."""
    if not pictures:
        return np.full((1, 1, 4), 255, np.uint8)
    columns = min(columns, len(pictures))
    blank = np.full_like(pictures[0], 255)
    pictures = pictures + [blank] * (-len(pictures) % columns)
    rows = [pictures[i : i + columns] for i in range(0, len(pictures), columns)]
    return np.concatenate([np.concatenate(row, axis=1) for row in rows])


if __name__ == "__main__":
    main()
