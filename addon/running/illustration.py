"""From a scene to a drawing: reads, prepares and draws.

Reading asks Blender; computing takes plain data and runs beside Blender, as jobs.
"""

import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from .. import native
from ..messages import IllustrateError, quoted, said
from ..reading.light_arrays import LightArrays
from ..reading.mesh_arrays import MeshArrays
from ..reading.scene import CameraArrays, SceneArrays, read_lights, read_scene, unusable_lights
from ..reading.tone_images import read_tone
from ..settings import scene_settings as settings
from . import remarks
from .cache import CACHE, Cache, digest, split_widths
from .jobs import Progress, Step, Steps, run

# Shares of the progress of a drawing, by the end of preparing, and of the view
PREPARED, VIEWED = 0.6, 0.8

TURNS_WAY_OUT = "Change the Turns of the empties among the guides, in their object properties"


@dataclass
class Request:
    """All that a drawing is made from, as plain data."""

    scene_name: str
    arrays: SceneArrays
    prepare: dict[str, Any]  # values of PrepareOptions
    draw: dict[str, Any]  # values of DrawOptions
    guide_weight: float
    warnings: list[str]
    read_seconds: float = 0.0
    previous: Any = None  # the drawing whose strokes the new one starts from
    follows: bool = False  # it is to start from a drawing that may not be there yet
    view: Any = None  # illustrate_native.View, where it was made ahead of the drawing
    is_prepared_anew: bool = False

    def expose_as(self, drawing: Any) -> None:
        """The light as strong as in another drawing, so that a sequence does not flicker.

        Nothing where the exposure is not automatic, and where there is no other drawing.
        """
        self.expose(None if drawing is None else drawing.tone.exposure)

    def expose(self, exposure: float | None) -> None:
        """The same with the exposure that another drawing had (ToneMap.exposure), or None."""
        if exposure is not None and self.draw["auto_exposure"]:
            self.draw |= {"auto_exposure": False, "exposure": exposure}

    @cached_property
    def meshes_key(self) -> str:
        """A digest of the shapes of the meshes alone."""
        return digest([mesh.shape for mesh in self.arrays.meshes])

    @cached_property
    def prepared_key(self) -> str:
        """A digest of all that preparing depends on."""
        values = {name: value for name, value in self.prepare.items() if name != "threads"}
        looks = [mesh.look for mesh in self.arrays.meshes]
        return digest(self.meshes_key, looks, self.arrays.guides, self.guide_weight, values)

    @cached_property
    def drawing_key(self) -> str:
        """A digest of all that the drawing depends on besides `widths`."""
        return digest(self.prepared_key, self.arrays.camera, self.arrays.lights, self._styling[1])

    @property
    def widths(self) -> dict[str, Any]:
        """How wide strokes are."""
        return self._styling[0]

    @cached_property
    def _styling(self) -> tuple[dict[str, Any], list[Any]]:
        return split_widths(self.draw, self.arrays.styles)


@dataclass
class Illustration:
    """A drawing and what it was made from."""

    drawing: Any  # illustrate_native.Drawing
    prepared: Any  # illustrate_native.Prepared
    arrays: SceneArrays
    warnings: list[str]
    seconds: dict[str, float] = field(default_factory=dict)  # per stage, disjoint, in order
    regions: list[Any] | None = None  # what is seen of objects, once asked for (plot/areas.py)

    @property
    def names(self) -> list[str]:
        """Of the meshes, by the numbers in drawing.objects."""
        return [mesh.name for mesh in self.arrays.meshes]


def illustrate(scene: Any, depsgraph: Any, progress: Progress | None = None) -> Illustration:
    """Draws a scene with its own settings (scene.illustrate); nothing is written, or rendered.

    progress(fraction of the whole, stage) is called now and then; False stops.
    Raises IllustrateError when there is no drawing to be made.
    """
    return compute(read_request(scene, depsgraph), progress)


def prepare_scene(scene: Any, depsgraph: Any, progress: Progress | None = None) -> Any:
    """`illustrate_native.Prepared` of a scene with its own settings; nothing is drawn.

    Raises IllustrateError where `illustrate` does.
    """
    return run(preparing(read_request(scene, depsgraph)), progress)


def read_request(scene: Any, depsgraph: Any, rendered: Any = None) -> Request:
    """Reads what the scene's drawing is made from. Raises IllustrateError as `read_scene` does.

    rendered: (h, w) the light of a render of this frame, rows downwards, that gives tone.
    """
    start = time.perf_counter()
    request = request_of(scene, read_arrays(scene, depsgraph), rendered)
    request.read_seconds = time.perf_counter() - start
    return request


def read_arrays(
    scene: Any, depsgraph: Any, camera: CameraArrays | None = None, in_world: bool = True
) -> SceneArrays:
    """The scene as its settings have it read; camera, in_world: as `read_scene` has them."""
    chosen = scene.illustrate
    selected_only = chosen.source == "SELECTION"
    arrays = read_scene(
        scene, depsgraph, selected_only, False, chosen.guides, camera, in_world=in_world
    )
    arrays.lights = lights_of(scene, depsgraph)
    if chosen.lighting == "SCENE":
        arrays.unusable_lights = unusable_lights(depsgraph)
    return arrays


def lights_of(scene: Any, depsgraph: Any) -> list[LightArrays]:
    """The lights that the settings choose; none: a headlight."""
    if scene.illustrate.lighting == "SIDE":
        return [LightArrays("side", None, 1.0)]
    return read_lights(scene, depsgraph) if scene.illustrate.lighting == "SCENE" else []


def request_of(scene: Any, arrays: SceneArrays, rendered: Any = None) -> Request:
    """What has been read, with the settings as they are now."""
    chosen, camera = scene.illustrate, arrays.camera
    draw = settings.draw_values(chosen, camera.width_px)
    draw["auto_exposure"] = shares_exposure(chosen)
    warnings: list[str] = []
    draw["tone_image"] = rendered if draw["hatching"] else None
    if rendered is None and draw["hatching"]:
        draw["tone_image"], warnings = read_tone(scene, camera.width_px, camera.height_px)
    return Request(
        scene.name,
        arrays,
        settings.prepare_values(chosen),
        draw,
        chosen.guide_weight,
        warnings + remarks.of_guides(scene, arrays),
    )


def shares_exposure(chosen: Any) -> bool:
    """True where the settings have the exposure found, once for the frames of a sequence."""
    is_lit = chosen.lighting == "SCENE" or chosen.tone_source != "LIGHTS"
    return bool(is_lit and chosen.auto_exposure)


def hatches_render(chosen: Any) -> bool:
    """True where the settings have the scene rendered first, and that hatched."""
    return bool(chosen.hatching and chosen.tone_source == "RENDER")


def compute(
    request: Request, progress: Progress | None = None, cache: Cache = CACHE
) -> Illustration:
    """The illustration that a request asks for, at once. Raises IllustrateError.

    Raises `illustrate_native.Cancelled` when progress returned False.
    """
    return run(computing(request, cache=cache), progress)


def computing(
    request: Request,
    share: tuple[float, float] = (0.0, 1.0),
    title: str = "",
    cache: Cache = CACHE,
) -> Steps[Illustration]:
    """The same in steps, whose progress is a share of all. What the cache has is taken over."""
    is_prepared, (start, end) = cache.has(request.prepared_key), share
    between = start if is_prepared else start + PREPARED * (end - start)
    prepared = yield from preparing(request, (start, between), title, cache)
    before = {} if request.is_prepared_anew else prepared.timings
    with _explained(request):
        # Strokes that start from a previous frame's are no function of the request alone.
        is_kept = request.previous is None
        drawing: Any = cache.drawing(request.drawing_key, request.widths) if is_kept else None
        is_drawn = drawing is None
        if is_drawn:
            drawing = yield Step(start_drawing(request, prepared), between, end, title)
        if is_drawn and is_kept:
            cache.keep_drawing(request.drawing_key, request.widths, drawing)
    seconds = {"read": request.read_seconds}
    # What only some drawings need is prepared as they are drawn.
    for stage, spent in prepared.timings.items():
        spent -= before.get(stage, 0.0)
        if request.is_prepared_anew or spent > 0.0:
            seconds[stage] = spent
    seconds.update(drawing.timings if is_drawn else {})
    warnings = remarks.of_meshes(request.arrays, prepared.reports) + request.warnings
    warnings += remarks.of_crowding(drawing.counts, prepared)
    return Illustration(drawing, prepared, request.arrays, warnings, seconds)


def viewing(
    request: Request, share: tuple[float, float] = (0.0, 1.0), title: str = "", cache: Cache = CACHE
) -> Steps[None]:
    """Makes the view of a request ahead of its drawing, where that is not in the cache."""
    start, end = share
    between = start + PREPARED / VIEWED * (end - start)
    prepared = yield from preparing(request, (start, between), title, cache)
    if not request.follows and cache.drawing(request.drawing_key, request.widths) is not None:
        return
    with _explained(request):
        request.view = yield Step(start_view(request, prepared), between, end, title)


def preparing(
    request: Request,
    share: tuple[float, float] = (0.0, 1.0),
    title: str = "",
    cache: Cache = CACHE,
) -> Steps[Any]:
    """`illustrate_native.Prepared` for a request, from the cache where it is there."""
    prepared = cache.prepared(request.prepared_key)
    if prepared is not None:
        return prepared
    with _explained(request):
        follows = request.follows or request.previous is not None
        previous = cache.last_prepared(request.meshes_key, follows)
        prepared = yield Step(start_preparing(request, previous), *share, title)
        if not len(prepared.surface.triangles):
            raise _nothing_is_left(request, prepared.reports)
        cache.keep_prepared(request.prepared_key, request.meshes_key, prepared)
        request.is_prepared_anew = True
    return prepared


def start_preparing(request: Request, previous: Any) -> Any:
    """The job that prepares a request."""
    ill = native.load()
    options = settings.prepare_options(request.prepare, request.arrays.guides, request.guide_weight)
    options.field = request.draw["hatching"]
    return ill.start_prepare(native_meshes(ill, request.arrays), options, previous=previous)


def start_view(request: Request, prepared: Any) -> Any:
    """The job that finds lines and tones of a request."""
    return native.load().start_view(prepared, *_view_arguments(request))


def start_drawing(request: Request, prepared: Any, detail: str = "whole") -> Any:
    """The job that draws a request; less than the whole (View.draw) only of one with a view."""
    previous = getattr(request.previous, "original", request.previous)
    if request.view is not None:
        return request.view.start_draw(previous, detail)
    return native.load().start_draw(prepared, *_view_arguments(request), previous=previous)


def _view_arguments(request: Request) -> tuple[Any, Any, list[Any]]:
    """Camera, options and lights, for the native module."""
    ill, arrays = native.load(), request.arrays
    return (
        ill.Camera(**vars(arrays.camera)),
        settings.draw_options(request.draw, arrays.styles),
        [ill.Light(**vars(light)) for light in arrays.lights],
    )


def native_meshes(ill: Any, arrays: SceneArrays) -> list[Any]:
    """Meshes for `ill.prepare`: objects that have the same one are instances of it.

    But mirrored objects: their front is on the other side.
    """
    textures = {
        id(texture): ill.Texture(texture.luminance, texture.wrap)
        for mesh in arrays.meshes
        for texture in mesh.textures
    }
    if len(arrays.copies) < 2:
        return [_native_mesh(ill, mesh, textures) for mesh in arrays.meshes]
    keys = [digest(copy.mesh.shape, copy.mesh.look) for copy in arrays.copies]
    counts, originals, meshes = Counter(keys), {}, []
    finest = _finest_edges(keys, arrays)
    for key, copy, mesh in zip(keys, arrays.copies, arrays.meshes, strict=True):
        if counts[key] == 1 or not _can_share(copy.matrix):
            meshes.append(_native_mesh(ill, mesh, textures))
            continue
        if key not in originals:
            original = replace(copy.mesh, edge_length=finest.get(key))
            originals[key] = _native_mesh(ill, original, textures)
        meshes.append(originals[key].instance(copy.matrix, mesh.name, mesh.edge_length))
    return meshes


def _finest_edges(keys: list[str], arrays: SceneArrays) -> dict[str, float]:
    """The shortest edges that any object with the same mesh asks for, in units of that mesh."""
    finest: dict[str, float] = {}
    for key, copy, mesh in zip(keys, arrays.copies, arrays.meshes, strict=True):
        scale = abs(np.linalg.det(copy.matrix[:3, :3])) ** (1 / 3)
        if mesh.edge_length is not None and scale > 0:
            length = float(mesh.edge_length / scale)
            finest[key] = min(length, finest.get(key, length))
    return finest


def _native_mesh(ill: Any, mesh: MeshArrays, textures: dict[int, Any]) -> Any:
    """textures: the native ones by the identity of their arrays."""
    values = dict(vars(mesh))
    values["textures"] = [textures[id(texture)] for texture in mesh.textures]
    return ill.PolygonMesh(**values)


def _can_share(matrix: Any) -> bool:
    is_affine = np.isfinite(matrix).all() and (matrix[3] == (0, 0, 0, 1)).all()
    return bool(is_affine and np.linalg.det(matrix[:3, :3]) > 0)


@contextmanager
def _explained(request: Request) -> Iterator[None]:
    """What the native module refuses, in words for the artist."""
    try:
        yield
    except native.load().InvalidInput as error:
        told = said(
            'Scene "{scene}" cannot be drawn: {error}', scene=request.scene_name, error=error
        )
        if request.arrays.guides.turns and "singular" in str(error):
            told += f". {said(TURNS_WAY_OUT)}"
        raise IllustrateError(told) from error


def _nothing_is_left(request: Request, reports: list[dict[str, Any]]) -> IllustrateError:
    """Of scenes whose every face is broken."""
    names = quoted([mesh.name for mesh in request.arrays.meshes])
    told = said(
        'Nothing in scene "{scene}" can be drawn: no face of {names} has an area. Check the '
        "coordinates of the vertices and the scale of the objects.",
        scene=request.scene_name,
        names=names,
    )
    found = [f"{warning}." for warning in remarks.of_meshes(request.arrays, reports)]
    return IllustrateError(" ".join([told, *found]))
