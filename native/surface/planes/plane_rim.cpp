#include "surface/planes/plane_rim.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "core/tolerances.h"
#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Edges that turn less from each other run the same way: an edge with a slight bow is one.
constexpr double same_way = 0.07;  // radians

// Share of the rim that has to run along or across a direction. A circle of chords has .1, a
// regular pentagon .2.
constexpr double clear_sharp = 0.19, clear_smooth = 0.5;

constexpr double quarter = 1.5707963267948966;

// Edges by their angle modulo a quarter of a circle, three times round, so that there is no end.
class RimAngles {
 public:
  RimAngles(const std::vector<RimEdge>& edges, const Vec3& x, const Vec3& y) {
    for (const auto& [from, to] : edges) {
      const Vec3 edge = to - from;
      const double angle = std::fmod(std::atan2(edge.dot(y), edge.dot(x)) + 4 * quarter, quarter);
      angles_.push_back(std::isfinite(angle) ? angle : 0);
      lengths_.push_back(std::hypot(edge.dot(x), edge.dot(y)));
    }
    std::vector<int> order(edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return angles_[idx(a)] < angles_[idx(b)]; });
    for (int turn = -1; turn <= 1; ++turn) {
      for (const int edge : order) {
        sorted_.push_back(angles_[idx(edge)] + turn * quarter);
        lengths_before_.push_back(lengths_before_.back() + lengths_[idx(edge)]);
        order_.push_back(edge);
      }
    }
  }

  double length() const { return std::accumulate(lengths_.begin(), lengths_.end(), 0.0); }

  // Of all edges that run the same way as one.
  double length_along(std::size_t edge) const {
    const auto [begin, end] = range(angles_[edge]);
    return lengths_before_[end] - lengths_before_[begin];
  }

  double mean_angle(std::size_t edge) const {
    const double centre = angles_[edge];
    const auto [begin, end] = range(centre);
    std::complex<double> sum = 0;
    for (std::size_t k = begin; k < end; ++k) {
      sum += std::polar(lengths_[idx(order_[k])], 4 * (sorted_[k] - centre));
    }
    return centre + std::arg(sum) / 4;
  }

  // The edge whose way most of the rim goes.
  std::size_t common_way() const {
    double most = 0, longest = 0;
    std::size_t best = 0;
    for (std::size_t e = 0; e < lengths_.size(); ++e) {
      const double along = length_along(e);
      const bool is_more = clearly_more(along, most);
      const bool is_longer = !clearly_more(most, along) && clearly_more(lengths_[e], longest);
      if (!is_more && !is_longer) continue;
      most = along;
      longest = lengths_[e];
      best = e;
    }
    return best;
  }

 private:
  static bool clearly_more(double a, double b) { return a > b * (1 + tolerance::same_length); }

  std::pair<std::size_t, std::size_t> range(double centre) const {
    const auto begin = std::lower_bound(sorted_.begin(), sorted_.end(), centre - same_way);
    const auto end = std::upper_bound(begin, sorted_.end(), centre + same_way);
    return {static_cast<std::size_t>(begin - sorted_.begin()),
            static_cast<std::size_t>(end - sorted_.begin())};
  }

  std::vector<double> angles_, lengths_;  // in the order of the rim
  std::vector<double> sorted_;            // angles
  std::vector<int> order_;                // edges by them
  std::vector<double> lengths_before_{0};
};

void surround(const std::vector<RimEdge>& edges, PlaneFace& plane) {
  const Vec3 across = plane.normal.cross(plane.direction), origin = edges.front().from;
  Eigen::AlignedBox2d box;
  for (const RimEdge& edge : edges) {
    const Vec3 p = edge.from - origin;
    box.extend(Vec2(plane.direction.dot(p), across.dot(p)));
  }
  plane.half = box.sizes() / 2;
  plane.centre = origin + box.center().x() * plane.direction + box.center().y() * across;
}

}  // namespace

void measure_rim(const std::vector<RimEdge>& edges, PlaneFace& plane) {
  const Vec3 x = any_tangent(plane.normal), y = plane.normal.cross(x);
  plane.direction = x;
  if (edges.empty()) return;
  const RimAngles rim(edges, x, y);
  const std::size_t way = rim.common_way();
  const double angle = rim.mean_angle(way);
  plane.direction = std::cos(angle) * x + std::sin(angle) * y;
  plane.rim_length = rim.length();
  plane.agreement = plane.rim_length > 0 ? rim.length_along(way) / plane.rim_length : 0;
  surround(edges, plane);
}

bool has_direction(const PlaneFace& plane) {
  return plane.agreement >= (plane.ends_sharply ? clear_sharp : clear_smooth);
}

}  // namespace illustrate
