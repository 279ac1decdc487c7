"""The command without a window, as another process runs it."""

import pathlib
import subprocess
from typing import Any

import bpy
import illustrate
import pytest
from illustrate.farm.arguments import parse
from illustrate.farm.frames import file_name

import tools

SCRIPT = pathlib.Path(illustrate.__file__).parent / "headless.py"


def headless(blend: Any, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs the script on a .blend in the program when this is the program, else in its module."""
    return tools.run_script(SCRIPT, *arguments, blend=blend)


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
    assert " strokes (" in last and "png " in last and ", strokes " in last
    assert "Traceback" not in ran.stderr


def test_frames_and_style(scene: Any, saved: Any, tmp_path: Any) -> None:
    cube = tools.cube_scene(scene)
    scene.illustrate.keep_strokes = False
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
    assert ", strokes " not in ran.stdout  # SVG is written without strokes in the scene
    first, third, fourth = ((tmp_path / "out" / f"shot_000{i}.svg").read_text() for i in (1, 3, 4))
    assert first != third
    assert third == fourth.replace('"frame": 4', '"frame": 3')
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


def command(blend: Any, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs the command of the extension as an artist's script would, with the user's settings."""
    if not bpy.app.binary_path:
        pytest.skip("the module bpy has no --command")
    if not illustrate.__name__.startswith("bl_ext."):
        pytest.skip("--command is of extensions, of Blender 4.2 and later")
    words = [bpy.app.binary_path, "-b", str(blend), "--command", "illustrate", *arguments]
    return subprocess.run(words, capture_output=True, text=True, timeout=300, check=False)


def test_the_command_of_blender(scene: Any, saved: Any, tmp_path: Any) -> None:
    tools.cube_scene(scene)
    blend, out = saved(), tmp_path / "out"
    options = ("--frames", "1-2", "--format", "svg,png,json,blend", "--width-mm", "120")
    ran = command(blend, "--out", str(out), *options, "--preset", "Silhouette Drawing")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert len(names(out)) == 8
    assert headless(blend, "--out", str(tmp_path / "same"), *options, "--preset",
                    "Silhouette Drawing").returncode == 0  # fmt: skip
    for name in ("shot_0001.svg", "shot_0002.json"):
        assert (out / name).read_bytes() == (tmp_path / "same" / name).read_bytes()


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (("--help",), 0, "--frames"),
        (("--out", "OUT", "--format", "bmp"), 2, "not one of svg, png, json, blend"),
        (("--out", "OUT", "--preset", "Watercolour"), 1, 'no preset "Watercolour"'),
        (("--out", "OUT"), 1, "no camera"),
    ],
)
def test_exit_codes_of_the_command(
    scene: Any, saved: Any, tmp_path: Any, arguments: tuple[str, ...], code: int, words: str
) -> None:
    scene.camera = None
    tools.add_cube()
    out = str(tmp_path / "out")
    ran = command(saved(), *(out if word == "OUT" else word for word in arguments))
    assert ran.returncode == code, ran.stdout + ran.stderr
    assert words in ran.stdout + ran.stderr and "Traceback" not in ran.stderr


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
        ["--frames", "1-5x0"],
        ["--frames", "1,,2"],
        ["--warm-up", "-1"],
        ["--progress", "loud"],
        ["--width-mm", "-3"],
        ["--name", "../up"],
        ["--frames", "1-2", "--name", "same"],
        ["--out"],
    ],
)
def test_a_wrong_command_line(tmp_path: Any, arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as left:
        parse(["--out", str(tmp_path), *arguments])
    assert left.value.code == 2


def test_names_of_files() -> None:
    assert file_name("FILE_####", 7) == "untitled_0007"
    assert file_name("shot", 7) == "shot"


LEAVING = """
import importlib.util, sys
spec = importlib.util.spec_from_file_location("headless", sys.argv[-2])
headless = importlib.util.module_from_spec(spec)
spec.loader.exec_module(headless)
headless.find_package()
if sys.argv[-1] != "end":
    headless.leave(int(sys.argv[-1]))
"""


@pytest.mark.parametrize(("last", "code"), [("0", 0), ("7", 7), ("end", 0)])
def test_a_script_that_registers_the_addon_ends_cleanly(
    tmp_path: Any, last: str, code: int
) -> None:
    if last == "end" and not bpy.app.binary_path and bpy.app.version < (4, 5, 0):
        pytest.skip("such a module crashes after any property with an update function")
    script = tmp_path / "script.py"
    script.write_text(LEAVING)
    ran = tools.run_script(script, str(SCRIPT), last, user=tmp_path / "user")
    assert ran.returncode == code, ran.stdout + ran.stderr
