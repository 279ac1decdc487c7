"""What is in a file that is saved, and not in the open one."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

import bpy


@contextmanager
def only_saved(write: Callable[[], None], remove: Callable[[], None]) -> Iterator[None]:
    """Meanwhile `write` is done just before a file is saved and `remove` just after.

    What they raise is raised at the end. Blender updates the scene before and after the operator
    that saves it, and with Grease Pencil 2 an update copies all strokes: these it does not see.
    """
    raised: list[BaseException] = []

    def handler(work: Callable[[], None]) -> Callable[..., None]:
        def run(*_: Any) -> None:
            try:
                work()
            except BaseException as error:
                raised.append(error)

        return run

    with ExitStack() as stack:
        for handlers, work in (
            (bpy.app.handlers.save_pre, write),
            (bpy.app.handlers.save_post, remove),
        ):
            added = handler(work)
            handlers.append(added)
            stack.callback(handlers.remove, added)
        yield
    if raised:
        raise raised[0]
