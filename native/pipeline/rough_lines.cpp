#include "pipeline/rough_lines.h"

#include "contour/contour_functions.h"
#include "contour/polygon_silhouettes.h"
#include "contour/silhouettes.h"

namespace illustrate {
namespace {

Segment segment_between(const Vec3& a, const Vec3& b) { return {a.cast<float>(), b.cast<float>()}; }

Vec3 zero_on_edge(const Surface& surface, const ContourFunctions& functions, int triangle,
                  int corner) {
  const Triangle& corners = surface.triangles[idx(triangle)];
  const Vec3& a = surface.positions[idx(corners[idx(corner)])];
  const Vec3& b = surface.positions[idx(corners[idx(next_corner(corner))])];
  return a + functions.zero_fraction(triangle, corner) * (b - a);
}

// `fronts`: bit k tells whether corner k is front; two edges of the triangle join both kinds.
Segment zero_segment(const Surface& surface, const ContourFunctions& functions, int triangle,
                     unsigned fronts) {
  std::array<Vec3, 2> ends;
  std::size_t found = 0;
  for (int k = 0; k < 3 && found < ends.size(); ++k) {
    const auto is_front = [&](int corner) { return (fronts >> corner & 1U) != 0; };
    if (is_front(k) == is_front(next_corner(k))) continue;
    ends[found++] = zero_on_edge(surface, functions, triangle, k);
  }
  return segment_between(ends[0], ends[1]);
}

Segment edge_segment(const Surface& surface, const EdgeSide& side) {
  const Triangle& corners = surface.triangles[idx(side.triangle)];
  return segment_between(surface.positions[idx(corners[idx(side.corner)])],
                         surface.positions[idx(corners[idx(next_corner(side.corner))])]);
}

void add_curves(const IntersectionCurves& found, std::vector<Segment>& segments) {
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    const auto curve = found.curves[c];
    const std::size_t last = curve.size() - (found.closed[c] ? 0 : 1);
    for (std::size_t i = 0; i < last; ++i) {
      segments.push_back(
          segment_between(curve[i].position, curve[(i + 1) % curve.size()].position));
    }
  }
}

}  // namespace

std::vector<Segment> rough_silhouettes(const Prepared& prepared, const Camera& camera) {
  const Surface& surface = prepared.surface();
  const DualSurface& dual = prepared.dual_surface();
  const ContourFunctions functions(surface, camera);
  const SilhouetteSearch found = find_silhouette_triangles(surface, functions, &dual);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < found.triangles.size(); ++i) {
    segments.push_back(zero_segment(surface, functions, found.triangles[i], found.fronts[i]));
  }
  for (const FeatureEdge& edge : polygon_silhouettes(surface, camera, &dual).edges) {
    segments.push_back(edge_segment(surface, edge.sides[0]));
  }
  return segments;
}

std::vector<Segment> rough_features(const Prepared& prepared) {
  const Surface& surface = prepared.surface();
  std::vector<Segment> segments;
  for (const Edge& edge : surface.feature_edges) {
    segments.push_back(
        segment_between(surface.positions[idx(edge[0])], surface.positions[idx(edge[1])]));
  }
  add_curves(prepared.intersections(), segments);
  return segments;
}

}  // namespace illustrate
