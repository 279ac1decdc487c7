// The paper's own visibility (section 4.4), for comparison: segments of silhouette are as visible
// as most of the mesh's silhouette edges near them.
//
// The labels are 0 or 1, visible or hidden. No rule ties them together: at crossings the front
// strand may change and the back strand may keep its label, at cusps it may stay the same, and the
// outside of the drawing may be hidden.
#pragma once

#include "contour/network/curve_network.h"
#include "core/progress.h"
#include "mesh/bvh.h"
#include "surface/surface.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// Nothing is repaired. Curves that are no silhouettes, and segments with no silhouette edge near
// them, are asked by a ray from their middle. Adds "crossings", "rays" and "loops" to `counts`.
LabelledGraph vote_network(const CurveNetwork& network, const Surface& surface, const Bvh& bvh,
                           const Camera& camera, Counts& counts, const Progress& progress = {});

}  // namespace illustrate
