#include "contour/shape/curvature_curves.h"

#include <algorithm>
#include <cmath>

#include "contour/back_sides.h"
#include "contour/contour_functions.h"
#include "core/errors.h"

namespace illustrate {
namespace {

// Lines are drawn down to this share of their threshold where they reach the threshold itself.
constexpr double hysteresis = 0.7;
// Shorter lines are left out, as share of the object's diagonal.
constexpr double least_length = 0.02;
// Curvature falls off from a ridge at least so fast, as share of its cube: on a sine wave more than
// 3 times, at the tip of an ellipse of width b and length a 3 (1 - b^2 / a^2) times, on a circle
// not at all.
constexpr double least_sharpness = 1;
// Where the surface faces the viewer within this angle the direction to the eye is no direction on
// it (DeCarlo et al. 2003: 20 to 30 degrees).
constexpr double least_sine = 0.42;
// Below this agreement the principal directions of two neighbours belong to different families.
constexpr double least_agreement = 0.7;

// An edge of a triangle from its lower vertex to its higher one, with the signs that their sheets
// have in the triangle.
struct DirectedEdge {
  DirectedEdge(const Surface& surface, int triangle, int corner) {
    const int next = next_corner(corner);
    low = surface.triangles[idx(triangle)][idx(corner)];
    high = surface.triangles[idx(triangle)][idx(next)];
    low_sign = surface.corner_sign(triangle, corner);
    high_sign = surface.corner_sign(triangle, next);
    if (low < high) return;
    std::swap(low, high);
    std::swap(low_sign, high_sign);
  }

  // Linear interpolation of what changes its sign with the normal.
  double odd(const std::vector<double>& values, double fraction) const {
    return (1 - fraction) * low_sign * values[idx(low)] + fraction * high_sign * values[idx(high)];
  }
  double even(double at_low, double at_high, double fraction) const {
    return (1 - fraction) * at_low + fraction * at_high;
  }

  int low, high;
  double low_sign, high_sign;
};

// The surface as it is looked at.
struct SeenSurface {
  SeenSurface(const Surface& whole, const IntersectionCurves& intersections, const Camera& camera)
      : surface(whole),
        sizes(whole.object_diagonals),
        shows_back(illustrate::shows_back(whole, intersections, camera)) {
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3 view = camera.to_eye(surface.positions[v]);
      const double length = view.norm();
      to_eye.push_back(length > 0 ? Vec3(view / length) : surface.normals[v]);
      facing.push_back(surface.normals[v].dot(to_eye[v]));
    }
  }

  std::size_t object(int triangle) const { return idx(surface.object_of(triangle)); }
  bool is_unseen(int triangle, bool front) const { return !front && !shows_back[object(triangle)]; }

  const Surface& surface;
  const std::vector<double>& sizes;      // (objects)
  std::vector<std::uint8_t> shows_back;  // (objects)
  Points to_eye;                         // (n) unit
  std::vector<double> facing;            // (n) normal . to_eye
};

// Visits every triangle of the smooth objects.
template <class Visit>
void each_smooth_triangle(const Surface& surface, const Visit& visit) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.object_is_smooth[idx(surface.triangle_objects[t])]) visit(static_cast<int>(t));
  }
}

class SuggestiveContours {
 public:
  SuggestiveContours(const SeenSurface& seen, const CurvatureDerivative& derivative,
                     double threshold)
      : seen_(seen),
        surface_(seen.surface),
        radial_(surface_.positions.size()),
        growth_(surface_.positions.size()),
        threshold_(threshold) {
    for (std::size_t v = 0; v < radial_.size(); ++v) set_functions(derivative, v);
  }

  std::vector<ZeroSegment> segments() {
    each_smooth_triangle(surface_, [&](int t) { add_segment(t); });
    return std::move(segments_);
  }

 private:
  // On the side of the normal. Curvature counts as positive where the surface bulges here, so its
  // sign is turned.
  void set_functions(const CurvatureDerivative& d, std::size_t v) {
    const PrincipalCurvature& c = d.curvature[v];
    const Vec3& view = seen_.to_eye[v];
    const double x = view.dot(c.w1), y = view.dot(c.w2), square = x * x + y * y;
    radial_[v] = -(c.k1 * x * x + c.k2 * y * y);
    if (!(square > 0)) return;
    const double sine = std::sqrt(square), torsion = (c.k2 - c.k1) * x * y / square;
    growth_[v] =
        -along(d.cubics[v], x / sine, y / sine) - 2 * torsion * torsion * seen_.facing[v] / sine;
  }

  bool bulges(int triangle, int corner) const {
    const double radial = radial_[idx(surface_.triangles[idx(triangle)][idx(corner)])];
    return (radial >= 0) == (surface_.corner_sign(triangle, corner) > 0);
  }

  void add_segment(int triangle) {
    std::vector<int> edges;
    for (int k = 0; k < 3; ++k) {
      if (bulges(triangle, k) != bulges(triangle, next_corner(k))) edges.push_back(k);
    }
    if (edges.empty()) return;
    const double size = seen_.sizes[seen_.object(triangle)];
    std::array<ZeroPoint, 2> points;
    std::array<double, 2> facing, growth;
    for (std::size_t i = 0; i < 2; ++i) {
      const DirectedEdge edge(surface_, triangle, edges[i]);
      const double zero = zero_between(radial_[idx(edge.low)], radial_[idx(edge.high)]);
      points[i] = point_on_edge(surface_, triangle, edges[i], zero);
      facing[i] = edge.odd(seen_.facing, zero);
      growth[i] = edge.odd(growth_, zero) * size * size;
      points[i].strength = strength(growth[i], facing[i], facing[i] >= 0);
    }
    cut_by_facing(points, facing, growth);
  }

  // In two where it passes from the front to the back.
  void cut_by_facing(const ZeroSegment& segment, const std::array<double, 2>& facing,
                     const std::array<double, 2>& growth) {
    if ((facing[0] >= 0) == (facing[1] >= 0)) {
      add(segment, facing[0] >= 0);
      return;
    }
    const double turn = facing[0] / (facing[0] - facing[1]);
    ZeroPoint middle = between(segment[0], segment[1], turn);
    const double there = growth[0] + turn * (growth[1] - growth[0]);
    for (std::size_t i = 0; i < 2; ++i) {
      middle.strength = strength(there, 0, facing[i] >= 0);
      ZeroSegment half = segment;
      half[1 - i] = middle;
      add(half, facing[i] >= 0);
    }
  }

  void add(const ZeroSegment& segment, bool front) {
    if (!seen_.is_unseen(segment[0].on.triangle, front)) segments_.push_back(segment);
  }

  double strength(double growth, double facing, bool front) const {
    const double seen = front ? growth : -growth;
    const double sine = std::sqrt(std::max(0.0, 1 - facing * facing));
    return std::min(seen / threshold_, sine / least_sine);
  }

  const SeenSurface& seen_;
  const Surface& surface_;
  std::vector<double> radial_;  // (n) times |w|^2
  std::vector<double> growth_;  // (n) of the radial curvature along w
  double threshold_;
  std::vector<ZeroSegment> segments_;
};

class RidgesAndValleys {
 public:
  RidgesAndValleys(const SeenSurface& seen, const CurvatureDerivative& derivative,
                   double ridge_threshold, double valley_threshold)
      : seen_(seen),
        surface_(seen.surface),
        derivative_(derivative),
        ridge_threshold_(ridge_threshold),
        valley_threshold_(valley_threshold) {}

  std::vector<ZeroSegment> segments() {
    each_smooth_triangle(surface_, [&](int t) { add_segment(t); });
    return std::move(segments_);
  }

 private:
  // Derivative of |k1| along w1.
  double slope(int vertex) const {
    const double k = derivative_.curvature[idx(vertex)].k1;
    return (k < 0 ? -1 : 1) * derivative_.cubics[idx(vertex)][0];
  }
  // Its own derivative along w1.
  double second(int vertex) const {
    const double k = derivative_.curvature[idx(vertex)].k1;
    return (k < 0 ? -1 : 1) * derivative_.second[idx(vertex)];
  }

  // Directions have no sign: that of the higher vertex is turned to agree with the lower one's.
  void add_zero(int triangle, int corner, std::vector<ZeroPoint>& zeros) const {
    const DirectedEdge edge(surface_, triangle, corner);
    const PrincipalCurvature& at_low = derivative_.curvature[idx(edge.low)];
    const PrincipalCurvature& at_high = derivative_.curvature[idx(edge.high)];
    const double agreement = at_low.w1.dot(at_high.w1);
    const double k_low = edge.low_sign * at_low.k1, k_high = edge.high_sign * at_high.k1;
    if (std::abs(agreement) < least_agreement || (k_low < 0) != (k_high < 0)) return;
    const double low = slope(edge.low);
    const double high = agreement < 0 ? -slope(edge.high) : slope(edge.high);
    if ((low >= 0) == (high >= 0)) return;
    const double zero = zero_between(low, high);
    ZeroPoint point = point_on_edge(surface_, triangle, corner, zero);
    const bool front = edge.odd(seen_.facing, zero) >= 0;
    point.ridge = front == (k_low < 0);
    point.unseen = seen_.is_unseen(triangle, front);
    const double bend = edge.even(std::abs(k_low), std::abs(k_high), zero);
    const double fall = -edge.even(second(edge.low), second(edge.high), zero);
    const double size = seen_.sizes[seen_.object(triangle)];
    const double threshold = point.ridge ? ridge_threshold_ : valley_threshold_;
    point.strength = strength(bend, fall, size, threshold);
    zeros.push_back(point);
  }

  static double strength(double bend, double fall, double size, double threshold) {
    if (!(fall > 0 && bend > 0)) return 0;
    const double sharpness = fall / (bend * bend * bend);
    return std::min(bend * size / threshold, sharpness / least_sharpness);
  }

  void add_segment(int triangle) {
    std::vector<ZeroPoint> zeros;
    for (int k = 0; k < 3; ++k) add_zero(triangle, k, zeros);
    if (zeros.size() == 2) segments_.push_back({zeros[0], zeros[1]});
  }

  const SeenSurface& seen_;
  const Surface& surface_;
  const CurvatureDerivative& derivative_;
  double ridge_threshold_;
  double valley_threshold_;
  std::vector<ZeroSegment> segments_;
};

void append_seen(const ZeroCurves& found, Kind kind, const CurvatureCurveOptions& options,
                 FreeLines& result) {
  const auto is_seen = [&](const ZeroPoint& p) {
    return !p.unseen &&
           (kind == Kind::suggestive || options.wants(p.ridge ? Kind::ridge : Kind::valley));
  };
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    const Span<const ZeroPoint> line = found.curves[c];
    if (std::none_of(line.begin(), line.end(), is_seen)) continue;
    result.add(line, found.closed[c] != 0, kind);
  }
}

void require_positive(double value, const char* name) {
  if (!(value > 0 && std::isfinite(value))) {
    throw InvalidInput(std::string(name) + " must be above 0 and finite");
  }
}

}  // namespace

void validate(const CurvatureCurveOptions& options) {
  require_positive(options.suggestive_threshold, "suggestive_threshold");
  require_positive(options.ridge_threshold, "ridge_threshold");
  require_positive(options.valley_threshold, "valley_threshold");
}

FreeLines curvature_curves(const Surface& surface, const CurvatureDerivative& derivative,
                           const IntersectionCurves& intersections, const Camera& camera,
                           const CurvatureCurveOptions& options) {
  FreeLines result;
  if (!options.any()) return result;
  const SeenSurface seen(surface, intersections, camera);
  ZeroLimits limits{hysteresis, 1, seen.sizes};
  for (double& length : limits.shortest) length *= least_length;
  if (options.suggestive_contours) {
    SuggestiveContours finder(seen, derivative, options.suggestive_threshold);
    append_seen(link_segments(surface, finder.segments(), limits), Kind::suggestive, options,
                result);
  }
  if (options.ridges || options.valleys) {
    const double ridge = options.ridges ? options.ridge_threshold : options.valley_threshold;
    const double valley = options.valleys ? options.valley_threshold : options.ridge_threshold;
    RidgesAndValleys finder(seen, derivative, ridge, valley);
    append_seen(link_segments(surface, finder.segments(), limits), Kind::ridge, options, result);
  }
  return result;
}

}  // namespace illustrate
