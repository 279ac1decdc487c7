#include "contour/intersection/flush.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "contour/contour_functions.h"
#include "core/intervals.h"
#include "surface/edge_kinds.h"

namespace illustrate {
namespace {

// A face lies on both sides of a crease if it does this far from it, in reaches: farther than the
// edge of another face may lie from the crease that it coincides with.
constexpr double aside = 4;

// Of the cosine between faces of one plane, up to the rounding of small ones.
constexpr double one_way = 0.5;

const Vec3& corner_position(const Surface& surface, int triangle, int corner) {
  return surface.positions[idx(surface.triangles[idx(triangle)][idx(corner)])];
}

// An edge of a triangle in the plane of another one.
struct EdgeFrame {
  EdgeFrame(const Surface& surface, const EdgeSide& side, int plane)
      : start(corner_position(surface, side.triangle, side.corner)),
        normal(face_normal(surface, plane)) {
    const Vec3 edge = corner_position(surface, side.triangle, next_corner(side.corner)) - start;
    length = edge.norm();
    along = length > 0 ? Vec3(edge / length) : Vec3(Vec3::Zero());
    across = normal.cross(along);
  }

  Vec2 in_plane(const Vec3& p) const { return {(p - start).dot(along), (p - start).dot(across)}; }
  double above(const Vec3& p) const { return (p - start).dot(normal); }

  Vec3 start, normal, along, across;
  double length;
};

// What a triangle covers of the line at distance `y` from the edge.
std::optional<Interval> covered(const Surface& surface, const EdgeFrame& frame, int triangle,
                                double y) {
  std::optional<Interval> found;
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = frame.in_plane(corner_position(surface, triangle, k));
    const Vec2 b = frame.in_plane(corner_position(surface, triangle, next_corner(k)));
    if ((a.y() < y) == (b.y() < y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (!found) found = Interval{x, x};
    found->from = std::min(found->from, x);
    found->to = std::max(found->to, x);
  }
  return found;
}

// Whether the surface beyond an edge rises from the plane.
bool rises(const Surface& surface, const EdgeSide& side, const EdgeFrame& frame, double reach) {
  const EdgeSide other = opposite_side(surface, side);
  if (other.triangle == none) return true;
  const int opposite = next_corner(next_corner(other.corner));
  return frame.above(corner_position(surface, other.triangle, opposite)) > reach;
}

// The stretches of an edge, in lengths along it, on both sides of which these triangles lie.
Intervals flush_stretches(const Surface& surface, const EdgeFrame& frame,
                          const std::vector<int>& triangles, double reach) {
  std::array<Intervals, 2> sides;
  for (const int triangle : triangles) {
    for (const std::size_t side : {0, 1}) {
      const double y = side == 0 ? aside * reach : -aside * reach;
      if (const auto cover = covered(surface, frame, triangle, y)) sides[side].push_back(*cover);
    }
  }
  return common(joined(std::move(sides[0]), reach), joined(std::move(sides[1]), reach));
}

class FlushEdgeFinder {
 public:
  FlushEdgeFinder(const Surface& surface, const IntersectionCurves& curves)
      : surface_(surface), reach_(curves.reach) {
    for (const FlushTriangles& pair : curves.flush_triangles) {
      for (const std::size_t i : {0, 1}) {
        if (!has_crease(surface_, pair.triangles[i])) continue;
        partners_[pair.triangles[i]][pair.parts[1 - i]].push_back(pair.triangles[1 - i]);
      }
    }
  }

  std::vector<FlushEdge> run() {
    for (const auto& [triangle, parts] : partners_) {
      for (int k = 0; k < 3; ++k) {
        if (surface_.edge_kinds[idx(triangle)][idx(k)] != EdgeKind::crease) continue;
        add({triangle, k}, parts);
      }
    }
    return std::move(edges_);
  }

 private:
  using TrianglesOfParts = std::map<int, std::vector<int>>;

  void add(const EdgeSide& side, const TrianglesOfParts& parts) {
    const int plane = largest(parts);
    const EdgeFrame frame(surface_, side, plane);
    if (rises(surface_, side, frame, reach_)) return;
    const double slack = aside * reach_;
    for (const Interval& stretch : stretches(frame, parts)) {
      const double from = stretch.from <= slack ? 0 : stretch.from;
      const double to = stretch.to >= frame.length - slack ? frame.length : stretch.to;
      if (to - from <= slack) continue;
      edges_.push_back({side, from / frame.length, to / frame.length, plane});
    }
  }

  // Each part by itself: where two of them only abut along the edge, it is their seam.
  Intervals stretches(const EdgeFrame& frame, const TrianglesOfParts& parts) const {
    Intervals all;
    for (const auto& [part, triangles] : parts) {
      const Intervals of_part = flush_stretches(surface_, frame, triangles, reach_);
      all.insert(all.end(), of_part.begin(), of_part.end());
    }
    return joined(std::move(all), flush_gap(reach_));
  }

  // Slivers do not tell where their plane is.
  int largest(const TrianglesOfParts& parts) const {
    int result = parts.begin()->second.front();
    double most = 0;
    for (const auto& [part, triangles] : parts) {
      for (const int t : triangles) {
        const double size = winding_normal(surface_, t).squaredNorm();
        if (size <= most) continue;
        most = size;
        result = t;
      }
    }
    return result;
  }

  const Surface& surface_;
  double reach_;
  // Of each triangle with a crease: those flush with it, by their parts.
  std::map<int, TrianglesOfParts> partners_;
  std::vector<FlushEdge> edges_;
};

// Flush edges by the places of their ends.
class EdgesAtPlaces {
 public:
  EdgesAtPlaces(const Surface& surface, const IntersectionCurves& curves)
      : surface_(surface), slack_(aside * curves.reach) {
    for (const FlushEdge& edge : curves.flush_edges) {
      const Triangle& corners = surface.triangles[idx(edge.side.triangle)];
      for (const int k : {edge.side.corner, next_corner(edge.side.corner)}) {
        edges_[surface.places[idx(corners[idx(k)])]].push_back(&edge);
      }
    }
  }

  // Whether a segment in triangle `on` and in the plane of `within` runs along a flush edge of the
  // sheet of `on`.
  bool has_along(int on, int within, const Vec3& start, const Vec3& end) const {
    for (const int vertex : surface_.triangles[idx(on)]) {
      const auto found = edges_.find(surface_.places[idx(vertex)]);
      if (found == edges_.end()) continue;
      for (const FlushEdge* edge : found->second) {
        if (runs_along(*edge, within, start, end)) return true;
      }
    }
    return false;
  }

 private:
  bool runs_along(const FlushEdge& edge, int within, const Vec3& start, const Vec3& end) const {
    const EdgeFrame frame(surface_, edge.side, edge.plane);
    const auto is_on_line = [&](const Vec3& p) {
      return std::abs(frame.in_plane(p).y()) <= slack_ && std::abs(frame.above(p)) <= slack_;
    };
    const double middle = frame.in_plane((start + end) / 2).x();
    return is_on_line(start) && is_on_line(end) && middle >= edge.from * frame.length - slack_ &&
           middle <= edge.to * frame.length + slack_ &&
           face_normal(surface_, within).dot(frame.normal) > one_way;
  }

  const Surface& surface_;
  double slack_;
  std::unordered_map<int, std::vector<const FlushEdge*>> edges_;
};

bool are_flush(const IntersectionCurves& curves, int a, int b) {
  const std::array<int, 2> pair{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(
      curves.flush_triangles.begin(), curves.flush_triangles.end(), pair,
      [](const FlushTriangles& f, const std::array<int, 2>& p) { return f.triangles < p; });
  return found != curves.flush_triangles.end() && found->triangles == pair;
}

bool is_flush(const IntersectionCurves& curves, const EdgesAtPlaces& edges, std::size_t c,
              std::size_t i) {
  const auto [a, b] = curves.segment_triangles[idx(curves.curves.offsets[c]) + i];
  if (a == none) return false;
  const Span<const IntersectionPoint> curve = curves.curves[c];
  const Vec3 &start = curve[i].position, &end = curve[(i + 1) % curve.size()].position;
  return are_flush(curves, a, b) || edges.has_along(a, b, start, end) ||
         edges.has_along(b, a, start, end);
}

}  // namespace

double flush_gap(double reach) { return 2 * aside * reach; }

std::vector<FlushEdge> flush_edges(const Surface& surface, const IntersectionCurves& curves) {
  return FlushEdgeFinder(surface, curves).run();
}

std::vector<std::uint8_t> flush_segments(const Surface& surface, const IntersectionCurves& curves) {
  std::vector<std::uint8_t> result(curves.segment_triangles.size(), 0);
  if (curves.flush_triangles.empty()) return result;
  const EdgesAtPlaces edges(surface, curves);
  for (std::size_t c = 0; c < curves.curves.size(); ++c) {
    const std::size_t first = idx(curves.curves.offsets[c]);
    for (std::size_t i = 0; i < curves.curves[c].size(); ++i)
      result[first + i] = is_flush(curves, edges, c, i);
  }
  return result;
}

}  // namespace illustrate
