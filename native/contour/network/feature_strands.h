// Strands from feature edges and from the silhouette edges of polygon objects.
#pragma once

#include "contour/network/joints.h"
#include "contour/network/network.h"

namespace illustrate {

// Feature edges cut where a side turns from front to back, linked into strands of one kind and one
// hiding; then the silhouettes of polygon objects.
void add_feature_strands(const Surface& surface, const std::vector<FeatureEdge>& features,
                         const std::vector<FeatureEdge>& polygon_silhouettes,
                         const ContourFunctions& functions, const Camera& camera,
                         const Joints& joints, CurveNetwork& network);

}  // namespace illustrate
