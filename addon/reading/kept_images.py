"""What was read of images, kept while a live drawing reads the same scene again and again.

Millions of texels take Blender longer to hand out than the rest of a scene. Nobody else is given
what is kept: images may change without a word of Blender's.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

CHANGING = ("SEQUENCE", "MOVIE", "VIEWER")  # sources whose picture is another at another time


class KeptImages:
    """Results by image and kind."""

    def __init__(self) -> None:
        self._made: dict[tuple[Any, str], Any] = {}
        self._is_asked = False

    @contextmanager
    def asked(self) -> Iterator[None]:
        """Within it what is kept counts, and what is made is kept."""
        self._is_asked = True
        try:
            yield
        finally:
            self._is_asked = False

    def forget(self) -> None:
        """For images that have changed, or are gone."""
        self._made.clear()

    def of(self, image: Any, kind: str, make: Callable[[], Any]) -> Any:
        """What `make` makes of an image, or made before; what it raises is not kept."""
        if not self._is_asked or image.source in CHANGING or image.is_dirty:
            return make()
        key = image, kind
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]


IMAGES = KeptImages()
"""The images of this Blender."""
