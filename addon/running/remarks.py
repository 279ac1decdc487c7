"""What the artist should know of a drawing: what was mended, read in part, left out or sampled."""

from collections.abc import Iterator
from typing import Any

from ..messages import amount, quoted, said
from ..reading.scene import SceneArrays

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


def of_guides(scene: Any, arrays: SceneArrays) -> list[str]:
    """A word about a collection of guides that guides nothing."""
    collection = scene.illustrate.guides
    if collection is None or arrays.guides:
        return []
    return [
        said(
            'Collection "{name}" guides nothing: it has no curve, Grease Pencil stroke at frame '
            "{frame}, or empty that turns hatches",
            name=collection.name,
            frame=scene.frame_current,
        )
    ]


def of_meshes(arrays: SceneArrays, reports: list[dict[str, Any]]) -> list[str]:
    """What the artist should know about the meshes: those mended, and those left out."""
    warnings = [*_of_repairs(reports), *_of_materials(arrays.partly_read), *_of_alpha(arrays)]
    for name, problem in arrays.unread_images.items():
        warnings.append(
            said('Image "{name}" counts as white: {problem}', name=name, problem=problem)
        )
    for name, problem in arrays.unusable_lights.items():
        warnings.append(
            said('Light "{name}" gives no light: {problem}', name=name, problem=problem)
        )
    if arrays.left_out:
        things = ", ".join(map(_named, arrays.left_out.items()))
        warnings.append(said("Left out {things}", things=things))
    return warnings


def _of_repairs(reports: list[dict[str, Any]]) -> Iterator[str]:
    mended = [report for report in reports if any(report.get(name) for name in REPAIRS)]
    counts = {text: sum(report.get(name, 0) for report in mended) for name, text in REPAIRS.items()}
    if mended:
        yield said(
            "Mended {meshes}, {names}: {listed}",
            meshes=amount(len(mended), "mesh", "meshes"),
            names=quoted([report["name"] for report in mended]),
            listed=", ".join(f"{n} {said(text)}" for text, n in counts.items() if n),
        )


def _of_materials(partly_read: list[str]) -> Iterator[str]:
    if partly_read:
        yield said(
            "Of {materials} ({names}) the nodes are followed in part: give it a base colour, an "
            "image through a UV map or a viewport colour, or lower Materials",
            **_materials(partly_read),
        )


def _of_alpha(arrays: SceneArrays) -> Iterator[str]:
    """Of materials that are not cut out as nodes say, and of those that are, but coarsely."""
    if arrays.drawn_whole:
        yield said(
            "Of {materials} ({names}) nodes say where it is clear, and are not followed: it is "
            "drawn whole. Link an image's alpha through a UV map, or have its style for materials "
            "ignore it",
            **_materials(arrays.drawn_whole),
        )
    for name, problem in arrays.uncut.items():
        yield said('Material "{name}" is drawn whole: {problem}', name=name, problem=problem)
    if arrays.coarsely_cut:
        yield said(
            "Cut By Alpha follows the images on {objects} ({names}) coarsely, there are so many "
            "outlines: divide it into several, or switch the setting off under Surface and Field",
            objects=amount(len(arrays.coarsely_cut), "object"),
            names=quoted(arrays.coarsely_cut),
        )


def _materials(names: list[str]) -> dict[str, str]:
    """How many, and which."""
    return {"materials": amount(len(names), "material"), "names": quoted(names)}


def of_crowding(counts: dict[str, int], prepared: Any) -> list[str]:
    """What the artist should know of a view with too many crossings."""
    if not counts.get("sampled_views", 0):
        return []
    pairs = prepared.left_out_intersections
    if pairs:
        meshes = sorted({mesh for pair in pairs for mesh in pair})
        names = quoted([prepared.reports[mesh]["name"] for mesh in meshes])
        return [
            said(
                "Surfaces pass through each other in too many places: the lines there were left "
                "out of {names}, and what hides what was sampled once a pixel. Ignore them, in "
                "their styles, or raise Crossings, under Surface and Field",
                names=names,
            )
        ]
    return [
        said(
            "There are over a million crossings of lines: what hides what was sampled once a "
            "pixel. Ignore objects, in their styles, of which single lines cannot be told, such as "
            "fur"
        )
    ]


def _named(kind_and_names: tuple[str, list[str]]) -> str:
    """Such as '2 volumes ("Fog", "Smoke")'."""
    kind, names = kind_and_names
    several = amount(len(names), kind, plural_of(kind))
    return f"{several} ({quoted(list(dict.fromkeys(names)))})"


def plural_of(kind: str) -> str:
    """Of a kind of thing that cannot be drawn."""
    return kind.replace("object", "objects") if kind.startswith("object") else f"{kind}s"
