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
  Tracer(const Surface& surface, const ContourFunctions& functions, const Camera& camera,
         Silhouettes& result)
      : surface_(surface),
        functions_(functions),
        camera_(camera),
        triangles_(result.triangles),
        index_(triangles_),
        traced_(triangles_.size(), 0),
        result_(result) {}

  void run() {
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
    std::array<bool, 3> front;
    for (int k = 0; k < 3; ++k) front[idx(k)] = functions_.front(triangle, k);
    Segment segment;
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
      result_.chains.push(edge_point(triangles_[idx(last)], segments_[idx(last)].out));
    }
    result_.chains.close_list();
    result_.closed.push_back(closed);
  }

  void push_segment(int i) {
    const int triangle = triangles_[idx(i)];
    const ChainPoint start = edge_point(triangle, segments_[idx(i)].in);
    const ChainPoint end = edge_point(triangle, segments_[idx(i)].out);
    result_.chains.push(start);
    const double c_start = cusp_value(triangle, start), c_end = cusp_value(triangle, end);
    if ((c_start >= 0) == (c_end >= 0)) return;
    result_.chains.push(cusp_point(start, end, c_start / (c_start - c_end)));
    ++result_.cusps;
  }

  ChainPoint edge_point(int triangle, int corner) const {
    const double fraction = functions_.zero_fraction(triangle, corner);
    const Triangle& corners = surface_.triangles[idx(triangle)];
    const Vec3& a = surface_.positions[idx(corners[idx(corner)])];
    const Vec3& b = surface_.positions[idx(corners[idx(next_corner(corner))])];
    // Both triangles of an edge compute the same bits: from its lower vertex to its higher one.
    const bool ascending = corners[idx(corner)] < corners[idx(next_corner(corner))];
    const Vec3 position =
        ascending ? Vec3(a + fraction * (b - a)) : Vec3(b + (1 - fraction) * (a - b));
    return {position, on_edge(triangle, corner, fraction), corner, fraction, 0};
  }

  double cusp_value(int triangle, const ChainPoint& point) const {
    return functions_.cusp_function(triangle, point.edge, point.fraction);
  }

  ChainPoint cusp_point(const ChainPoint& start, const ChainPoint& end, double fraction) const {
    ChainPoint cusp;
    cusp.position = start.position + fraction * (end.position - start.position);
    cusp.on = {start.on.triangle, start.on.b1 + fraction * (end.on.b1 - start.on.b1),
               start.on.b2 + fraction * (end.on.b2 - start.on.b2)};
    const double approach = (end.position - start.position).dot(camera_.to_eye(cusp.position));
    cusp.cusp_jump = approach < 0 ? 1 : -1;
    return cusp;
  }

  const Surface& surface_;
  const ContourFunctions& functions_;
  const Camera& camera_;
  const std::vector<int>& triangles_;
  std::vector<Segment> segments_;  // of these triangles
  TriangleIndex index_;
  std::vector<std::uint8_t> traced_;
  Silhouettes& result_;
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

Silhouettes silhouettes(const Surface& surface, const ContourFunctions& functions,
                        const Camera& camera, const DualSurface* dual) {
  SilhouetteSearch found = find_silhouette_triangles(surface, functions, dual);
  Silhouettes result;
  result.triangles = std::move(found.triangles);
  result.triangles_visited = found.visited;
  Tracer(surface, functions, camera, result).run();
  return result;
}

}  // namespace illustrate
