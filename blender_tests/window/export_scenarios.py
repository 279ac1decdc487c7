"""Export Drawing after the file browser: progress, ESC, and nothing half-written."""

import pathlib
import tempfile
from typing import Any

import bpy
import hands
from illustrate.running import jobs, tasks
from staging import Steps, new_scene, open_panel, pencils


def browser() -> Any:
    """The window and the area of the file browser, or None."""
    for window in hands.manager().windows:
        for area in window.screen.areas:
            if area.type == "FILE_BROWSER":
                return window, area
    return None


def choose(operator: str) -> None:
    """Presses a button of the file browser."""
    window, area = browser()
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        getattr(bpy.ops.file, operator)()


def ask(path: pathlib.Path) -> Steps:
    """Opens the file browser with a name."""
    with hands.override():
        told = bpy.ops.illustrate.export_drawing("INVOKE_DEFAULT", filepath=str(path))
        assert told == {"RUNNING_MODAL"}
    yield lambda: browser() is not None
    yield 0.5


def the_file_browser_is_closed(_out: pathlib.Path) -> Steps:
    """Cancel: nothing runs, nothing is written."""
    new_scene(1)
    with tempfile.TemporaryDirectory() as folder:
        yield from ask(pathlib.Path(folder) / "drawing.svg")
        choose("cancel")
        yield lambda: browser() is None
        yield 0.3
        assert not tasks.is_running() and not list(pathlib.Path(folder).iterdir())


def an_export_is_stopped_or_done(out: pathlib.Path) -> Steps:
    """ESC at some moments leaves no file; an export that is left alone writes it, and no strokes.

    The last moments are those in which the drawing is put on paper.
    """
    scene = new_scene(1)
    scene.illustrate.level, scene.illustrate.threads = 4, 1
    yield from open_panel()
    stages: list[str] = []
    watched = tasks.status_text

    def watch(fraction: float, title: str, stage: str) -> str:
        stages.append(stage)
        text: str = watched(fraction, title, stage)
        return text

    tasks.status_text = watch
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "drawing.svg"
        for moment in (0.0, 0.2, "order", "curves", "file"):
            stages.clear()
            yield from ask(path)
            choose("execute")
            yield tasks.is_running
            is_named = isinstance(moment, str)
            yield (lambda name=moment: name in stages) if is_named else moment
            if moment == 0.2:
                hands.picture(out / "31_export.png")
            assert tasks.is_running(), f"too quick to be stopped at {moment}"
            hands.press("ESC")
            yield lambda: not tasks.is_running()
            yield lambda: not jobs.are_leaving()
            assert not list(pathlib.Path(folder).iterdir()), moment
        yield from ask(path)
        choose("execute")
        yield tasks.is_running
        yield lambda: not tasks.is_running()
        assert [found.name for found in pathlib.Path(folder).iterdir()] == ["drawing.svg"]
        assert path.read_text().rstrip().endswith("</svg>")
    tasks.status_text = watched
    assert not pencils()


ALL = [the_file_browser_is_closed, an_export_is_stopped_or_done]
