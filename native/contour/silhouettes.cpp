#include "contour/silhouettes.h"

#include <utility>

#include "contour/feature_edges.h"
#include "core/index_map.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

bool is_passage(EdgeKind kind) {
  return kind != EdgeKind::crease && kind != EdgeKind::boundary && kind != EdgeKind::seam;
}

// One triangle's segment: in over the edge that turns from front to back, out over the other.
struct Segment {
  int in = none;
  int out = none;
  int next = none;            // segment beyond `out`
  bool has_previous = false;  // a segment beyond `in`
};

// Follows the segments of triangles from one to the next.
class Tracer {
 public:
  Tracer(const Surface& surface, const ContourFunctions& functions, const SilhouetteSearch& found,
         LinearSilhouettes& result)
      : surface_(surface),
        functions_(functions),
        triangles_(found.triangles),
        g_(found.g),
        traced_(triangles_.size(), 0),
        result_(result) {}

  void run() {
    segments_.reserve(triangles_.size());
    result_.chains.values.reserve(triangles_.size() + triangles_.size() / 16);
    const int count = static_cast<int>(triangles_.size());
    for (int i = 0; i < count; ++i) segments_.push_back(segment_of(i));
    link();
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)] && !segments_[idx(i)].has_previous) trace(i);
    }
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)]) trace(i);
    }
  }

 private:
  Segment segment_of(int i) const {
    Segment segment;
    std::array<bool, 3> front;
    for (int k = 0; k < 3; ++k) {
      const bool faces = surface_.corner_sign(triangles_[idx(i)], k) > 0;
      front[idx(k)] = (g_[idx(i)][idx(k)] >= 0) == faces;
    }
    for (int k = 0; k < 3; ++k) {
      if (front[idx(k)] == front[idx(next_corner(k))]) continue;
      (front[idx(k)] ? segment.in : segment.out) = k;
    }
    return segment;
  }

  void link() {
    const int count = static_cast<int>(triangles_.size());
    IndexMap index(triangles_.size());
    for (int i = 0; i < count; ++i) index.at(triangles_[idx(i)]) = i;
    for (int i = 0; i < count; ++i) {
      Segment& segment = segments_[idx(i)];
      segment.next = across(i, segment.out, index);
      segment.has_previous = across(i, segment.in, index) != none;
    }
  }

  // The segment that goes on beyond an edge of segment i's triangle.
  int across(int i, int corner, const IndexMap& index) const {
    const int triangle = triangles_[idx(i)];
    if (!is_passage(surface_.edge_kinds[idx(triangle)][idx(corner)])) return none;
    const EdgeSide other = opposite_side(surface_, {triangle, corner});
    return other.triangle == none ? none : index[other.triangle];
  }

  void trace(int first) {
    int last = first;
    bool closed = false;
    for (int i = first;;) {
      traced_[idx(i)] = 1;
      last = i;
      push_segment(i);
      i = segments_[idx(i)].next;
      closed = i == first;
      if (i == none || traced_[idx(i)]) break;
    }
    if (!closed) {
      const int triangle = triangles_[idx(last)];
      result_.chains.push(edge_point(triangle, segments_[idx(last)].out, g_[idx(last)],
                                     functions_.cusp_functions(triangle)));
    }
    result_.chains.close_list();
    result_.closed.push_back(closed);
  }

  void push_segment(int i) {
    const int triangle = triangles_[idx(i)];
    const std::array<double, 3> values = functions_.cusp_functions(triangle);
    const Segment& segment = segments_[idx(i)];
    EdgePoint p = edge_point(triangle, segment.in, g_[idx(i)], values);
    p.out = segment.out;
    const int positive = (values[0] >= 0) + (values[1] >= 0) + (values[2] >= 0);
    p.has_both_signs = positive == 1 || positive == 2;
    result_.chains.push(p);
  }

  EdgePoint edge_point(int triangle, int corner, const std::array<double, 3>& g,
                       const std::array<double, 3>& values) const {
    const Triangle& corners = surface_.triangles[idx(triangle)];
    const int next = next_corner(corner);
    const Vec3& a = surface_.positions[idx(corners[idx(corner)])];
    const Vec3& b = surface_.positions[idx(corners[idx(next)])];
    // Both triangles of an edge compute the same bits: from its lower vertex to its higher one.
    const bool ascending = corners[idx(corner)] < corners[idx(next)];
    const double fraction = ascending ? zero_between(g[idx(corner)], g[idx(next)])
                                      : 1 - zero_between(g[idx(next)], g[idx(corner)]);
    EdgePoint p;
    p.position = ascending ? Vec3(a + fraction * (b - a)) : Vec3(b + (1 - fraction) * (a - b));
    p.on = on_edge(triangle, corner, fraction);
    p.fraction = fraction;
    p.edge = corner;
    p.cusp_function =
        (1 - fraction) * values[idx(corner)] + fraction * values[idx(next_corner(corner))];
    return p;
  }

  const Surface& surface_;
  const ContourFunctions& functions_;
  const std::vector<int>& triangles_;
  const std::vector<std::array<double, 3>>& g_;  // at their corners
  std::vector<Segment> segments_;                // in them
  std::vector<std::uint8_t> traced_;
  LinearSilhouettes& result_;
};

SilhouetteSearch search(const Surface& surface, const ContourFunctions& functions,
                        const DualSurface& dual) {
  SilhouetteSearch result;
  const std::vector<int> visited = dual.triangles(functions.camera());
  result.visited = static_cast<std::int64_t>(visited.size());
  result.triangles.reserve(visited.size());
  result.g.reserve(visited.size());
  for (const int t : visited) {
    std::array<double, 3> g;
    int fronts = surface.flips[idx(t)] & 7;  // a bit for each corner
    for (int k = 0; k < 3; ++k) {
      g[idx(k)] = functions.g(surface.triangles[idx(t)][idx(k)]);
      fronts ^= (g[idx(k)] >= 0) << k;
    }
    if (fronts == 0 || fronts == 7) continue;
    result.triangles.push_back(t);
    result.g.push_back(g);
  }
  return result;
}

SilhouetteSearch scan(const Surface& surface, const ContourFunctions& functions) {
  std::vector<std::uint8_t> front(surface.positions.size());
  for (int v = 0; v < static_cast<int>(front.size()); ++v) front[idx(v)] = functions.g(v) >= 0;
  SilhouetteSearch result;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (!surface.object_is_smooth[idx(surface.triangle_objects[idx(t)])]) continue;
    ++result.visited;
    const Triangle& v = surface.triangles[idx(t)];
    int fronts = surface.flips[idx(t)] & 7;  // a bit for each corner
    for (int k = 0; k < 3; ++k) fronts ^= front[idx(v[idx(k)])] << k;
    if (fronts == 0 || fronts == 7) continue;
    result.triangles.push_back(t);
    result.g.push_back({functions.g(v[0]), functions.g(v[1]), functions.g(v[2])});
  }
  return result;
}

}  // namespace

SilhouetteSearch find_silhouette_triangles(const Surface& surface,
                                           const ContourFunctions& functions,
                                           const DualSurface* dual) {
  return dual ? search(surface, functions, *dual) : scan(surface, functions);
}

LinearSilhouettes linear_silhouettes(const Surface& surface, const ContourFunctions& functions,
                                     const DualSurface* dual) {
  SilhouetteSearch found = find_silhouette_triangles(surface, functions, dual);
  LinearSilhouettes result;
  Tracer(surface, functions, found, result).run();
  result.triangles = std::move(found.triangles);
  result.triangles_visited = found.visited;
  return result;
}

}  // namespace illustrate
