"""What is shown over the 3D viewport: live lines and overlays to inspect a drawing with."""

from . import inspect, live, page_overlay

PARTS = (live, inspect, page_overlay)
