"""From a scene to a drawing: reads, prepares and draws.

Reading asks Blender and belongs to the main thread; computing takes plain data and runs in any
thread.
"""

import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from . import native, settings
from .cache import CACHE, Cache, digest, split_widths
from .light_arrays import LightArrays
from .mesh_arrays import MeshArrays
from .messages import IllustrateError, counted, quoted
from .scene import SceneArrays, read_scene
from .tone_images import read_tone

Progress = Callable[[float, str], bool]

PREPARING = 0.6  # share of the progress of a drawing that preparing has

# What is mended in meshes, by the names of the native reports.
REPAIRS = {
    "nan_vertices": "vertices that are not finite",
    "nan_faces": "faces at vertices that are not finite",
    "repeated_corners": "repeated corners",
    "degenerate_faces": "degenerate faces",
    "huge_faces": "faces of too many corners",
    "duplicate_faces": "duplicate faces",
    "welded_vertices": "unwelded vertices",
    "split_edges": "edges of more than two faces",
    "split_vertices": "vertices where surfaces touch",
    "flipped_faces": "flipped faces",
    "turned_parts": "parts turned inside out",
}


TURNS_WAY_OUT = ". Change the Turns of the empties among the guides, in their object properties"


@dataclass
class Request:
    """All that a drawing is made from, as plain data."""

    scene_name: str
    arrays: SceneArrays
    prepare: dict[str, Any]  # values of PrepareOptions
    draw: dict[str, Any]  # values of DrawOptions
    guide_weight: float
    warnings: list[str]
    read_seconds: float
    previous: Any = None  # the drawing whose strokes the new one starts from

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
    return compute_prepared(read_request(scene, depsgraph), progress)


def read_request(scene: Any, depsgraph: Any, rendered: Any = None) -> Request:
    """Reads what the scene's drawing is made from. Raises IllustrateError as `read_scene` does.

    rendered: (h, w) the light of a render of this frame, rows downwards, that gives tone.
    """
    chosen, start = scene.illustrate, time.perf_counter()
    arrays = read_scene(
        scene,
        depsgraph,
        selected_only=chosen.source == "SELECTION",
        use_lights=chosen.lighting == "SCENE",
        guides=chosen.guides,
    )
    if chosen.lighting == "SIDE":
        arrays.lights = [LightArrays("side", None, 1.0)]
    draw = settings.draw_values(chosen, arrays.camera.width_px)
    draw["auto_exposure"] = shares_exposure(chosen)
    size = arrays.camera.width_px, arrays.camera.height_px
    warnings: list[str] = []
    draw["tone_image"] = rendered if draw["hatching"] else None
    if rendered is None and draw["hatching"]:
        draw["tone_image"], warnings = read_tone(scene, *size)
    return Request(
        scene.name,
        arrays,
        settings.prepare_values(chosen),
        draw,
        chosen.guide_weight,
        warnings + _guide_warnings(scene, arrays),
        time.perf_counter() - start,
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
    """The illustration that a request asks for. Raises IllustrateError.

    What the cache still has of the last one is taken over. Raises `illustrate_native.Cancelled`
    when progress returned False.
    """
    start = 0.0 if cache.has(request.prepared_key) else PREPARING
    prepared = compute_prepared(request, _part(progress, 0.0, start), cache)
    drawn: list[Any] = []

    def draw() -> Any:
        drawn.append(_draw(request, prepared, _part(progress, start, 1.0)))
        return drawn[0]

    with _explained(request):
        # Strokes that start from a previous frame's are no function of the request alone.
        kept = request.previous is None
        drawing = cache.drawing(request.drawing_key, request.widths, draw) if kept else draw()
    seconds = {"read": request.read_seconds}
    seconds.update(prepared.timings if start else {})
    seconds.update(drawn[0].timings if drawn else {})
    warnings = _warnings(request.arrays, prepared.reports) + request.warnings
    warnings += _crowding(drawing.counts, prepared)
    return Illustration(drawing, prepared, request.arrays, warnings, seconds)


def compute_prepared(
    request: Request, progress: Progress | None = None, cache: Cache = CACHE
) -> Any:
    """`illustrate_native.Prepared` for a request, from the cache where it is there."""
    ill = native.load()

    def make(previous: Any) -> Any:
        meshes = native_meshes(ill, request.arrays)
        options = settings.prepare_options(
            request.prepare, request.arrays.guides, request.guide_weight
        )
        options.field = request.draw["hatching"]
        prepared = ill.prepare(meshes, options, progress=progress, previous=previous)
        if not len(prepared.surface.triangles):
            raise _nothing_is_left(request, prepared.reports)
        return prepared

    with _explained(request):
        follows = request.previous is not None
        return cache.prepared(request.prepared_key, request.meshes_key, make, follows)


def native_meshes(ill: Any, arrays: SceneArrays) -> list[Any]:
    """Meshes for `ill.prepare`: objects that have the same one are instances of it.

    But mirrored objects: their front is on the other side.
    """
    textures = {
        id(texture): ill.Texture(texture.luminance, texture.wrap)
        for mesh in arrays.meshes
        for texture in mesh.textures
    }
    if not arrays.copies:
        return [_native_mesh(ill, mesh, textures) for mesh in arrays.meshes]
    keys = [digest(copy.mesh.shape, copy.mesh.look) for copy in arrays.copies]
    counts, originals, meshes = Counter(keys), {}, []
    for key, copy, mesh in zip(keys, arrays.copies, arrays.meshes, strict=True):
        if counts[key] == 1 or not _can_share(copy.matrix):
            meshes.append(_native_mesh(ill, mesh, textures))
            continue
        if key not in originals:
            originals[key] = _native_mesh(ill, copy.mesh, textures)
        meshes.append(originals[key].instance(copy.matrix, mesh.name, mesh.edge_length))
    return meshes


def _native_mesh(ill: Any, mesh: MeshArrays, textures: dict[int, Any]) -> Any:
    """textures: the native ones by the identity of their arrays."""
    values = dict(vars(mesh))
    values["textures"] = [textures[id(texture)] for texture in mesh.textures]
    return ill.PolygonMesh(**values)


def _can_share(matrix: Any) -> bool:
    is_affine = np.isfinite(matrix).all() and (matrix[3] == (0, 0, 0, 1)).all()
    return bool(is_affine and np.linalg.det(matrix[:3, :3]) > 0)


def _draw(request: Request, prepared: Any, progress: Progress | None) -> Any:
    ill = native.load()
    arrays = request.arrays
    last = getattr(request.previous, "original", request.previous)
    seeds = {"previous": last} if last is not None else {}
    return ill.draw(
        prepared,
        ill.Camera(**vars(arrays.camera)),
        settings.draw_options(request.draw, arrays.styles),
        progress=progress,
        lights=[ill.Light(**vars(light)) for light in arrays.lights],
        **seeds,
    )


def _part(progress: Progress | None, start: float, end: float) -> Progress | None:
    """Progress of a part [start, end] of the whole."""
    if progress is None:
        return None
    return lambda fraction, stage: progress(start + (end - start) * fraction, stage)


@contextmanager
def _explained(request: Request) -> Iterator[None]:
    """What the native module refuses, in words for the artist."""
    try:
        yield
    except native.load().InvalidInput as error:
        way_out = TURNS_WAY_OUT if request.arrays.guides.turns and "singular" in str(error) else ""
        raise IllustrateError(
            f'Scene "{request.scene_name}" cannot be drawn: {error}{way_out}'
        ) from error


def _nothing_is_left(request: Request, reports: list[dict[str, Any]]) -> IllustrateError:
    """Of scenes whose every face is broken."""
    names = quoted([mesh.name for mesh in request.arrays.meshes])
    found = " ".join(f"{warning}." for warning in _warnings(request.arrays, reports))
    return IllustrateError(
        f'Nothing in scene "{request.scene_name}" can be drawn: no face of {names} has an area. '
        f"Check the coordinates of the vertices and the scale of the objects. {found}".strip()
    )


def _guide_warnings(scene: Any, arrays: SceneArrays) -> list[str]:
    collection = scene.illustrate.guides
    if collection is None or arrays.guides:
        return []
    return [
        f'Collection "{collection.name}" guides nothing: it has no curve, Grease Pencil stroke '
        f"at frame {scene.frame_current}, or empty that turns hatches"
    ]


def _warnings(arrays: SceneArrays, reports: list[dict[str, Any]]) -> list[str]:
    """What the artist should know about the meshes: those mended, and those left out."""
    warnings = []
    mended = [report for report in reports if any(report.get(name) for name in REPAIRS)]
    if mended:
        counts = {
            text: sum(report.get(name, 0) for report in mended) for name, text in REPAIRS.items()
        }
        listed = ", ".join(f"{count} {text}" for text, count in counts.items() if count)
        warnings.append(
            f"Mended {counted(len(mended), 'mesh', 'meshes')}, "
            f"{quoted([report['name'] for report in mended])}: {listed}"
        )
    if arrays.partly_read:
        names = quoted(arrays.partly_read)
        warnings.append(
            f"Of {counted(len(arrays.partly_read), 'material')} ({names}) the nodes are followed "
            "in part: give it a base colour, an image through a UV map or a viewport colour, or "
            "lower Materials"
        )
    for name, problem in arrays.unread_images.items():
        warnings.append(f'Image "{name}" counts as white: {problem}')
    if arrays.left_out:
        warnings.append(f"Left out {', '.join(map(_named, arrays.left_out.items()))}")
    return warnings


def _crowding(counts: dict[str, int], prepared: Any) -> list[str]:
    """What the artist should know of a view with too many crossings."""
    if not counts.get("sampled_views", 0):
        return []
    sampled = "what hides what was sampled once a pixel"
    pairs = prepared.left_out_intersections
    if pairs:
        meshes = sorted({mesh for pair in pairs for mesh in pair})
        names = quoted([prepared.reports[mesh]["name"] for mesh in meshes])
        return [
            f"Surfaces pass through each other in too many places: the lines there were left out "
            f"of {names}, and {sampled}. Ignore them, in their styles, or raise Crossings, "
            "under Surface and Field"
        ]
    return [
        f"There are over 200,000 crossings of lines: {sampled}. "
        "Ignore objects, in their styles, of which single lines cannot be told, such as fur"
    ]


def _named(kind_and_names: tuple[str, list[str]]) -> str:
    """Such as '2 volumes ("Fog", "Smoke")'."""
    kind, names = kind_and_names
    plural = kind.replace("object", "objects") if kind.startswith("object") else ""
    return f"{counted(len(names), kind, plural)} ({quoted(list(dict.fromkeys(names)))})"
