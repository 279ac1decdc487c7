// Where three sheets of surface meet in one point: each two of them cross in a curve, which passes
// through the third.
#pragma once

#include "contour/intersection/intersections.h"

namespace illustrate {

// All of them, in a fixed order, from the curves and the insets alone.
std::vector<TriplePoint> triple_points(const Surface& surface,
                                       const IntersectionCurves& intersections,
                                       const Progress& progress = {});

}  // namespace illustrate
