#include "contour/intersection/triple_points.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "contour/intersection/crossing_test.h"
#include "core/segment_pairs.h"
#include "surface/locate.h"

namespace illustrate {
namespace {

// A segment of a curve, with its ends where they are once everything is moved inward. Flush sheets
// cut a third one in the same line; only there do their curves tell whether they pass each other.
struct CurveSegment {
  int curve;
  int segment;
  std::array<int, 2> sheets;  // its two triangles
  Vec3 start, end;
};

// Two segments that cross on one triangle, at these shares of their ways.
struct SegmentCrossing {
  int first, second;
  double first_share, second_share;
};

using SegmentEnds = std::array<Vec2, 2>;

// On a grid far finer than curves lie apart, rounded outwards; a sliver's shares may be anything.
SegmentBox box_of(const SegmentEnds& ends) {
  static constexpr double cells = 0x1p30, farthest = 0x1p60;
  const auto on_grid = [](double share) {
    const double cell = share * cells;
    return static_cast<std::int64_t>(cell > -farthest ? std::min(cell, farthest) : -farthest);
  };
  SegmentBox box;
  for (const int k : {0, 1}) {
    const auto [low, high] = std::minmax({ends[0][k], ends[1][k]});
    box.low[idx(k)] = on_grid(low) - 1;
    box.high[idx(k)] = on_grid(high) + 1;
  }
  return box;
}

constexpr std::int64_t boxes_between_reports = 1 << 16;

class TriplePointFinder {
 public:
  TriplePointFinder(const Surface& surface, const IntersectionCurves& intersections)
      : surface_(surface), intersections_(intersections) {
    for (std::size_t c = 0; c < intersections.curves.size(); ++c) {
      const Span<const IntersectionPoint> curve = intersections.curves[c];
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::array<int, 2> sheets =
            intersections.segment_triangles[idx(intersections.curves.offsets[c]) + i];
        if (sheets[0] == none) continue;
        const Vec3& end = curve[(i + 1) % curve.size()].decided;
        add({static_cast<int>(c), static_cast<int>(i), sheets, curve[i].decided, end});
      }
    }
  }

  std::vector<TriplePoint> run(const Progress& progress) {
    const auto all = static_cast<double>(2 * segments_.size());
    double done = 0;
    for (const auto& [triangle, segments] : on_triangle_) {
      for (const SegmentCrossing& c : crossings(triangle, segments, progress, done / all))
        meet(triangle, c);
      done += static_cast<double>(segments.size());
      progress.report(done / all);
    }
    std::vector<TriplePoint> result;
    for (auto& [sheets, point] : found_) result.push_back(std::move(point));
    return result;
  }

 private:
  void add(const CurveSegment& segment) {
    const int number = static_cast<int>(segments_.size());
    segments_.push_back(segment);
    for (const int sheet : segment.sheets) on_triangle_[sheet].push_back(number);
    of_pair_[std::minmax(segment.sheets[0], segment.sheets[1])] = number;
  }

  // In the order of the segments.
  std::vector<SegmentCrossing> crossings(int triangle, const std::vector<int>& segments,
                                         const Progress& progress, double share_done) const {
    const std::vector<SegmentEnds> ends = ends_on(triangle, segments);
    std::vector<SegmentBox> boxes;
    for (const SegmentEnds& e : ends) boxes.push_back(box_of(e));
    std::vector<SegmentCrossing> result;
    std::int64_t visited = 0;
    overlapping_boxes(boxes, [&](int i, int j) {
      if (++visited % boxes_between_reports == 0) progress.report(share_done);
      const SegmentEnds &s = ends[idx(i)], &t = ends[idx(j)];
      double f, h;
      if (segments_cross(s[0], s[1], t[0], t[1], f, h))
        result.push_back({segments[idx(i)], segments[idx(j)], f, h});
    });
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    return result;
  }

  std::vector<SegmentEnds> ends_on(int triangle, const std::vector<int>& segments) const {
    const std::array<Vec3, 3> c = corners(triangle);
    std::vector<SegmentEnds> ends;
    for (const int s : segments) {
      const CurveSegment& segment = segments_[idx(s)];
      ends.push_back({barycentrics(c, segment.start), barycentrics(c, segment.end)});
    }
    return ends;
  }

  // The triangle's sheet and the other one of each segment meet where they cross.
  void meet(int triangle, const SegmentCrossing& crossing) {
    const CurveSegment& s = segments_[idx(crossing.first)];
    const CurveSegment& t = segments_[idx(crossing.second)];
    const double f = crossing.first_share;
    const int b = s.sheets[s.sheets[0] == triangle ? 1 : 0];
    const int c = t.sheets[t.sheets[0] == triangle ? 1 : 0];
    if (share_place(b, c) || are_in_one_plane(b, c)) return;
    std::array<int, 3> sheets{triangle, b, c};
    std::sort(sheets.begin(), sheets.end());
    const auto [found, is_new] = found_.try_emplace(sheets);
    if (!is_new) return;
    TriplePoint& point = found->second;
    point.position = seen_at(s, f);
    point.passages = {passage(s, f, c), passage(t, crossing.second_share, b)};
    const auto third = of_pair_.find(std::minmax(b, c));
    if (third == of_pair_.end()) return;
    const CurveSegment& u = segments_[idx(third->second)];
    point.passages.push_back(passage(u, nearest(u, s.start + f * (s.end - s.start)), triangle));
  }

  // Sheets that share a vertex pass through each other nowhere: one curve runs from one to the
  // other. Where all three are nearly in one plane only rounding lets it cross itself.
  bool share_place(int a, int b) const {
    for (const int v : surface_.triangles[idx(a)])
      for (const int w : surface_.triangles[idx(b)])
        if (surface_.places[idx(v)] == surface_.places[idx(w)]) return true;
    return false;
  }

  // Where a surface folds over itself within its plane; both curves are one, and cross by rounding.
  bool are_in_one_plane(int a, int b) const {
    return lie_in_one_plane(corners(a), corners(b), intersections_.one_plane);
  }

  Passage passage(const CurveSegment& s, double fraction, int through) const {
    const std::array<Vec3, 3> c = corners(through);
    const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
    return {s.curve, s.segment, fraction, through, normal.dot(s.end - s.start) >= 0};
  }

  // On the surface as it is.
  Vec3 seen_at(const CurveSegment& s, double fraction) const {
    const Span<const IntersectionPoint> curve = intersections_.curves[idx(s.curve)];
    const Vec3& start = curve[idx(s.segment)].position;
    return start + fraction * (curve[(idx(s.segment) + 1) % curve.size()].position - start);
  }

  // The fraction of a segment's way where it comes nearest to a point.
  static double nearest(const CurveSegment& s, const Vec3& point) {
    const Vec3 along = s.end - s.start;
    const double square = along.squaredNorm();
    const double f = square > 0 ? (point - s.start).dot(along) / square : 0;
    return std::clamp(f, 0.0, 1 - 1e-9);
  }

  // Moved inward.
  std::array<Vec3, 3> corners(int triangle) const {
    std::array<Vec3, 3> moved;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = idx(surface_.triangles[idx(triangle)][k]);
      moved[k] = surface_.positions[v] + intersections_.insets.moves[v];
    }
    return moved;
  }

  const Surface& surface_;
  const IntersectionCurves& intersections_;
  std::vector<CurveSegment> segments_;
  std::map<int, std::vector<int>> on_triangle_;
  std::map<std::pair<int, int>, int> of_pair_;
  std::map<std::array<int, 3>, TriplePoint> found_;
};

}  // namespace

std::vector<TriplePoint> triple_points(const Surface& surface,
                                       const IntersectionCurves& intersections,
                                       const Progress& progress) {
  return TriplePointFinder(surface, intersections).run(progress);
}

}  // namespace illustrate
