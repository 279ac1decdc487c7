// Labels of a view of more crossings than can be settled.
#pragma once

#include "contour/network/curve_network.h"
#include "surface/surface.h"
#include "view/camera.h"
#include "visibility/labelled_graph.h"

namespace illustrate {

// Each place of a curve is hidden where the surface that is seen there is nearer, sampled once a
// pixel: 0 layers or 1, without crossings. Time in proportion to the length of the curves.
LabelledGraph label_pile(const CurveNetwork& network, const Surface& surface, const Camera& camera,
                         int threads);

}  // namespace illustrate
