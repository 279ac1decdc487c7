#include "pipeline/rough_lines.h"

#include <map>
#include <utility>

#include "contour/contour_functions.h"
#include "contour/polygon_silhouettes.h"
#include "contour/silhouettes.h"
#include "core/intervals.h"

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

// By the places of an edge's ends, in shares from the lower one.
using FlushByPlaces = std::map<std::pair<int, int>, Intervals>;

FlushByPlaces flush_by_places(const Surface& surface, const IntersectionCurves& found) {
  FlushByPlaces result;
  for (const FlushEdge& edge : found.flush_edges) {
    const Triangle& corners = surface.triangles[idx(edge.side.triangle)];
    const int a = surface.places[idx(corners[idx(edge.side.corner)])];
    const int b = surface.places[idx(corners[idx(next_corner(edge.side.corner))])];
    result[std::minmax(a, b)].push_back(a < b ? Interval{edge.from, edge.to}
                                              : Interval{1 - edge.to, 1 - edge.from});
  }
  for (auto& [places, parts] : result) parts = joined(std::move(parts), 0);
  return result;
}

// What of it is a line.
void add_edge(const Surface& surface, Edge edge, const FlushByPlaces& flush,
              std::vector<Segment>& segments) {
  const auto place = [&](int vertex) { return surface.places[idx(vertex)]; };
  if (place(edge[0]) > place(edge[1])) std::swap(edge[0], edge[1]);
  const Vec3 &start = surface.positions[idx(edge[0])], &end = surface.positions[idx(edge[1])];
  const auto found = flush.find({place(edge[0]), place(edge[1])});
  const Intervals hidden = found == flush.end() ? Intervals{} : found->second;
  const auto at = [&](double share) { return Vec3((1 - share) * start + share * end); };
  for (const Interval& part : without({0, 1}, hidden)) {
    segments.push_back(segment_between(at(part.from), at(part.to)));
  }
}

void add_curves(const IntersectionCurves& found, std::vector<Segment>& segments) {
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    const auto curve = found.curves[c];
    const std::size_t last = curve.size() - (found.closed[c] ? 0 : 1);
    for (std::size_t i = 0; i < last; ++i) {
      if (found.flush_segments[idx(found.curves.offsets[c]) + i] != 0) continue;
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
  const IntersectionCurves& intersections = prepared.intersections();
  const FlushByPlaces flush = flush_by_places(surface, intersections);
  std::vector<Segment> segments;
  for (const Edge& edge : surface.feature_edges) add_edge(surface, edge, flush, segments);
  add_curves(intersections, segments);
  return segments;
}

}  // namespace illustrate
