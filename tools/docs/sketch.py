"""Small line pictures in SVG, for notions that no single drawing shows alone."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from illustrate_native.debug import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY

__all__ = ["BLACK", "BLUE", "GREEN", "GREY", "ORANGE", "PINK", "RED", "SKY", "Sketch", "beside"]

_HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
    'width="{width:g}" height="{height:g}" fill="none" stroke-linecap="round" '
    'stroke-linejoin="round" font-family="sans-serif" font-size="11">\n'
    '<rect width="100%" height="100%" fill="#fff"/>'
)


class Sketch:
    """Marks one over the other; x runs right, y down, in pixels."""

    def __init__(self, width: float = 200, height: float = 120) -> None:
        self.width, self.height = width, height
        self._marks: list[str] = []

    def line(
        self,
        points: Any,
        colour: str = BLACK,
        width: float = 1.6,
        dash: str = "",
        closed: bool = False,
        fill: str = "",
    ) -> Sketch:
        """A polyline through points (n, 2); dash as in SVG."""
        data = "L".join(f"{x:g},{y:g}" for x, y in np.round(np.asarray(points, float), 1).tolist())
        self._marks.append(
            f'<path d="M{data}{"Z" if closed else ""}" stroke="{colour}" stroke-width="{width:g}"'
            + (f' stroke-dasharray="{dash}"' if dash else "")
            + (f' fill="{fill}"' if fill else "")
            + "/>"
        )
        return self

    def dots(self, points: Any, colour: str = RED, radius: float = 3) -> Sketch:
        """A disc at each point."""
        for x, y in np.round(np.asarray(points, float).reshape(-1, 2), 1).tolist():
            self._marks.append(f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{colour}"/>')
        return self

    def text(self, x: float, y: float, words: str, colour: str = "#333") -> Sketch:
        """Words that start at a place."""
        self._marks.append(f'<text x="{x:g}" y="{y:g}" fill="{colour}">{words}</text>')
        return self

    def svg(self) -> str:
        """The whole picture."""
        head = _HEAD.format(width=self.width, height=self.height)
        return "\n".join([head, *self._marks, "</svg>", ""])


def beside(pictures: Iterable[tuple[str, str]], width: float = 300) -> str:
    """Pictures (caption, SVG text) side by side in one, each so wide."""
    panels, tallest = [], 0.0
    for column, (caption, text) in enumerate(pictures):
        found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', text)
        if found is None:
            raise ValueError(f"the picture of {caption!r} has no viewBox from 0 0")
        height = width * float(found[2]) / float(found[1])
        tallest = max(tallest, height)
        inner = re.sub(r"^<\?xml[^>]*>\s*", "", text.strip())
        inner = re.sub(r'\s(?:width|height)="[\d.]+(?:mm)?"', "", inner, count=2)
        place = f'<svg x="{column * width:g}" y="20" width="{width:g}" height="{height:g}"'
        panels.append(inner.replace("<svg", place, 1))
        panels.append(f'<text x="{column * width + 8:g}" y="14" fill="#333">{caption}</text>')
    columns = len(panels) // 2
    head = _HEAD.format(width=columns * width, height=tallest + 20)
    return "\n".join([head, *panels, "</svg>", ""])
