"""What is shown over the 3D viewport: the live drawing and overlays to inspect a drawing with."""

from . import guiding, hidden_strokes, inspect, live_view, page_overlay, paper, pick

PARTS = (hidden_strokes, live_view, inspect, page_overlay, paper, pick, guiding)
