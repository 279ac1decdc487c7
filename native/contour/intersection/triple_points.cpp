#include "contour/intersection/triple_points.h"

#include <algorithm>
#include <map>

#include "contour/intersection/crossing_test.h"
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

  std::vector<TriplePoint> run() {
    for (const auto& [triangle, segments] : on_triangle_) {
      for (std::size_t i = 0; i < segments.size(); ++i) {
        for (std::size_t j = i + 1; j < segments.size(); ++j)
          meet(triangle, segments[i], segments[j]);
      }
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

  // Two segments that cross on one triangle: its sheet and the other one of each meet there.
  void meet(int triangle, int first, int second) {
    const CurveSegment &s = segments_[idx(first)], &t = segments_[idx(second)];
    const int b = s.sheets[s.sheets[0] == triangle ? 1 : 0];
    const int c = t.sheets[t.sheets[0] == triangle ? 1 : 0];
    double f, h;
    if (share_place(b, c) || !cross(triangle, s, t, f, h) || are_in_one_plane(b, c)) return;
    std::array<int, 3> sheets{triangle, b, c};
    std::sort(sheets.begin(), sheets.end());
    const auto [found, is_new] = found_.try_emplace(sheets);
    if (!is_new) return;
    TriplePoint& point = found->second;
    point.position = seen_at(s, f);
    point.passages = {passage(s, f, c), passage(t, h, b)};
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

  bool cross(int triangle, const CurveSegment& s, const CurveSegment& t, double& f,
             double& h) const {
    const std::array<Vec3, 3> c = corners(triangle);
    return segments_cross(barycentrics(c, s.start), barycentrics(c, s.end),
                          barycentrics(c, t.start), barycentrics(c, t.end), f, h);
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
                                       const IntersectionCurves& intersections) {
  return TriplePointFinder(surface, intersections).run();
}

}  // namespace illustrate
