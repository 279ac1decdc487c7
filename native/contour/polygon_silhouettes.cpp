#include "contour/polygon_silhouettes.h"

#include "contour/contour_functions.h"

namespace illustrate {
namespace {

std::vector<EdgeSide> all_sides(const Surface& surface) {
  std::vector<EdgeSide> sides;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (surface.is_smooth_at(t)) continue;
    for (int k = 0; k < 3; ++k) sides.push_back({t, k});
  }
  return sides;
}

}  // namespace

std::optional<FeatureEdge> polygon_edge(const Surface& surface, const EdgeSide& side) {
  if (surface.edge_kinds[idx(side.triangle)][idx(side.corner)] != EdgeKind::smooth) return {};
  const EdgeSide other = opposite_side(surface, side);
  if (other.triangle == none || other.triangle < side.triangle) return {};
  return FeatureEdge{EdgeKind::smooth, {side, other}};
}

PolygonSilhouettes polygon_silhouettes(const Surface& surface, const Camera& camera,
                                       const DualSurface* dual) {
  PolygonSilhouettes result;
  for (const EdgeSide& side : dual ? dual->edges(camera) : all_sides(surface)) {
    const std::optional<FeatureEdge> edge = polygon_edge(surface, side);
    if (!edge) continue;
    ++result.edges_visited;
    const bool front = is_front_face(surface, camera, side.triangle);
    if (front != is_front_face(surface, camera, edge->sides[1].triangle)) {
      result.edges.push_back(*edge);
    }
  }
  return result;
}

}  // namespace illustrate
