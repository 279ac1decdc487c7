"""What may happen while a job runs: undo, another file, a scene that goes, the add-on that goes.

$ILLUSTRATE_REPEATS says how often each is tried, at a moment that chance says.
"""

import os
import pathlib
import random
import subprocess
from typing import Any

import bpy
import hands
import illustrate
from illustrate import native
from illustrate.running import jobs, tasks
from illustrate.viewport.live import LIVE
from illustrate.viewport.live_view import VIEW
from staging import Steps, new_scene, pencils

REPEATS = int(os.environ.get("ILLUSTRATE_REPEATS", "3"))
CHANCE = random.Random(11)
LATEST_S = 0.6


def start(number: int) -> None:
    """A drawing by the button, or the live one."""
    scene = new_scene(1)
    scene.illustrate.level, scene.illustrate.threads = 3, 1
    if number % 2:
        hands.manager().illustrate_live = True
        hands.redraw()
    else:
        with hands.override():
            assert bpy.ops.illustrate.illustrate("INVOKE_DEFAULT") == {"RUNNING_MODAL"}


def moment() -> float:
    return CHANCE.random() * LATEST_S


def end() -> None:
    VIEW.switch(False)
    assert not tasks.is_running() and LIVE.running is None


def undo_during_a_job(_out: pathlib.Path) -> Steps:
    """Undo and redo by a script; the run ends with strokes, or with a word about what is gone."""
    for number in range(REPEATS):
        start(number)
        with hands.override():
            bpy.data.objects["Sun"].location.x += 1
            bpy.ops.ed.undo_push(message="Moved")
        yield moment()
        with hands.override():
            bpy.ops.ed.undo()
        yield moment()
        with hands.override():
            bpy.ops.ed.redo()
        yield lambda: not tasks.is_running()
        assert number % 2 or len(pencils()) == 1
        end()


def a_file_is_loaded_during_a_job(_out: pathlib.Path) -> Steps:
    """The job is let go, and nothing is written into the new file."""
    for number in range(REPEATS):
        start(number)
        yield moment()
        with hands.override():
            bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True, load_ui=False)
        yield 0.1
        assert not VIEW.is_on and not pencils()
        end()


def the_scene_goes_during_a_job(_out: pathlib.Path) -> Steps:
    """It is deleted: its illustration is not written."""
    for number in range(REPEATS):
        start(number)
        yield moment()
        if number % 2 == 0 and not tasks.is_running():
            continue  # it was done before
        scene = hands.window().scene
        hands.window().scene = bpy.data.scenes.new("Other")
        bpy.data.scenes.remove(scene)
        hands.redraw()
        yield lambda: not tasks.is_running()
        assert not pencils()
        end()


def the_addon_goes_during_a_job(_out: pathlib.Path) -> Steps:
    """It is disabled and enabled again: nothing runs on, nothing is left."""
    for number in range(REPEATS):
        start(number)
        yield moment()
        illustrate.unregister()
        assert not tasks.is_running() and not VIEW.is_on and not jobs.are_leaving()
        assert not hasattr(bpy.types, "ILLUSTRATE_OT_illustrate")
        hands.redraw()
        yield 0.05
        illustrate.register()
        hands.redraw()
        end()


QUIT = """
import sys
sys.path[:0] = {paths!r}
import bpy, installed
installed.provide()
import illustrate
illustrate.register()
import job_scenarios, hands
def begin():
    job_scenarios.start({number})
    bpy.app.timers.register(leave, first_interval={moment})
def leave():
    with hands.override():
        bpy.ops.wm.quit_blender()
bpy.app.timers.register(begin, first_interval=0.5)
"""


def other_blender(script: pathlib.Path) -> Any:
    """Another Blender that runs a script, with the add-on as it is here, installed or not."""
    folder = pathlib.Path(illustrate.__path__[0]).parent
    variables = {name: value for name, value in os.environ.items() if name != "ILLUSTRATE_ZIP"}
    command = [bpy.app.binary_path, "--factory-startup", "--python", str(script)]
    return subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=variables | {"ILLUSTRATE_ADDONS": str(folder)},
    )


def blender_quits_during_a_job(out: pathlib.Path) -> Steps:
    """Other Blenders are quit while they draw: each ends well and at once."""
    here = pathlib.Path(__file__).parent
    module = pathlib.Path(str(native.load().__file__)).parents[1]
    paths = [str(here), str(here.parent), str(module)]
    for number in range(REPEATS):
        script = out / "quit.py"
        script.write_text(QUIT.format(paths=paths, number=number, moment=moment()))
        other = other_blender(script)
        try:
            yield lambda other=other: other.poll() is not None
        finally:
            other.kill()  # one that hangs is waited for in vain: it must not stop the others
            said = other.communicate()[0].decode(errors="replace")
        assert other.returncode == 0 and "crash" not in said.lower(), said
        assert "Traceback" not in said, said
        script.unlink()


ALL = [
    undo_during_a_job,
    a_file_is_loaded_during_a_job,
    the_scene_goes_during_a_job,
    the_addon_goes_during_a_job,
    blender_quits_during_a_job,
]
