"""Line illustrations of smooth surfaces: silhouettes, visibility and hatching.

    prepared = prepare([PolygonMesh(positions, face_sizes, corner_vertices)])
    drawing = draw(prepared, Camera(projection, view, width_px, height_px))
    for drawing in draw_sequence(meshes, cameras, positions): ...

Lengths are in pixels; `lengths_in_pixels` gives them from millimetres on paper.
`illustrate_native.svg` and `illustrate_native.drawing_json` write drawings to files.
"""

from ._core import (
    Camera,
    Cancelled,
    CrossField,
    Drawing,
    DrawOptions,
    Graph,
    Guide,
    HatchCurves,
    InvalidInput,
    Job,
    Kind,
    Light,
    MaterialStyle,
    Node,
    ObjectStyle,
    PolygonMesh,
    Prepared,
    PrepareOptions,
    Silhouettes,
    Surface,
    Texture,
    ToneMap,
    View,
    draw,
    prepare,
    rasterise,
    rough_features,
    rough_silhouettes,
    silhouettes,
    solve_cross_field,
    start_draw,
    start_prepare,
    start_view,
    stop_jobs,
    view,
)
from .millimetres import lengths_in_pixels
from .sequence import draw_sequence

__version__ = "0.1.0"

__all__ = [
    "Camera",
    "Cancelled",
    "CrossField",
    "DrawOptions",
    "Drawing",
    "Graph",
    "Guide",
    "HatchCurves",
    "InvalidInput",
    "Job",
    "Kind",
    "Light",
    "MaterialStyle",
    "Node",
    "ObjectStyle",
    "PolygonMesh",
    "PrepareOptions",
    "Prepared",
    "Silhouettes",
    "Surface",
    "Texture",
    "ToneMap",
    "View",
    "draw",
    "draw_sequence",
    "lengths_in_pixels",
    "prepare",
    "rasterise",
    "rough_features",
    "rough_silhouettes",
    "silhouettes",
    "solve_cross_field",
    "start_draw",
    "start_prepare",
    "start_view",
    "stop_jobs",
    "view",
]
