"""Builds the example scenes and illustrates them without a window.

    blender -b --factory-startup --python-exit-code 3 --python examples/demo.py -- [ARGUMENTS]
    python examples/demo.py [ARGUMENTS]            (a Python that has the module bpy)

ARGUMENTS: [--out DIR] [--format FORMATS] [SCENE ...]

Each scene leaves an .svg, a .png and a .blend in DIR (out/demo), those that move the .json of
eight frames in a folder of their own (motion.py makes pictures of them); the run ends with a line
per scene or frame: strokes by kind, seconds per stage.
"""

import argparse
import importlib.util
import pathlib
import sys
from types import ModuleType

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "examples"))

import scenes  # noqa: E402

LINE_WIDTH_PX, FEATURE_WIDTH_PX = 3.0, 2.4  # outlines that hold their own against the hatching


def load_headless() -> ModuleType:
    """The headless command of the add-on, from this checkout."""
    path = ROOT / "addon" / "headless.py"
    spec = importlib.util.spec_from_file_location("illustrate_headless", path)
    if spec is None or spec.loader is None:
        raise ImportError(f"{path} cannot be loaded")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main(headless: ModuleType) -> int:
    """Illustrates what the command line names; the exit code."""
    parser = argparse.ArgumentParser(prog="demo.py", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--out", default=str(ROOT / "out" / "demo"), metavar="DIR")
    parser.add_argument("--format", default="svg,png,blend", help="as the headless command has it")
    parser.add_argument(
        "scenes",
        nargs="*",
        metavar="SCENE",
        default=[],
        help=f"of {', '.join((*scenes.SCENES, *scenes.SEQUENCES))}; all when left out",
    )
    chosen = parser.parse_args(headless.own_arguments())
    every = (*scenes.SCENES, *scenes.SEQUENCES)
    for name in chosen.scenes:
        if name not in every:
            parser.error(f"there is no scene {name}, only {', '.join(every)}")
    lines, code = [], 0
    headless.find_package()
    for name in chosen.scenes or every:
        if not scenes.is_available(name):
            lines.append(f"{name}: left out, {scenes.FILES[name]} is not there")
            continue
        settings = scenes.build(name).illustrate
        settings.line_width_px, settings.feature_width_px = LINE_WIDTH_PX, FEATURE_WIDTH_PX
        command = ["--out", chosen.out, "--format", chosen.format, "--name", name]
        if name in scenes.SEQUENCES:
            command = ["--out", str(pathlib.Path(chosen.out, name)), "--format", "json"]
            command += ["--frames", "1-8", "--name", "####"]
        code |= headless.main(command, lines)
        if name in scenes.CAGES and not code:
            scenes.save_cage(pathlib.Path(chosen.out, f"{name}.obj"), scenes.CAGES[name])
    print(*lines, sep="\n")
    return code


if __name__ == "__main__":
    command = load_headless()
    command.leave(main(command))
