"""From a scene to a drawing: reads, prepares and draws."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from . import native, settings
from .messages import IllustrateError, counted, quoted
from .scene import SceneArrays, read_scene

Progress = Callable[[float, str], bool]

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


@dataclass
class Illustration:
    """A drawing and what it was made from."""

    drawing: Any  # illustrate_native.Drawing
    arrays: SceneArrays
    warnings: list[str]
    seconds: dict[str, float] = field(default_factory=dict)  # per stage, disjoint, in order

    @property
    def names(self) -> list[str]:
        """Of the meshes, by the numbers in drawing.objects."""
        return [mesh.name for mesh in self.arrays.meshes]


def illustrate(scene: Any, depsgraph: Any, progress: Progress | None = None) -> Illustration:
    """Draws a scene with its own settings (scene.illustrate); nothing is written.

    progress(fraction of the stage, stage) is called now and then; False stops.
    Raises IllustrateError when there is no drawing to be made.
    """
    chosen = scene.illustrate
    ill = native.load()
    start = time.perf_counter()
    arrays = _read(scene, depsgraph)
    seconds = {"read": time.perf_counter() - start}
    with _explained(scene):
        prepared = _prepare(scene, arrays, progress)
        drawing = ill.draw(
            prepared,
            ill.Camera(**vars(arrays.camera)),
            settings.draw_options(chosen),
            progress=progress,
            lights=[ill.Light(**vars(light)) for light in arrays.lights],
        )
    seconds.update(prepared.timings)
    seconds.update(drawing.timings)
    warnings = _warnings(arrays, prepared.reports) + _guide_warnings(scene, arrays)
    return Illustration(drawing, arrays, warnings, seconds)


def prepare_scene(scene: Any, depsgraph: Any, progress: Progress | None = None) -> Any:
    """`illustrate_native.Prepared` of a scene with its own settings; nothing is drawn.

    Raises IllustrateError where `illustrate` does.
    """
    with _explained(scene):
        return _prepare(scene, _read(scene, depsgraph), progress)


def _read(scene: Any, depsgraph: Any) -> SceneArrays:
    chosen = scene.illustrate
    return read_scene(
        scene,
        depsgraph,
        selected_only=chosen.source == "SELECTION",
        use_lights=chosen.lighting == "SCENE",
        guides=chosen.guides,
    )


def _prepare(scene: Any, arrays: SceneArrays, progress: Progress | None) -> Any:
    ill = native.load()
    meshes = [ill.PolygonMesh(**vars(mesh)) for mesh in arrays.meshes]
    options = settings.prepare_options(scene.illustrate, arrays.guides)
    prepared = ill.prepare(meshes, options, progress=progress)
    if not len(prepared.surface.triangles):
        raise _nothing_is_left(scene, arrays, prepared.reports)
    return prepared


@contextmanager
def _explained(scene: Any) -> Iterator[None]:
    """What the native module refuses, in words for the artist."""
    try:
        yield
    except native.load().InvalidInput as error:
        raise IllustrateError(f'Scene "{scene.name}" cannot be drawn: {error}') from error


def _nothing_is_left(
    scene: Any, arrays: SceneArrays, reports: list[dict[str, Any]]
) -> IllustrateError:
    """Of scenes whose every face is broken."""
    names = quoted([mesh.name for mesh in arrays.meshes])
    found = " ".join(f"{warning}." for warning in _warnings(arrays, reports))
    return IllustrateError(
        f'Nothing in scene "{scene.name}" can be drawn: no face of {names} has an area. Check '
        f"the coordinates of the vertices and the scale of the objects. {found}".strip()
    )


def _guide_warnings(scene: Any, arrays: SceneArrays) -> list[str]:
    collection = scene.illustrate.guides
    if collection is None or arrays.guides:
        return []
    return [
        f'Collection "{collection.name}" guides nothing: it has no curve or Grease Pencil stroke '
        f"at frame {scene.frame_current}"
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
    if arrays.without_faces:
        warnings.append(
            f"Left out {counted(len(arrays.without_faces), 'object')} without faces: "
            f"{quoted(arrays.without_faces)}"
        )
    return warnings
