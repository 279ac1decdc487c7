"""A shot for the tests of the farm, and the command that draws it, in this process."""

import pathlib
from typing import Any

import bpy
from illustrate.farm import main as farm

import tools

FORMATS = ("--format", "svg,png,json,blend")


def moving_cube(scene: Any, folder: pathlib.Path) -> pathlib.Path:
    """A saved file of a cube that moves through frames 1 to 6."""
    cube = tools.cube_scene(scene)
    scene.illustrate.hatching = False
    for frame, x in ((1, 0.0), (6, 1.0)):
        cube.location.x = x
        cube.keyframe_insert("location", frame=frame)
    path = folder / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def draw(out: pathlib.Path, *arguments: str) -> int:
    """The exit code of the command, for the open file, in this process."""
    code: int = farm.main(["--out", str(out), *arguments])
    return code


def contents(folder: pathlib.Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def bad_at(frame: int) -> None:
    """Nothing is there to be drawn at a frame."""
    cube = bpy.data.objects["Box"]
    for number in (frame - 1, frame, frame + 1):
        cube.hide_render = number == frame
        cube.keyframe_insert("hide_render", frame=number)
