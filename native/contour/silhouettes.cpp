#include "contour/silhouettes.h"

#include <utility>

#include "contour/feature_edges.h"
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
  std::array<double, 3> g;  // at the corners, each on its vertex's own sheet
};

// From triangles to their numbers in a list of distinct ones: a hash table that is at most half
// full, with linear probing.
class TriangleIndex {
 public:
  explicit TriangleIndex(const std::vector<int>& triangles) : triangles_(triangles) {
    std::size_t size = 2;
    for (; size < 2 * triangles.size(); size *= 2) --shift_;
    slots_.resize(size, none);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      slots_[slot_of(triangles[i])] = static_cast<int>(i);
    }
  }

  // none for triangles that are not in the list.
  int operator[](int triangle) const { return slots_[slot_of(triangle)]; }

 private:
  // The slot that holds the triangle, or a free one.
  std::size_t slot_of(int triangle) const {
    std::size_t slot = (static_cast<std::uint32_t>(triangle) * 2654435769U) >> shift_;
    while (slots_[slot] != none && triangles_[idx(slots_[slot])] != triangle) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  const std::vector<int>& triangles_;
  std::vector<int> slots_;
  int shift_ = 31;  // of a 32-bit hash
};

// Follows the segments of triangles from one to the next.
class Tracer {
 public:
  Tracer(const Surface& surface, const ContourFunctions& functions, LinearSilhouettes& result)
      : surface_(surface),
        functions_(functions),
        triangles_(result.triangles),
        index_(triangles_),
        traced_(triangles_.size(), 0),
        result_(result) {}

  void run() {
    segments_.reserve(triangles_.size());
    result_.chains.values.reserve(triangles_.size() + triangles_.size() / 16);
    for (const int t : triangles_) segments_.push_back(segment_of(t));
    const int count = static_cast<int>(triangles_.size());
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)] && across(i, segments_[idx(i)].in) == none) trace(i);
    }
    for (int i = 0; i < count; ++i) {
      if (!traced_[idx(i)]) trace(i);
    }
  }

 private:
  Segment segment_of(int triangle) const {
    Segment segment;
    std::array<bool, 3> front;
    for (int k = 0; k < 3; ++k) {
      segment.g[idx(k)] = functions_.g(surface_.triangles[idx(triangle)][idx(k)]);
      front[idx(k)] = (segment.g[idx(k)] >= 0) == (surface_.corner_sign(triangle, k) > 0);
    }
    for (int k = 0; k < 3; ++k) {
      if (front[idx(k)] == front[idx(next_corner(k))]) continue;
      (front[idx(k)] ? segment.in : segment.out) = k;
    }
    return segment;
  }

  // The segment that goes on beyond an edge of segment i's triangle.
  int across(int i, int corner) const {
    const int triangle = triangles_[idx(i)];
    if (!is_passage(surface_.edge_kinds[idx(triangle)][idx(corner)])) return none;
    const EdgeSide other = opposite_side(surface_, {triangle, corner});
    return other.triangle == none ? none : index_[other.triangle];
  }

  void trace(int first) {
    int last = first;
    bool closed = false;
    for (int i = first;;) {
      traced_[idx(i)] = 1;
      last = i;
      push_segment(i);
      i = across(i, segments_[idx(i)].out);
      closed = i == first;
      if (i == none || traced_[idx(i)]) break;
    }
    if (!closed) {
      const int triangle = triangles_[idx(last)];
      const Segment& segment = segments_[idx(last)];
      result_.chains.push(
          edge_point(triangle, segment.out, segment.g, functions_.cusp_functions(triangle)));
    }
    result_.chains.close_list();
    result_.closed.push_back(closed);
  }

  void push_segment(int i) {
    const int triangle = triangles_[idx(i)];
    const std::array<double, 3> values = functions_.cusp_functions(triangle);
    const Segment& segment = segments_[idx(i)];
    EdgePoint p = edge_point(triangle, segment.in, segment.g, values);
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
  std::vector<Segment> segments_;  // of these triangles
  TriangleIndex index_;
  std::vector<std::uint8_t> traced_;
  LinearSilhouettes& result_;
};

SilhouetteSearch search(const ContourFunctions& functions, const DualSurface& dual) {
  SilhouetteSearch result;
  for (const int t : dual.triangles(functions.camera())) {
    ++result.visited;
    const bool front = functions.front(t, 0);
    if (functions.front(t, 1) != front || functions.front(t, 2) != front) {
      result.triangles.push_back(t);
    }
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
    int fronts = surface.flips[idx(t)] & 7;  // a bit for each corner
    for (int k = 0; k < 3; ++k) fronts ^= front[idx(surface.triangles[idx(t)][idx(k)])] << k;
    if (fronts != 0 && fronts != 7) result.triangles.push_back(t);
  }
  return result;
}

}  // namespace

SilhouetteSearch find_silhouette_triangles(const Surface& surface,
                                           const ContourFunctions& functions,
                                           const DualSurface* dual) {
  return dual ? search(functions, *dual) : scan(surface, functions);
}

LinearSilhouettes linear_silhouettes(const Surface& surface, const ContourFunctions& functions,
                                     const DualSurface* dual) {
  SilhouetteSearch found = find_silhouette_triangles(surface, functions, dual);
  LinearSilhouettes result;
  result.triangles = std::move(found.triangles);
  result.triangles_visited = found.visited;
  Tracer(surface, functions, result).run();
  return result;
}

}  // namespace illustrate
