// Strands from cut curves: the parts of `build_network`.
#pragma once

#include "contour/joints.h"
#include "contour/network.h"

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

// Feature edges cut where a side turns from front to back, linked into strands of one kind and one
// hiding; then the silhouettes of polygon objects.
void add_feature_strands(const Surface& surface, const std::vector<FeatureEdge>& features,
                         const std::vector<FeatureEdge>& polygon_silhouettes,
                         const ContourFunctions& functions, const Camera& camera,
                         const Joints& joints, CurveNetwork& network);

// The network cut off at the near plane; nodes that lose strands become ends or disappear.
CurveNetwork clip_near(const Surface& surface, const CurveNetwork& network, const Camera& camera);

}  // namespace illustrate
