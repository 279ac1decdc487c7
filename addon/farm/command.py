"""The command of Blender 4.2 and later: `blender -b FILE.blend --command illustrate --out DIR`."""

import traceback
from typing import Any

import bpy

from .. import headless

NAME = "illustrate"
_handles: list[Any] = []


def run(arguments: list[str]) -> int:
    """Does what headless.py does with these arguments; the exit code."""
    try:
        return headless.main(arguments)
    except SystemExit as left:  # from the parser of the arguments, which has said why
        return left.code if isinstance(left.code, int) else 2
    except Exception:
        traceback.print_exc()
        return 3


def register() -> None:
    """Registers the command where Blender has commands."""
    if hasattr(bpy.utils, "register_cli_command"):
        _handles.append(bpy.utils.register_cli_command(NAME, run))


def unregister() -> None:
    """Takes it away again."""
    while _handles:
        bpy.utils.unregister_cli_command(_handles.pop())
