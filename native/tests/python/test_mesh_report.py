"""Every face of a mesh file is kept or dropped for a reason that the report names."""

from __future__ import annotations

import illustrate_native as ill
import pytest
from test_meshes import MESHES, read_obj, small_files

FILES = [name for folder in ("bad", "cad", "smooth") for name in small_files(folder)]
DROPPED = ("nan_faces", "degenerate_faces", "huge_faces", "duplicate_faces")


def report_of(name: str) -> tuple[dict[str, int], ill.Prepared]:
    options = ill.PrepareOptions(scheme="none", field=False)
    prepared = ill.prepare([read_obj(MESHES / name).mesh()], options)
    return prepared.report, prepared


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
@pytest.mark.parametrize("name", FILES)
def test_every_face_is_accounted_for(name: str) -> None:
    report, prepared = report_of(name)
    assert report["input_faces"] == len(read_obj(MESHES / name).face_sizes)
    assert report["input_faces"] == report["kept_faces"] + sum(report[name] for name in DROPPED)
    assert (len(prepared.surface.triangles) > 0) == (report["kept_faces"] > 0)
    assert report["empty_meshes"] == (report["kept_faces"] == 0)


@pytest.mark.skipif(not MESHES.is_dir(), reason="the shared meshes are not beside this checkout")
def test_a_ring_with_a_bridge_is_kept() -> None:
    report, prepared = report_of("bad/concave_polygon.obj")
    assert report["kept_faces"] == report["input_faces"] == report["split_faces"] == 1
    assert report["open_edges"] == 64  # the outline and the hole; the bridge is inside
    assert len(prepared.surface.triangles) == 64
