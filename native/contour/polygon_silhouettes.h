// Silhouettes of polygon objects: mesh edges between a front and a back face (paper section 4.3).
#pragma once

#include <optional>

#include "contour/dual/dual_surface.h"

namespace illustrate {

// The edge of a side of a polygon object where it could be a silhouette: smooth, between two faces,
// seen from the triangle of the lower number, so that each edge is there once.
std::optional<FeatureEdge> polygon_edge(const Surface& surface, const EdgeSide& side);

struct PolygonSilhouettes {
  std::vector<FeatureEdge> edges;  // in the order of their first sides
  std::int64_t edges_visited = 0;  // whose faces were looked at
};

// `dual`: of the same surface; null: all edges of polygon objects are looked at.
PolygonSilhouettes polygon_silhouettes(const Surface& surface, const Camera& camera,
                                       const DualSurface* dual);

}  // namespace illustrate
