"""Illustrates frames of a scene without a window and writes the drawings to files.

    blender -b FILE.blend --python-exit-code 3 --python headless.py -- --out DIR [options]
    blender -b FILE.blend --command illustrate --out DIR [options]       (the extension, 4.2 on)
    python headless.py FILE.blend --out DIR [options]          (a Python that has the module bpy)

A file is called as the .blend and its frame, such as scene_0001.svg; it appears whole or not at
all. Nothing outside DIR is written. The exit code is 0 when every file was written.
"""

import argparse
import atexit
import importlib
import os
import pathlib
import re
import sys
import time
import traceback
from types import ModuleType
from typing import Any

import bpy

PACKAGE = "illustrate"


def main(arguments: list[str], summaries: list[str] | None = None) -> int:
    """Does what the command line asks for; the exit code. `summaries` gets a line per frame."""
    chosen = parse(arguments)
    package = find_package()
    messages = _part(package, "messages")
    try:
        if chosen.blend:
            _open(chosen.blend, messages)
        if chosen.preset:
            _part(package, "ui.presets").apply(chosen.preset)
        _part(package, "output.files").prepare_folder(chosen.out)
        first = None
        for frame in chosen.frames or [bpy.context.scene.frame_current]:
            bpy.context.scene.frame_set(frame)
            name = file_name(chosen.name, frame)
            made, line = illustrate_frame(package, name, chosen, first)
            first = first or made.drawing
            print(line, flush=True)
            if summaries is not None:
                summaries.append(line)
    except messages.IllustrateError as error:
        print(f"illustrate: error: {error}", file=sys.stderr, flush=True)
        return 1
    return 0


def file_name(pattern: str, frame: int) -> str:
    """The pattern with the open file's name for FILE and the frame's number, padded, for ####."""
    name = pattern.replace("FILE", pathlib.Path(bpy.data.filepath).stem or "untitled")
    return re.sub("#+", lambda marks: f"{frame:0{len(marks[0])}}", name)


def illustrate_frame(package: ModuleType, name: str, chosen: Any, first: Any) -> tuple[Any, str]:
    """Illustrates the scene at its frame and writes `name` in every format.

    package: the add-on. chosen: what `parse` returns. first: the drawing of the first frame, as
    which this one is exposed, or None. Returns the illustration and a line that sums it up.
    Raises the add-on's IllustrateError.
    """
    files = _part(package, "output.files")
    scene, start = bpy.context.scene, time.perf_counter()
    made = _part(package, "illustration").illustrate(
        scene, bpy.context.evaluated_depsgraph_get(), _ProgressLines(name), first
    )
    for warning in made.warnings:
        print(f"illustrate: warning: {warning}", file=sys.stderr, flush=True)
    drawn = time.perf_counter()
    strokes = _part(package, "output").write_drawing(
        scene, made.drawing, made.arrays.camera, scene.illustrate.output, made.names
    )
    page = files.Page(
        scene,
        made.drawing,
        made.arrays.camera,
        made.names,
        strokes,
        chosen.width_mm or scene.illustrate.page_width_mm,
        chosen.svg_style,
    )
    made.seconds["strokes"] = time.perf_counter() - drawn
    for extension in chosen.format:
        begun = time.perf_counter()
        files.write_file(os.path.join(chosen.out, f"{name}.{extension}"), page)
        made.seconds[extension] = time.perf_counter() - begun
    return made, summary(package, name, made, time.perf_counter() - start)


def summary(package: ModuleType, name: str, made: Any, seconds: float) -> str:
    """One line: strokes by kind, seconds per stage."""
    groups = _part(package, "native").load_part("line_groups").line_groups(made.drawing)
    strokes = ", ".join(f"{len(group.strokes)} {group.title}" for group in reversed(groups))
    stages = ", ".join(f"{stage} {spent:.2f}" for stage, spent in made.seconds.items())
    return (
        f"{name}: {len(made.drawing.kinds)} strokes ({strokes or 'none'}) "
        f"in {seconds:.2f} s ({stages})"
    )


class _ProgressLines:
    """Says which stage a drawing has come to."""

    def __init__(self, name: str) -> None:
        self.name, self.stage = name, ""

    def __call__(self, fraction: float, stage: str) -> bool:
        """Prints a line when the stage changes; never stops the work."""
        if stage != self.stage:
            self.stage = stage
            print(f"{self.name}: {100 * fraction:3.0f} % {stage}", flush=True)
        return True


def find_package() -> ModuleType:
    """The add-on, registered: that of this Blender, else the one this file is in or was built from.

    In a module what was registered here is taken back when Python ends. Raises ModuleNotFoundError
    when there is none.
    """
    registered = _registered()
    if registered is not None:
        return importlib.import_module(registered.__module__.rpartition(".")[0])
    here = pathlib.Path(__file__).resolve().parent
    folder = here.parent if here.name == PACKAGE else here.parent / "build" / "addons"
    if (folder / PACKAGE).is_dir():
        sys.path.insert(0, str(folder))
    package = importlib.import_module(PACKAGE)
    package.register()
    if is_module():
        atexit.register(_unregister, package)
    return package


def _registered() -> Any:
    """The operator of the add-on that is registered, or None."""
    return getattr(bpy.types, "ILLUSTRATE_OT_illustrate", None)


def _unregister(package: ModuleType) -> None:
    if _registered() is not None:
        package.unregister()


def _part(package: ModuleType, name: str) -> Any:
    """A module of the add-on, under whatever name it is installed."""
    return importlib.import_module(f"{package.__name__}.{name}")


def _open(path: str, messages: Any) -> None:
    try:
        bpy.ops.wm.open_mainfile(filepath=os.path.abspath(path))
    except RuntimeError as error:
        raise messages.IllustrateError(f'"{path}" cannot be opened: {error}') from error


def parse(arguments: list[str]) -> Any:
    """What the command line asks for: blend, frames, out, format, name, width_mm, svg_style."""
    parser = _parser()
    chosen = parser.parse_args(arguments)
    if len(chosen.frames or ()) > 1 and "#" not in chosen.name:
        parser.error(
            f"--name {chosen.name} is one name for {len(chosen.frames)} frames: "
            "put #### for the frame's number"
        )
    return chosen


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=PACKAGE, description=(__doc__ or "").split("\n")[0])
    parser.add_argument("blend", nargs="?", help="the file to open; the open one when left out")
    parser.add_argument(
        "--frames",
        type=_frames,
        metavar="1,3,5-10",
        help="which frames; the scene's current one when left out",
    )
    parser.add_argument("--out", required=True, metavar="DIR", help="the folder to write to")
    parser.add_argument("--format", type=_formats, default=["svg"], metavar="svg,png,json,blend")
    parser.add_argument(
        "--name",
        type=_name,
        default="FILE_####",
        help="what files are called: FILE is the .blend, # the frame's number",
    )
    parser.add_argument(
        "--width-mm",
        type=_millimetres,
        help="the width of the page of an SVG; that of the scene's settings when left out",
    )
    parser.add_argument(
        "--preset", metavar="NAME", help="settings to draw with in place of the scene's own"
    )
    parser.add_argument(
        "--svg-style",
        choices=("centerline", "tapered"),
        default="centerline",
        help="paths along the strokes, or outlines as wide as they are",
    )
    return parser


def _frames(text: str) -> list[int]:
    """'1', '1-10' or '1,3,5-10' as numbers."""
    frames: list[int] = []
    for part in text.split(","):
        first, dash, last = part.partition("-")
        try:
            numbers = range(int(first), int(last if dash else first) + 1)
        except ValueError as error:
            raise argparse.ArgumentTypeError(f"{part!r} is no frame and no range") from error
        if not numbers:
            raise argparse.ArgumentTypeError(f"{part!r} ends before it begins")
        frames.extend(numbers)
    return frames


def _name(text: str) -> str:
    if not text or pathlib.PurePath(text).name != text:
        raise argparse.ArgumentTypeError(f"{text!r} is not the name of a file")
    return text


def _formats(text: str) -> list[str]:
    formats = text.split(",")
    for name in formats:
        if name not in ("svg", "png", "json", "blend"):
            raise argparse.ArgumentTypeError(f"{name!r} is not one of svg, png, json, blend")
    return formats


def _millimetres(text: str) -> float:
    try:
        width = float(text)
    except ValueError:
        width = 0.0
    if not 0 < width < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is no width in millimetres")
    return width


def own_arguments() -> list[str]:
    """What stands after -- on the command line of Blender, or after the name of a Python script."""
    if "--" in sys.argv:
        return sys.argv[sys.argv.index("--") + 1 :]
    return sys.argv[1:] if is_module() else []


def is_module() -> bool:
    """True in a Python that has Blender as a module, not in the program."""
    return not bpy.app.binary_path


def leave(code: int) -> None:
    """Ends the process when there is something to say, or when Blender is a module.

    A script in a module calls it last: up to 4.5 the module hangs or crashes at its own end while a
    class is registered, whoever's it is, and 4.2 also after one that was (docs/addon.md).
    """
    sys.stdout.flush()
    sys.stderr.flush()
    if is_module():
        os._exit(code)
    if code:
        sys.exit(code)


def run() -> int:
    """`main` with the command line; in a module, the exit code of an exception that it let pass."""
    try:
        return main(own_arguments())
    except Exception:
        if not is_module():
            raise
        traceback.print_exc()
        return 3


if __name__ == "__main__":
    leave(run())
