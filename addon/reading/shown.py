"""What is shown of a view layer."""

from collections.abc import Iterator
from typing import Any


def shown_objects(view_layer: Any) -> Iterator[Any]:
    """Objects that are hidden neither themselves nor with their collections.

    Not by `visible_get`, which asks the viewport that is being drawn: it may be on paper, show no
    meshes, or be in local view, and what is drawn is the same.
    """
    waiting, found = [view_layer.layer_collection], set()
    while waiting:
        layer = waiting.pop()
        waiting += layer.children
        for thing in layer.collection.objects if layer.is_visible else ():
            is_hidden = thing.hide_viewport or thing.hide_get(view_layer=view_layer)
            if not is_hidden and thing not in found:
                found.add(thing)
                yield thing
