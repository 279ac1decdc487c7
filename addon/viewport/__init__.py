"""What is shown over the 3D viewport: the live drawing and overlays to inspect a drawing with."""

from . import inspect, live_view, page_overlay, paper, pick

PARTS = (live_view, inspect, page_overlay, paper, pick)
