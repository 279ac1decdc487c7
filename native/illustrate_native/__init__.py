"""Line illustrations of smooth surfaces: silhouettes, visibility and hatching.

    prepared = prepare([PolygonMesh(positions, face_sizes, corner_vertices)])
    drawing = draw(prepared, Camera(projection, view, width_px, height_px))

`illustrate_native.svg` and `illustrate_native.drawing_json` write drawings to files.
"""

from illustrate_native._core import (
    Camera,
    Cancelled,
    CrossField,
    Drawing,
    DrawOptions,
    Graph,
    HatchCurves,
    InvalidInput,
    Kind,
    Light,
    Node,
    ObjectStyle,
    PolygonMesh,
    Prepared,
    PrepareOptions,
    Silhouettes,
    Surface,
    ToneMap,
    draw,
    prepare,
    silhouettes,
    solve_cross_field,
)

__version__ = "0.1.0"

__all__ = [
    "Camera",
    "Cancelled",
    "CrossField",
    "DrawOptions",
    "Drawing",
    "Graph",
    "HatchCurves",
    "InvalidInput",
    "Kind",
    "Light",
    "Node",
    "ObjectStyle",
    "PolygonMesh",
    "PrepareOptions",
    "Prepared",
    "Silhouettes",
    "Surface",
    "ToneMap",
    "draw",
    "prepare",
    "silhouettes",
    "solve_cross_field",
]
