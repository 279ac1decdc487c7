"""What is shown over the 3D viewport: live lines and overlays to inspect a drawing with."""

from . import inspect, live

PARTS = (live, inspect)


def register() -> None:
    """Registers the switches."""
    for part in PARTS:
        part.register()


def unregister() -> None:
    """Stops all that is shown, and takes the switches away again."""
    for part in reversed(PARTS):
        part.unregister()
