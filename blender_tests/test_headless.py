"""The command without a window, as another process runs it."""

import os
import pathlib
import subprocess
import sys
from typing import Any

import bpy
import illustrate
import pytest

import tools

SCRIPT = pathlib.Path(illustrate.__file__).parent / "headless.py"


def headless(blend: Any, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs the script on a .blend in the program when this is the program, else in its module."""
    if bpy.app.binary_path:
        command = [
            bpy.app.binary_path,
            "-b",
            "--factory-startup",
            str(blend),
            "--python-exit-code",
            "3",
            "--python",
            str(SCRIPT),
            "--",
            *arguments,
        ]
    else:
        command = [sys.executable, str(SCRIPT), str(blend), *arguments]
    return subprocess.run(
        command, capture_output=True, text=True, timeout=300, check=False, env=dict(os.environ)
    )


@pytest.fixture
def saved(tmp_path: Any) -> Any:
    """Saves the open file; a function that gives its path."""

    def save() -> pathlib.Path:
        path = pathlib.Path(tmp_path) / "shot.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(path))
        return path

    return save


def names(folder: pathlib.Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_writes_every_format_and_sums_up(scene: Any, saved: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    blend = saved()
    before = blend.read_bytes()
    out = tmp_path / "new" / "drawings"
    ran = headless(blend, "--frames", "1", "--out", str(out), "--format", "svg,png,json,blend")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert names(out) == [f"shot_0001.{e}" for e in ("blend", "json", "png", "svg")]
    assert names(tmp_path) == ["new", "shot.blend"]
    assert blend.read_bytes() == before
    last = [line for line in ran.stdout.splitlines() if line.startswith("shot_0001: ")][-1]
    assert " strokes (" in last and "png " in last
    assert "Traceback" not in ran.stderr


def test_frames_and_style(scene: Any, saved: Any, tmp_path: Any) -> None:
    cube = tools.cube_scene(scene)
    cube.keyframe_insert("location", frame=1)
    cube.location.x = 2
    cube.keyframe_insert("location", frame=3)
    ran = headless(
        saved(),
        "--frames",
        "1,3-4",
        "--out",
        str(tmp_path / "out"),
        "--width-mm",
        "100",
        "--svg-style",
        "tapered",
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert names(tmp_path / "out") == [f"shot_000{i}.svg" for i in (1, 3, 4)]
    first, third, fourth = ((tmp_path / "out" / f"shot_000{i}.svg").read_text() for i in (1, 3, 4))
    assert first != third == fourth
    assert 'width="100mm" height="75mm"' in first and "stroke-width" not in first


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        ("no camera", "no camera"),
        ("panoramic", '"Eye" is panoramic'),
        ("nothing", "can be drawn"),
        ("not finite", "8 vertices that are not finite"),
    ],
)
def test_a_scene_that_cannot_be_drawn(
    scene: Any, saved: Any, tmp_path: Any, spoil: str, words: str
) -> None:
    cube = tools.cube_scene(scene)
    if spoil == "no camera":
        scene.camera = None
    elif spoil == "panoramic":
        scene.camera.data.type = "PANO"
    elif spoil == "not finite":
        for vertex in cube.data.vertices:
            vertex.co.x = float("nan")
    else:
        bpy.data.objects.remove(cube)
    ran = headless(saved(), "--out", str(tmp_path / "out"))
    assert ran.returncode not in (0, 139)
    assert words in ran.stderr and "Traceback" not in ran.stderr
    assert ran.stderr.count("illustrate: error:") == 1
    assert not names(tmp_path / "out")


def test_a_preset_is_drawn_with(scene: Any, saved: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    blend = saved()
    ran = headless(blend, "--out", str(tmp_path / "out"), "--preset", "silhouette drawing")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "Hatch" not in (tmp_path / "out" / "shot_0001.svg").read_text()
    ran = headless(blend, "--out", str(tmp_path / "out"), "--preset", "Watercolour")
    assert ran.returncode != 0 and "Traceback" not in ran.stderr
    assert 'no preset "Watercolour"' in ran.stderr and '"Plotter 0.3 mm"' in ran.stderr


def test_a_folder_that_cannot_be_written(scene: Any, saved: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    (tmp_path / "file").write_text("")
    ran = headless(saved(), "--out", str(tmp_path / "file" / "inside"))
    assert ran.returncode != 0
    assert "inside" in ran.stderr and "choose another" in ran.stderr
    assert "Traceback" not in ran.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ["--format", "bmp"],
        ["--frames", "5-1"],
        ["--frames", "x"],
        ["--width-mm", "-3"],
        ["--name", "../up"],
        ["--frames", "1-2", "--name", "same"],
        ["--out"],
    ],
)
def test_a_wrong_command_line(tmp_path: Any, arguments: list[str]) -> None:
    from illustrate import headless as command

    with pytest.raises(SystemExit) as left:
        command.parse(["--out", str(tmp_path), *arguments])
    assert left.value.code == 2


def test_names_of_files() -> None:
    from illustrate.headless import file_name

    assert file_name("FILE_####", 7) == "untitled_0007"
    assert file_name("shot", 7) == "shot"
