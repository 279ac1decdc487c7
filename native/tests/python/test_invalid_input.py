"""Arguments that cannot be used raise InvalidInput, which names the argument and the index."""

from __future__ import annotations

from typing import Any

import illustrate_native as ill
import numpy as np
import pytest
from shapes import cube, look_at, torus

BOX = cube()


@pytest.fixture(scope="module")
def prepared() -> ill.Prepared:
    return ill.prepare([torus().mesh()], ill.PrepareOptions(level=1, field=False))


def changed(array: Any, index: int, value: Any) -> Any:
    copy = np.array(array)
    copy.reshape(-1)[index] = value
    return copy


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"corner_vertices": changed(BOX.corner_vertices, 5, 8)},
         r"corner_vertices\[5\] = 8 is out of range: there are 8 positions"),
        ({"corner_vertices": changed(BOX.corner_vertices, 5, -1)}, r"corner_vertices\[5\]"),
        ({"corner_vertices": np.asarray(BOX.corner_vertices, float)},
         "corner_vertices must hold integers, but holds float64"),
        ({"corner_vertices": [2**40] + [0] * 23}, r"corner_vertices\[0\] is out of range"),
        ({"face_sizes": changed(BOX.face_sizes, 0, 5)}, "face_sizes"),
        ({"face_sizes": changed(BOX.face_sizes, 0, -4)}, r"face_sizes\[0\]"),
        ({"positions": BOX.positions[:, :2]}, r"positions has shape \(8, 2\), expected \(n, 3\)"),
        ({"positions": [["a", "b", "c"]]}, "positions must hold numbers"),
        ({"positions": [[1, 2, 3], [4]]}, "positions cannot be read as an array"),
        ({"edge_vertices": [[0, 1], [1, 3]], "edge_sharpness": [1.0]}, "edge_sharpness"),
        ({"edge_vertices": [[0, 99]], "edge_sharpness": [1.0]}, r"edge_vertices\[0\]"),
        ({"vertex_sharpness": [1.0]}, "vertex_sharpness"),
        ({"face_materials": [0]}, "face_materials"),
        ({"corner_normals": [[0, 0, 1]]}, r"corner_normals \(1\) must match the number of corners"),
        ({"corner_normals": [0, 0, 1]}, r"corner_normals has shape \(3,\), expected \(n, 3\)"),
        ({"hole_faces": [6]}, r"hole_faces\[0\]"),
        ({"marked_edges": [0, 1]}, r"marked_edges has shape \(2,\), expected \(n, 2\)"),
        ({"boundary": "none"}, "boundary is 'none'"),
        ({"scheme": "doo-sabin"}, "scheme is 'doo-sabin'"),
    ],
)  # fmt: skip
def test_wrong_mesh_arguments_are_named(arguments: dict[str, Any], message: str) -> None:
    whole = {"positions": BOX.positions, "face_sizes": BOX.face_sizes,
             "corner_vertices": BOX.corner_vertices}  # fmt: skip
    with pytest.raises(ill.InvalidInput, match=message):
        ill.PolygonMesh(**{**whole, **arguments})


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"projection": np.full((4, 4), np.nan)}, "camera.projection"),
        ({"projection": np.zeros((4, 4))}, "camera.projection is singular"),
        ({"view": np.eye(3)}, r"camera.view has shape \(3, 3\), expected \(4, 4\)"),
        ({"width_px": 0}, "camera.width_px must be at least 1"),
        ({"height_px": -5}, "camera.height_px must be at least 1"),
        ({"width_px": 512.0}, "camera.width_px must be an integer"),
    ],
)
def test_unusable_cameras_are_named(arguments: dict[str, Any], message: str) -> None:
    good = look_at()
    whole = {"projection": good.projection, "view": good.view, "width_px": 64, "height_px": 64}
    with pytest.raises(ill.InvalidInput, match=message):
        ill.Camera(**{**whole, **arguments})


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"spacing_px": 0.0}, "spacing_px"),
        ({"speck_px": -1.0}, "speck_px"),
        ({"cell_px": 0.0}, "cell_px"),
        ({"threads": -1}, "threads"),
        ({"highlight_share": 1.5}, "highlight_share"),
        ({"highlight_share": 0.8, "shadow_share": 0.8}, "shadow_share"),
        ({"extra_levels": 4}, "extra_levels"),
        ({"suggestive_threshold": 0.0}, "suggestive_threshold"),
        ({"ridge_threshold": -1.0}, "ridge_threshold"),
        ({"valley_threshold": float("nan")}, "valley_threshold"),
        ({"styles": [ill.ObjectStyle()] * 3}, "styles has 3 entries but there are 1 meshes"),
        ({"styles": [1]}, r"styles\[0\] is not an ObjectStyle"),
        ({"styles": [ill.ObjectStyle(width_scale=-1)]}, r"styles\[0\].width_scale"),
        ({"hidden_lines": (3, 1)}, "hidden_lines"),
    ],
)
def test_wrong_options_are_named(
    prepared: ill.Prepared, options: dict[str, Any], message: str
) -> None:
    with pytest.raises(ill.InvalidInput, match=message):
        ill.draw(prepared, look_at(), ill.DrawOptions(**options))


def test_wrong_things_in_lists_are_named(prepared: ill.Prepared) -> None:
    with pytest.raises(ill.InvalidInput, match=r"meshes\[1\] is not a PolygonMesh"):
        ill.prepare([cube().mesh(), "cube"])  # type: ignore[list-item]
    with pytest.raises(ill.InvalidInput, match=r"lights\[0\] is not a Light"):
        ill.draw(prepared, look_at(), lights=["sun"])  # type: ignore[list-item]
    with pytest.raises(ill.InvalidInput, match=r"light\.kind is 'moon'"):
        ill.Light("moon")
    with pytest.raises(ill.InvalidInput, match=r"light.vector .* 'sun'"):
        ill.Light("sun")
    with pytest.raises(ill.InvalidInput, match="level"):
        ill.prepare([cube().mesh()], ill.PrepareOptions(level=-2))
    with pytest.raises(ill.InvalidInput, match="progress"):
        ill.prepare([cube().mesh()], progress=1)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("faces", "uv", "message"),
    [
        ([6], [[0.5, 0.5]], "base_faces: 6 is none of the 6 faces"),
        ([-1], [[0.5, 0.5]], "base_faces: -1"),
        ([0], [[0.5, 1.5]], "base_uv: .* lies outside face 0"),
        ([0], [[0.5, float("nan")]], "base_uv"),
        ([0, 1], [[0.5, 0.5]], "same length"),
        ([0], [0.5, 0.5], "base_uv"),
        ([0.5], [[0.5, 0.5]], "base_faces"),
    ],
)
def test_wrong_places_on_the_limit_surface_are_named(faces: Any, uv: Any, message: str) -> None:
    surface = ill.prepare([cube().mesh()], ill.PrepareOptions(level=0, field=False)).surface
    with pytest.raises(ill.InvalidInput, match=message):
        surface.evaluate(faces, uv)


def test_polygons_have_no_limit_surface() -> None:
    options = ill.PrepareOptions(scheme="none", field=False)
    with pytest.raises(ill.InvalidInput, match="scheme 'none'"):
        ill.prepare([cube().mesh()], options).surface.evaluate([0], [[0.5, 0.5]])
