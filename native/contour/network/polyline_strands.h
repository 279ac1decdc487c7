// Strands from silhouettes, intersection curves and free lines: polylines cut at joints.
#pragma once

#include "contour/network/joints.h"
#include "contour/network/network.h"

namespace illustrate {

// Silhouette chains cut at their joints; ties at cusps (paper section 4.2) and where a chain passes
// over a mark or a curvature curve.
void add_silhouette_strands(const Surface& surface, const Silhouettes& silhouettes,
                            const Joints& joints, CurveNetwork& network);

// Self-intersection curves cut at their joints.
void add_intersection_strands(const Surface& surface, const IntersectionCurves& intersections,
                              const Joints& joints, CurveNetwork& network);

// Free lines cut at their joints; a piece of a ridge that is seen from its other side is a valley.
// Kinds of curvature that are not wanted are left out.
void add_free_strands(const Surface& surface, const FreeLines& free_lines,
                      const CurvatureCurveOptions& options, const Joints& joints,
                      CurveNetwork& network);

}  // namespace illustrate
