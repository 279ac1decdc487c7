"""Plots by the headless command."""

import pathlib
import re
from typing import Any

import bpy
import illustrate
import pytest
from illustrate.output import stamps
from test_headless import headless
from test_plot import groups

import tools


def saved(folder: Any) -> pathlib.Path:
    path = pathlib.Path(folder) / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def test_headless_plots_with_a_preset(scene: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    blend, out = saved(tmp_path), tmp_path / "out"
    arguments = ("--frames", "1-2", "--out", str(out), "--plot", "iso 128", "--page", "A5",
                 "--order", "drawing", "--sequence", "svg")  # fmt: skip
    ran = headless(blend, *arguments)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    names = sorted(path.name for path in out.iterdir())
    assert re.search(r"shot_0001.svg: \d layers, \d+ strokes, .* about \d+ min \d+ s", ran.stdout)
    assert names == ["shot.svg", "shot_0001.svg", "shot_0002.svg"]
    assert 'width="210mm" height="148mm"' in (out / names[1]).read_text()
    assert "2 Hatching" in groups(out / names[1])
    stamp = stamps.read_stamp(str(out / names[1]))
    assert stamp["frame"] == 1
    again = headless(blend, *arguments[:-2], "--skip-existing")
    assert again.stdout.count("skipping existing frame") == 2
    other = headless(blend, *arguments[:-4], "--order", "wet", "--skip-existing")
    assert "skipping" not in other.stdout


def test_headless_without_plots_is_as_before(scene: Any) -> None:
    tools.cube_scene(scene)
    before = stamps.stamp_of(scene, 200.0, "centerline")
    scene.illustrate_plot.paper = "A0"
    assert stamps.stamp_of(scene, 200.0, "centerline") == before
    changed = stamps.stamp_of(scene, 200.0, "centerline", True)
    scene.illustrate_plot.pens.add()
    assert stamps.stamp_of(scene, 200.0, "centerline", True) != changed


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--page", "A9"], "is no paper"),
        (["--plot", "None such"], "There is no preset"),
        (["--scale", "half"], "is no scale such as 1:50"),
        (["--sequence", "png"], "is not one of pdf, svg"),
    ],
)
def test_headless_says_what_is_wrong(
    scene: Any, tmp_path: Any, arguments: list[str], words: str, capsys: Any
) -> None:
    tools.cube_scene(scene)
    try:
        code = illustrate.headless.main(["--out", str(tmp_path / "out"), *arguments])
    except SystemExit as left:
        code = left.code
    assert code in (1, 2)
    assert words in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
