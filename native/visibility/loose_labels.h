// Curves that lie on no surface in the labelled graph: cut where what hides them may change, and
// asked by rays.
//
// What is in front of such a curve changes where another curve that hides something passes in front
// of it, and where it pierces the surface. Between two such places the number of layers is one, and
// rays from three places tell it: the middle count is taken. There is no doubt about a surface of
// its own, which makes rays unreliable for all other curves. It hides nothing, so no other label
// depends on it.
#pragma once

#include "contour/network/curve_network.h"
#include "mesh/bvh.h"
#include "surface/surface.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// A graph in the camera's pixels with the curves (contour/shape/loose_curves.h) added: arcs of
// Kind::loose between ends and joints; where labels change there is a joint, which the curve in
// front is not cut at. What is less than a unit of the graph in front of a curve does not hide it,
// so that curves drawn on a surface are seen. Parts before the near plane are left out.
LabelledGraph with_loose_curves(LabelledGraph graph, const CurveNetwork& curves,
                                const Surface& surface, const Bvh& bvh, const Camera& camera);

}  // namespace illustrate
