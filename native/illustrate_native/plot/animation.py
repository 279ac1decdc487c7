"""Plots one after another as an animated SVG: each is a group that is shown in its time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from .errors import PlotError
from .plans import Plot
from .svg_file import END, head, layers

_ANIMATE = (
    '<animate attributeName="display" calcMode="discrete" dur="{seconds:.6g}s" '
    'repeatCount="indefinite" values="{values}" keyTimes="{times}"/>'
)
_HIDDEN = ' display="none"'


def animated_svg_of(
    plots: Sequence[Plot], frames_per_second: float, made_by: Mapping[str, Any] | None = None
) -> str:
    """SVG text; programs that do not animate show the first plot. Pages must be of one size.

    Raises PlotError where they are not, and for nothing to show.
    """
    if not plots or not frames_per_second > 0:
        raise PlotError("an animation needs frames, and some of them in a second")
    if len({plot.page for plot in plots}) > 1:
        raise PlotError("the pages of an animation must be of one size")
    lines = [*head(plots[0], made_by)]
    for frame, plot in enumerate(plots):
        lines.append(f'<g id="frame-{frame + 1}"{"" if frame == 0 else _HIDDEN}>')
        lines += [*_shown(frame, len(plots), frames_per_second), *layers(plot, f"f{frame + 1}-pen")]
        lines.append("</g>")
    return "\n".join([*lines, END, ""])


def _shown(frame: int, count: int, frames_per_second: float) -> Iterator[str]:
    """What shows a frame in its time of each round; a single one is always shown."""
    if count == 1:
        return
    changes = [(0.0, "none"), (frame / count, "inline"), ((frame + 1) / count, "none")]
    kept = changes[1 if frame == 0 else 0 : 2 if frame == count - 1 else 3]
    yield _ANIMATE.format(
        seconds=count / frames_per_second,
        values=";".join(value for _, value in kept),
        times=";".join(f"{time:.6g}" for time, _ in kept),
    )
