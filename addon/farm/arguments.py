"""The command lines of the headless command."""

import argparse
import pathlib
import re
from typing import Any

from ..output.files import FORMATS, PLOT_FORMATS
from .lines import PROGRESS

PROGRAM = "illustrate"
MERGE = "merge"
ALL_FORMATS = (*FORMATS, *PLOT_FORMATS)
ORDERS = ("shortest", "drawing", "wet")
SEQUENCES = ("pdf", "svg")
_PART = re.compile(r"(-?\d+)(?:-(-?\d+)(?:[x:](\d+))?)?")


def parse(arguments: list[str]) -> Any:
    """What the command line asks to be drawn. Raises SystemExit for a wrong one."""
    parser = _draw_parser()
    chosen = parser.parse_args(arguments)
    if len(chosen.frames or ()) > 1 and "#" not in chosen.name:
        parser.error(
            f"--name {chosen.name} is one name for {len(chosen.frames)} frames: "
            "put #### for the frame's number"
        )
    if chosen.sequence and chosen.skip_existing:
        parser.error("--sequence draws all frames: leave out --skip-existing")
    return chosen


def parse_merge(arguments: list[str]) -> Any:
    """What the command line asks to be merged: out, into, begun_from, frames, partial."""
    parser = argparse.ArgumentParser(
        prog=f"{PROGRAM} {MERGE}",
        description="Makes keyframes of the JSON files of drawn frames.",
    )
    parser.add_argument("out", metavar="OUT", help="the folder that the frames were written to")
    parser.add_argument(
        "--into", required=True, metavar="FILE.blend", help="the file that gets the keyframes"
    )
    parser.add_argument(
        "--from",
        dest="begun_from",
        metavar="FILE.blend",
        help="the file that it begins as where it is not there yet, such as the one drawn",
    )
    _add_frames(parser, "which frames must be there; those from the first to the last if left out")
    parser.add_argument(
        "--partial",
        action="store_true",
        help="merge what is whole and of the same settings, though some is not",
    )
    return parser.parse_args(arguments)


def _draw_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog=PROGRAM,
        description="Illustrates frames of a scene and writes the drawings to files.",
        epilog=f"{PROGRAM} {MERGE} --help tells how their JSON files become keyframes.",
    )
    parser.add_argument("blend", nargs="?", help="the file to open; the open one when left out")
    _add_frames(parser, "which frames; the scene's current one when left out")
    _add_files(parser)
    _add_look(parser)
    _add_plot(parser)
    _add_sequence(parser)
    return parser


def _add_frames(parser: argparse.ArgumentParser, words: str) -> None:
    parser.add_argument("--frames", type=frames, metavar="1-20x2,30", help=words)


def _add_files(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", required=True, metavar="DIR", help="the folder to write to")
    parser.add_argument("--format", type=_formats, default=["svg"], metavar=",".join(ALL_FORMATS))
    parser.add_argument(
        "--name",
        type=_name,
        default="FILE_####",
        help="what files are called: FILE is the .blend, # the frame's number",
    )
    parser.add_argument(
        "--skip-existing",
        action="store_true",
        help="leave frames whose files are whole, of the same settings and version",
    )


def _add_look(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--width-mm",
        type=_millimetres,
        help="the width of the page of an SVG; that of the scene's settings when left out",
    )
    parser.add_argument(
        "--preset", metavar="NAME", help="settings to draw with in place of the scene's own"
    )
    tone = parser.add_mutually_exclusive_group()
    tone.add_argument(
        "--tone-from",
        choices=("lights", "render"),
        help="what says how dark the hatching is; as the scene's settings say when left out",
    )
    tone.add_argument(
        "--tone-image",
        metavar="FILE",
        help="an image that says how dark it is; #### for the frame's number of a sequence",
    )
    parser.add_argument(
        "--svg-style",
        choices=("centerline", "tapered"),
        default="centerline",
        help="paths along the strokes, or outlines as wide as they are",
    )


def _add_plot(parser: argparse.ArgumentParser) -> None:
    plot = parser.add_argument_group("plots", "PDF and DXF are plots; SVG with one of these is")
    plot.add_argument(
        "--plot", metavar="NAME", help='a preset of plots, or "scene": the scene\'s own settings'
    )
    plot.add_argument("--page", metavar="A4", help="paper: a format, or such as 150x100 (mm)")
    plot.add_argument("--scale", type=_scale, metavar="1:50", help="of parallel cameras")
    plot.add_argument(
        "--masks",
        action="store_true",
        help="an image of where each object and material is seen, beside the frame's other files",
    )
    plot.add_argument("--order", choices=ORDERS, help="which stroke is drawn next")
    plot.add_argument(
        "--sequence",
        type=_sequences,
        default=[],
        metavar="pdf,svg",
        help="all frames in one file, too: pages of a PDF, an animated SVG",
    )


def _add_sequence(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--warm-up",
        type=_count,
        default=0,
        metavar="N",
        help="where strokes follow the frame before, draw N frames before the first, unwritten",
    )
    parser.add_argument(
        "--expose-as",
        type=int,
        metavar="FRAME",
        help="draw this frame first, unwritten: the light is as strong in all frames",
    )
    parser.add_argument(
        "--progress", choices=PROGRESS, default="plain", help="how progress is printed"
    )


def frames(text: str) -> list[int]:
    """'1', '1-10', '1-20x2' (every second; 1-20:2 says the same) or '1-20x2,30' as numbers."""
    numbers: list[int] = []
    for part in text.split(","):
        found = _PART.fullmatch(part.strip())
        if found is None:
            raise argparse.ArgumentTypeError(f"{part!r} is no frame and no range")
        first, last, step = int(found[1]), int(found[2] or found[1]), int(found[3] or 1)
        if last < first:
            raise argparse.ArgumentTypeError(f"{part!r} ends before it begins")
        if not step:
            raise argparse.ArgumentTypeError(f"{part!r} never ends: its step is 0")
        numbers.extend(range(first, last + 1, step))
    return list(dict.fromkeys(numbers))


def _count(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is no number of frames")
    return int(text)


def _name(text: str) -> str:
    if not text or pathlib.PurePath(text).name != text:
        raise argparse.ArgumentTypeError(f"{text!r} is not the name of a file")
    return text


def _formats(text: str) -> list[str]:
    return _names_among(text, ALL_FORMATS)


def _sequences(text: str) -> list[str]:
    return _names_among(text, SEQUENCES)


def _names_among(text: str, known: tuple[str, ...]) -> list[str]:
    names = text.split(",")
    for name in names:
        if name not in known:
            raise argparse.ArgumentTypeError(f"{name!r} is not one of {', '.join(known)}")
    return names


def _scale(text: str) -> float:
    """The number after '1:'."""
    try:
        return _millimetres(text.removeprefix("1:"))
    except argparse.ArgumentTypeError as error:
        raise argparse.ArgumentTypeError(f"{text!r} is no scale such as 1:50") from error


def _millimetres(text: str) -> float:
    try:
        width = float(text)
    except ValueError:
        width = 0.0
    if not 0 < width < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is no width in millimetres")
    return width
