"""Writes the Grease Pencil object "Illustration"; what its two versions have in common.

Version 2 and 3 are modules with the same functions, handed in as `api`:
    new_data()                      data without layers
    remove_data(data)
    our_layers(data)                the add-on's layers by their titles, lowest first
    new_layer(data, title)          made and marked as the add-on's own
    remove_layer(data, layer)
    lower(data, layer)              moves it one layer down
    count(data, layer, frame)       (strokes of the add-on, all strokes) of a keyframe
    remove_frame(data, layer, frame)
    remove_strokes(data, layer, frame)     those of the add-on
    append(data, layer, frame, group, pens)     pens: (s,) indices of materials
    TYPE                            of the object
"""

import json
from collections.abc import Callable
from typing import Any

import bpy
import numpy as np

from ..ownership import mark, may_replace
from . import fills, pens
from .strokes import Sheet, StrokeGroup

NAME = "Illustration"
OBJECTS = "illustrate_objects"
# Older Blenders know no GENERATED; JITTER is the type that artists have least use for.
BAKED = "GENERATED" if bpy.app.version >= (4, 2, 0) else "JITTER"
"""The type of keyframes that a bake or nothing but the add-on made."""


def find(scene: Any, api: Any) -> Any:
    """The add-on's Grease Pencil object in the scene, or None."""
    mine = (thing for thing in scene.objects if thing.type == api.TYPE and may_replace(thing))
    return next(mine, None)


def write(api: Any, scene: Any, sheet: Sheet) -> list[Any]:
    """Puts a sheet in place of the last ones, baked ones on other frames excepted."""
    illustration = _find_or_create(api, scene)
    data, keep = illustration.data, scene.illustrate.keep_frames
    _clear(
        api,
        data,
        lambda frame: frame.frame_number == sheet.frame or not (keep or _is_baked(frame)),
    )
    names = _object_names(data) if _has_frames(api, data) else []
    _write_sheet(api, data, sheet.renumbered(names), scene.illustrate, baking=False)
    data[OBJECTS] = json.dumps(names)
    return [illustration]


def bake(api: Any, scene: Any, sheets: list[Sheet]) -> list[str]:
    """Writes keyframes from the first sheet's to the last one's; what was left to the artist."""
    data = _find_or_create(api, scene).data
    first, last = sheets[0].frame, sheets[-1].frame
    _clear(api, data, lambda frame: first <= frame.frame_number <= last)
    names, left = _object_names(data), []
    for sheet in sheets:
        left += _write_sheet(api, data, sheet.renumbered(names), scene.illustrate, baking=True)
    data[OBJECTS] = json.dumps(names)
    return left


def clear(api: Any, scene: Any) -> None:
    """Removes the add-on's strokes, and the object when nothing of the artist's is in it."""
    illustration = find(scene, api)
    if illustration is None:
        return
    data = illustration.data
    _clear(api, data, lambda _frame: True)
    for layer in api.our_layers(data).values():
        if not len(layer.frames):
            api.remove_layer(data, layer)
    if len(data.layers):
        return
    materials = list(data.materials)
    bpy.data.objects.remove(illustration)
    if not data.users:
        api.remove_data(data)
    pens.remove_unused(materials)


def restyle(api: Any, scene: Any) -> None:
    """Gives the object and its pens what the settings say now."""
    illustration = find(scene, api)
    if illustration is not None:
        illustration.show_in_front = scene.illustrate.in_front
        pens.colour_all(illustration.data, scene.illustrate)


def _find_or_create(api: Any, scene: Any) -> Any:
    illustration = find(scene, api)
    if illustration is None:
        data = api.new_data()
        illustration = bpy.data.objects.new(NAME, data)
        illustration.show_in_front = scene.illustrate.in_front
        scene.collection.objects.link(illustration)
        mark(illustration, data)
    return illustration


def _object_names(data: Any) -> list[str]:
    """Names of the meshes that strokes are of, by the numbers that strokes carry."""
    names: list[str] = json.loads(data.get(OBJECTS, "[]"))
    return names


def _has_frames(api: Any, data: Any) -> bool:
    return any(len(layer.frames) for layer in api.our_layers(data).values())


def _is_baked(frame: Any) -> bool:
    return bool(frame.keyframe_type == BAKED)


def _clear(api: Any, data: Any, is_cleared: Callable[[Any], bool]) -> None:
    """Keyframes that are left empty go too; layers stay, with what the artist has set on them."""
    for layer in api.our_layers(data).values():
        for frame in [frame for frame in layer.frames if is_cleared(frame)]:
            ours, all_strokes = api.count(data, layer, frame)
            if ours == all_strokes and (ours or _is_baked(frame)):
                api.remove_frame(data, layer, frame)
            elif ours:
                api.remove_strokes(data, layer, frame)


def _write_sheet(api: Any, data: Any, sheet: Sheet, settings: Any, baking: bool) -> list[str]:
    """Appends the strokes of a sheet at its frame; the layers where that frame is the artist's."""
    left = []
    titles = [group.title for group in sheet.groups]
    for group in sheet.groups:
        layer = api.our_layers(data).get(group.title) or _new_layer(api, data, group.title, titles)
        frame = _frame_at(layer, sheet.frame)
        if frame is not None and baking:
            left.append(f'frame {sheet.frame} of layer "{group.title}"')
            continue
        # `frames.new` raises where there is a keyframe already.
        if frame is None:
            frame = layer.frames.new(sheet.frame)
            frame.keyframe_type = BAKED if baking else "KEYFRAME"
        api.append(data, layer, frame, group, _materials(data, group, settings))
    for title, layer in api.our_layers(data).items():
        if title not in titles:
            _end_last_drawing(api, data, layer, sheet.frame)
    return left


def _materials(data: Any, group: StrokeGroup, settings: Any) -> Any:
    """(s,) the index of each stroke's material."""
    if group.inks:
        return fills.indices_of(data, group.inks)
    return np.full(len(group.sizes), pens.index_of(data, group.pen, settings, True), np.int32)


def _end_last_drawing(api: Any, data: Any, layer: Any, number: int) -> None:
    """An empty keyframe where a layer has no strokes any more but the last ones would be seen."""
    if _frame_at(layer, number) is not None:
        return
    past = [frame for frame in layer.frames if frame.frame_number < number]
    last = max(past, key=lambda frame: int(frame.frame_number), default=None)
    if last is not None and api.count(data, layer, last)[0]:
        layer.frames.new(number).keyframe_type = BAKED


def _frame_at(layer: Any, number: int) -> Any:
    """The layer's own keyframe at `number`, or None."""
    return next((frame for frame in layer.frames if frame.frame_number == number), None)


def _new_layer(api: Any, data: Any, title: str, titles: list[str]) -> Any:
    """A layer below those of the add-on that come later in `titles`."""
    higher = titles[titles.index(title) + 1 :]
    layer = api.new_layer(data, title)
    order = list(api.our_layers(data))
    for _ in range(sum(name in higher for name in order)):
        api.lower(data, layer)
    return layer
