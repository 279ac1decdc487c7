"""Frames one after another, in which strokes live on."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar

from ._core import (
    Camera,
    Drawing,
    DrawOptions,
    InvalidInput,
    Light,
    PolygonMesh,
    Prepared,
    PrepareOptions,
    draw,
    prepare,
)

if TYPE_CHECKING:  # loading it takes longer than all of this module
    from numpy.typing import ArrayLike

Value = TypeVar("Value")
Positions = Sequence["ArrayLike | None"]
"""Of each mesh in one frame, (n, 3) world; None: where it was in the frame before."""


def draw_sequence(
    meshes: Iterable[PolygonMesh],
    cameras: Iterable[Camera],
    positions: Iterable[Positions | None] | None = None,
    lights: Iterable[Iterable[Light]] | None = None,
    options: DrawOptions | None = None,
    prepare_options: PrepareOptions | None = None,
    progress: Callable[[float, str], bool] | None = None,
) -> Iterator[Drawing]:
    """The drawings of a sequence, each made when it is asked for and after the one before.

    Strokes keep their numbers (`Drawing.stroke_ids`), and where along them textures and dashes
    begin (`Drawing.stroke_starts`). A mesh that deforms keeps its field and its hatches.

    Args:
        meshes: as in the first frame, and in all where there are no positions.
        cameras: one for each frame; there are as many frames.
        positions: of each frame the vertices of each mesh; None: as in the frame before.
        lights: of each frame; None: one headlight.
        options: of all frames. Automatic exposure is found in each: give a fixed one.
        prepare_options: of all frames.
        progress: told how far the frame is that is being made.

    Raises:
        InvalidInput: as `prepare` and `draw`; positions or lights for fewer frames than cameras.
        Cancelled: progress returned False.
    """
    scene = _Scene(list(meshes), prepare_options, progress)
    moves = iter(positions) if positions is not None else None
    lit = iter(lights) if lights is not None else None
    drawing: Drawing | None = None
    for camera in cameras:
        moved = _next(moves, "positions", drawing)
        lamps = _next(lit, "lights", drawing)
        drawing = draw(scene.at(moved), camera, options, lamps, progress, drawing)
        yield drawing


class _Scene:
    """What is prepared of the meshes, frame after frame."""

    def __init__(
        self,
        meshes: list[PolygonMesh],
        options: PrepareOptions | None,
        progress: Callable[[float, str], bool] | None,
    ) -> None:
        self._meshes, self._options, self._progress = meshes, options, progress
        self._prepared: Prepared | None = None

    def at(self, positions: Positions | None) -> Prepared:
        """Of the meshes with these vertices."""
        if positions is not None:
            self._move(positions)
        if self._prepared is None or positions is not None:
            self._prepared = prepare(
                self._meshes, self._options, self._progress, previous=self._prepared
            )
        return self._prepared

    def _move(self, positions: Positions) -> None:
        if len(positions) != len(self._meshes):
            raise InvalidInput(
                f"positions has {len(positions)} arrays for {len(self._meshes)} meshes"
            )
        self._meshes = [
            mesh if moved is None else mesh.deformed(moved)
            for mesh, moved in zip(self._meshes, positions, strict=True)
        ]


def _next(values: Iterator[Value] | None, name: str, last: Drawing | None) -> Value | None:
    """The value of the next frame, or None where there are none at all."""
    if values is None:
        return None
    try:
        return next(values)
    except StopIteration:
        frame = 0 if last is None else last.frame + 1
        raise InvalidInput(f"{name} has nothing for frame {frame}") from None
