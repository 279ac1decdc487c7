#include "contour/zero_curves.h"

#include <algorithm>
#include <utility>

#include "surface/locate.h"

namespace illustrate {
namespace {

// Cuts off what is weaker than `weak`; false where nothing is left.
bool keep_strong(ZeroSegment& segment, double weak) {
  const double a = segment[0].strength, b = segment[1].strength;
  if (!(std::max(a, b) >= weak)) return false;
  if (a >= weak && b >= weak) return true;
  const ZeroPoint cut = between(segment[0], segment[1], (weak - a) / (b - a));
  segment[a < weak ? 0 : 1] = cut;
  return true;
}

class Linker {
 public:
  Linker(const Surface& surface, std::vector<ZeroSegment> segments, const ZeroLimits& limits)
      : surface_(surface),
        segments_(std::move(segments)),
        limits_(limits),
        mates_(2 * segments_.size(), none) {}

  ZeroCurves run() {
    meet_on_edges();
    used_.assign(segments_.size(), 0);
    for (int end = 0; end < static_cast<int>(mates_.size()); ++end) {
      if (mates_[idx(end)] == none && !used_[idx(end / 2)]) follow(end);
    }
    for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
      if (!used_[idx(s)]) follow(2 * s);
    }
    return std::move(result_);
  }

 private:
  // Ends are numbered 2 segment + which of its points.
  const ZeroPoint& point(int end) const { return segments_[idx(end / 2)][idx(end % 2)]; }

  Edge edge_of(const ZeroPoint& p) const {
    const Triangle& t = surface_.triangles[idx(p.on.triangle)];
    const int a = t[idx(p.edge)], b = t[idx(next_corner(p.edge))];
    return {std::min(a, b), std::max(a, b)};
  }

  // Vertices on creases have copies, so that segments on different smooth sides do not meet.
  void meet_on_edges() {
    std::vector<std::pair<Edge, int>> ends;
    for (int end = 0; end < static_cast<int>(mates_.size()); ++end) {
      if (point(end).edge != none) ends.emplace_back(edge_of(point(end)), end);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t j = i;
      while (j < ends.size() && ends[j].first == ends[i].first) ++j;
      if (j == i + 2) {
        mates_[idx(ends[i].second)] = ends[i + 1].second;
        mates_[idx(ends[i + 1].second)] = ends[i].second;
      }
      i = j;
    }
  }

  void follow(int first) {
    std::vector<ZeroPoint> points;
    bool closed = false;
    for (int end = first;;) {
      used_[idx(end / 2)] = 1;
      points.push_back(point(end));
      const int far = end ^ 1, next = mates_[idx(far)];
      closed = next == first;
      if (next == none) points.push_back(point(far));
      if (next == none || used_[idx(next / 2)]) break;
      end = next;
    }
    if (!is_drawn(points)) return;
    result_.curves.add(points);
    result_.closed.push_back(closed);
  }

  bool is_drawn(const std::vector<ZeroPoint>& points) const {
    double length = 0, most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      most = std::max(most, points[i].strength);
      if (i > 0) length += (points[i].position - points[i - 1].position).norm();
    }
    const int object = surface_.object_of(points.front().on.triangle);
    return most >= limits_.strong && length >= limits_.shortest[idx(object)];
  }

  const Surface& surface_;
  std::vector<ZeroSegment> segments_;
  const ZeroLimits& limits_;
  std::vector<int> mates_;
  std::vector<std::uint8_t> used_;
  ZeroCurves result_;
};

}  // namespace

ZeroCurves link_segments(const Surface& surface, const std::vector<ZeroSegment>& segments,
                         const ZeroLimits& limits) {
  std::vector<ZeroSegment> kept;
  for (ZeroSegment segment : segments) {
    if (keep_strong(segment, limits.weak)) kept.push_back(segment);
  }
  return Linker(surface, std::move(kept), limits).run();
}

ZeroPoint point_on_edge(const Surface& surface, int triangle, int corner, double fraction) {
  const Triangle& t = surface.triangles[idx(triangle)];
  const bool ascending = t[idx(corner)] < t[idx(next_corner(corner))];
  const Vec3& low = surface.positions[idx(std::min(t[idx(corner)], t[idx(next_corner(corner))]))];
  const Vec3& high = surface.positions[idx(std::max(t[idx(corner)], t[idx(next_corner(corner))]))];
  ZeroPoint point;
  point.position = low + fraction * (high - low);
  point.edge = corner;
  point.fraction = ascending ? fraction : 1 - fraction;
  point.on = on_edge(triangle, corner, point.fraction);
  return point;
}

ZeroPoint between(const ZeroPoint& a, const ZeroPoint& b, double fraction) {
  ZeroPoint p;
  p.position = a.position + fraction * (b.position - a.position);
  p.on = {a.on.triangle, a.on.b1 + fraction * (b.on.b1 - a.on.b1),
          a.on.b2 + fraction * (b.on.b2 - a.on.b2)};
  p.strength = a.strength + fraction * (b.strength - a.strength);
  p.ridge = a.ridge;
  p.unseen = a.unseen;
  return p;
}

}  // namespace illustrate
