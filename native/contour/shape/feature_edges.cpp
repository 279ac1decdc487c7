#include "contour/shape/feature_edges.h"

#include <algorithm>

namespace illustrate {
namespace {

Edge place_pair(const Surface& surface, const EdgeSide& side) {
  const Triangle& corners = surface.triangles[idx(side.triangle)];
  const auto place = [&](int corner) { return surface.places[idx(corners[idx(corner)])]; };
  const int a = place(side.corner), b = place(next_corner(side.corner));
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

EdgeSide opposite_side(const Surface& surface, const EdgeSide& side) {
  const int other = surface.neighbours[idx(side.triangle)][idx(side.corner)];
  if (other == none) return {};
  const auto& back = surface.neighbours[idx(other)];
  const auto is_back = [&](int k) { return back[idx(k)] == side.triangle; };
  const auto count = std::count(back.begin(), back.end(), side.triangle);
  const Edge wanted = count > 1 ? place_pair(surface, side) : Edge{};
  for (int k = 0; k < 3; ++k) {
    if (is_back(k) && (count == 1 || place_pair(surface, {other, k}) == wanted)) return {other, k};
  }
  return {};
}

std::vector<FeatureEdge> feature_edges(const Surface& surface) {
  std::vector<FeatureEdge> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const EdgeKind kind = surface.edge_kinds[t][idx(k)];
      if (kind == EdgeKind::smooth) continue;
      const EdgeSide side{static_cast<int>(t), k};
      const EdgeSide other = opposite_side(surface, side);
      if (other.triangle == none || side.triangle < other.triangle) {
        result.push_back({kind, {side, other}});
      }
    }
  }
  return result;
}

}  // namespace illustrate
