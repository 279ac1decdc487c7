"""Renders of the scene by its own engine, to be hatched.

The add-on's own objects are hidden meanwhile. In a window the render is Blender's own job, which
can be watched and ended with ESC; in the background, and for scripts, it is waited for.
"""

import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import Any

import bpy

from ..messages import IllustrateError, said
from ..ownership import is_ours, mark
from ..reading.tone_images import load
from .jobs import Step, Steps, run

NAME = "Illustration Tone"

Handlers = dict[str, Callable[..., None]]


def render_steps(
    scene: Any, as_job: bool, read: Callable[[Any], Any], start: float = 0.0, end: float = 0.5
) -> Steps[Any]:
    """read(image) of a render of the scene's current frame; the image is gone afterwards.

    as_job: as a job of Blender's, which a step waits for; else at once. Raises IllustrateError.
    """
    with _prepared(scene):
        if as_job:
            name = scene.name
            with _Watch() as watch:
                _render(scene, "INVOKE_DEFAULT")
                yield Step(watch, start, end, "Rendering", shares_esc=True)
            scene = bpy.data.scenes[name]
        else:
            _render(scene, "EXEC_DEFAULT")
        return _read(scene, read)


def render_now(scene: Any, read: Callable[[Any], Any]) -> Any:
    """The same at once."""
    return run(render_steps(scene, False, read))


def kept(image: Any) -> str:
    """Packs a copy of a loaded render into the file, in place of the last; its name."""
    for old in [old for old in bpy.data.images if is_ours(old)]:
        bpy.data.images.remove(old)
    copy = image.copy()
    copy.pack()
    copy.name, copy.use_fake_user = NAME, False
    mark(copy)
    return str(copy.name)


def _render(scene: Any, how: str) -> None:
    try:
        if "CANCELLED" in bpy.ops.render.render(how, scene=scene.name):
            raise RuntimeError(said("another render is running"))
    except RuntimeError as error:
        why = str(error).strip().removeprefix("Error: ").rstrip(".")
        raise IllustrateError(
            said(
                'Scene "{scene}" cannot be rendered: {why}. Set Tone From to Lights or Image',
                scene=scene.name,
                why=why,
            )
        ) from error


def _prepared(scene: Any) -> AbstractContextManager[None]:
    """The scene without the add-on's objects and lines; afterwards as it was."""
    wanted = [(scene.render, "use_freestyle", False)]
    wanted += [(thing, "hide_render", True) for thing in scene.objects if is_ours(thing)]
    return _with([*wanted, (bpy.context.preferences.view, "render_display_type", "NONE")])


@contextmanager
def _with(wanted: list[tuple[Any, str, Any]]) -> Iterator[None]:
    """Owners' properties of these names with these values; afterwards as they were."""
    before = [(owner, name, getattr(owner, name)) for owner, name, _ in wanted]
    for owner, name, value in wanted:
        setattr(owner, name, value)
    try:
        yield
    finally:
        for owner, name, value in before:
            _set_back(owner, name, value)


def _set_back(owner: Any, name: str, value: Any) -> None:
    try:
        setattr(owner, name, value)
    except ReferenceError:  # removed, or of a file that is closed
        return


def _read(scene: Any, read: Callable[[Any], Any]) -> Any:
    """read(image) of the last render as it looks on the screen."""
    result = next((image for image in bpy.data.images if image.type == "RENDER_RESULT"), None)
    # Python is not given the pixels of a render result: they go through a file.
    with tempfile.TemporaryDirectory() as folder, _as_png(scene):
        path = os.path.join(folder, f"{NAME}.png")
        try:
            if result is None:
                raise ValueError(said("there is no result"))
            result.save_render(path, scene=scene)
            image = load(path)
        except (RuntimeError, ValueError) as error:
            raise IllustrateError(
                said(
                    'The render of scene "{scene}" cannot be read: {why}',
                    scene=scene.name,
                    why=str(error).strip(),
                )
            ) from error
        try:
            return read(image)
        finally:
            bpy.data.images.remove(image)


def _as_png(scene: Any) -> AbstractContextManager[None]:
    """PNG as the format that pictures are saved in; afterwards that of the artist."""
    settings = scene.render.image_settings
    wanted = {"media_type": "IMAGE", "file_format": "PNG", "color_mode": "RGB", "color_depth": "8"}
    return _with([(settings, *pair) for pair in wanted.items() if hasattr(settings, pair[0])])


class _Watch:
    """A render that runs as a job of Blender's, looked at as one of the native module's."""

    def __init__(self) -> None:
        self.is_done = self._was_cancelled = False
        self._handlers: Handlers = {"render_complete": self._end, "render_cancel": self._cancel}

    def __enter__(self) -> "_Watch":
        for name, handler in self._handlers.items():
            getattr(bpy.app.handlers, name).append(handler)
        return self

    def __exit__(self, *_: Any) -> None:
        for name, handler in self._handlers.items():
            listed = getattr(bpy.app.handlers, name)
            if handler in listed:
                listed.remove(handler)

    def _end(self, *_: Any) -> None:
        self.is_done = True

    def _cancel(self, *_: Any) -> None:
        self._was_cancelled = self.is_done = True

    def poll(self) -> tuple[float, str]:
        """Blender shows itself how far its render is."""
        return 0.0, ""

    def cancel(self) -> None:
        """Only Blender's own ESC ends its render; what comes of it is not taken."""

    def wait(self, _seconds: float) -> bool:
        """Never waited for: while Python waits, Blender does not come to tell of the end."""
        return self.is_done

    def result(self) -> None:
        """Raises IllustrateError when the render is not to be whole."""
        if self._was_cancelled:
            raise IllustrateError(said("The render was cancelled: nothing was changed"))
