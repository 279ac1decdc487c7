"""How long the live drawing takes of Blender's time, in a window: it informs, and decides nothing.

    ILLUSTRATE_MEASURE="MESH.ply [SECONDS]" tools/test_window.sh measure_live

Orbits a mesh, each of several turns so many seconds; prints our part of each redraw and the longest
look at the scene, in time of the processor, memory, and how soon hatches follow when the view
rests: a draft of them, then the whole.
"""

import os
import pathlib
import resource
import sys
import time
import types
from typing import Any

import bpy
import hands
import numpy as np
from illustrate.viewport import live_view
from illustrate.viewport.live import LIVE, WHOLE
from illustrate.viewport.live_view import VIEW
from mathutils import Quaternion
from staging import Steps, new_scene

TURNS = 4


def resident_mb() -> float:
    pages = pathlib.Path("/proc/self/statm").read_text().split()[1]
    return int(pages) * resource.getpagesize() / 1e6


def told(name: str, seconds: Any) -> None:
    ms = 1000 * np.asarray(seconds)
    print(
        f"{name}: {len(ms)} times, median {np.median(ms):.1f} ms, "
        f"95th percentile {np.quantile(ms, 0.95):.1f} ms, longest {ms.max():.1f} ms",
        flush=True,
    )


def load(path: str) -> Any:
    """The mesh of a PLY file in place of the scene's, as high as two units."""
    monkey = bpy.data.objects["Suzanne"]
    bpy.data.objects.remove(monkey)
    with hands.override():
        if bpy.app.version < (4, 0, 0):
            bpy.ops.import_mesh.ply(filepath=path)
        else:
            bpy.ops.wm.ply_import(filepath=path)
    thing = hands.window().view_layer.objects.active
    thing.scale = (2.0 / max(thing.dimensions),) * 3
    thing.data.polygons.foreach_set("use_smooth", [True] * len(thing.data.polygons))
    return thing


def is_whole() -> bool:
    return LIVE.is_idle() and any(seen.drawing_of(WHOLE) for seen in LIVE.views.values())


def is_hatched() -> bool:
    return any(seen.hatched() for seen in LIVE.views.values())


def turn(angle: float) -> None:
    view = hands.viewport().spaces.active.region_3d
    view.view_rotation = Quaternion((0, 0, 1), angle) @ view.view_rotation


def measure_live(_out: pathlib.Path) -> Steps:
    """Turns, then rests."""
    words = os.environ.get("ILLUSTRATE_MEASURE", "").split()
    if not words:
        raise AssertionError("ILLUSTRATE_MEASURE must name a PLY file, and perhaps seconds")
    seconds = float(words[1]) if len(words) > 1 else 10.0
    # The thread's own time: what other programs take of the processor does not count.
    clock = types.SimpleNamespace(perf_counter=time.thread_time, monotonic=time.monotonic)
    live_view.time = clock
    new_scene()
    load(words[0])
    hands.show_side_panel(False)
    hands.manager().illustrate_live = True
    hands.redraw()
    yield is_whole
    print(f"{len(LIVE.prepared.surface.triangles)} triangles", flush=True)
    told("first looks at the scene", VIEW.blocks)
    VIEW.seconds.clear()
    VIEW.blocks.clear()
    memory = [resident_mb()]
    for _ in range(TURNS):  # the first turn makes what the others only use
        start = time.monotonic()
        while time.monotonic() - start < seconds:
            turn(0.05)
            hands.viewport().tag_redraw()
            yield 0.01
        memory.append(resident_mb())
    told("our part of a redraw while the view turned", VIEW.seconds)
    told("our part of a timer's call", VIEW.blocks)
    print("memory, before and after each turn, MB:", *map(round, memory), flush=True)
    drafts, rests = [], []
    for _ in range(8):
        turn(0.4)
        hands.redraw()
        start = time.monotonic()
        yield is_hatched
        drafts.append(time.monotonic() - start)
        yield is_whole
        rests.append(time.monotonic() - start)
    told("hatches after the view came to rest", drafts)
    told("the whole after the view came to rest", rests)
    told("our part of a redraw with strokes", VIEW.seconds[-30:])
    hands.manager().illustrate_live = False
    live_view.time = time


ALL = [measure_live] if "measure_live" in sys.argv else []
