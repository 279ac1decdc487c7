#include "field/problem/coplanar.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/disjoint_sets.h"

namespace illustrate {
namespace {

// What turns less, and lies so much of its size off, is in one plane for the eye.
constexpr double least_cosine = 1 - 1e-6;
constexpr double least_offset = 1e-3;

// A gap this much of the smaller face's shorter side is a joint.
constexpr double widest_joint = 0.05;

Vec3 across(const PlaneFace& plane) { return plane.normal.cross(plane.direction); }

double size(const PlaneFace& plane) { return plane.half.norm(); }

double joint(const PlaneFace& a, const PlaneFace& b) {
  return widest_joint * 2 * std::min(a.half.minCoeff(), b.half.minCoeff());
}

bool is_coplanar(const PlaneFace& a, const PlaneFace& b) {
  if (!(a.normal.dot(b.normal) >= least_cosine)) return false;
  const double off = std::abs(a.normal.dot(b.centre - a.centre));
  return off <= least_offset * (size(a) + size(b));
}

// Half of the rectangle as it shows along a unit vector.
double reach(const PlaneFace& plane, const Vec3& axis) {
  return std::abs(axis.dot(plane.direction)) * plane.half.x() +
         std::abs(axis.dot(across(plane))) * plane.half.y();
}

// Two rectangles are apart if they are along a side of one of them.
bool touch(const PlaneFace& a, const PlaneFace& b) {
  const Vec3 way = b.centre - a.centre;
  const double gap = joint(a, b);
  const auto are_apart = [&](const Vec3& axis) {
    return std::abs(axis.dot(way)) > reach(a, axis) + reach(b, axis) + gap;
  };
  return !are_apart(a.direction) && !are_apart(across(a)) && !are_apart(b.direction) &&
         !are_apart(across(b));
}

// Of the rectangle and the widest joint round it, along x.
Eigen::AlignedBox1d extent(const PlaneFace& plane) {
  using Point = Eigen::Matrix<double, 1, 1>;
  const double half = reach(plane, Vec3::UnitX()) + joint(plane, plane);
  return {Point(plane.centre.x() - half), Point(plane.centre.x() + half)};
}

}  // namespace

std::vector<int> coplanar_groups(const std::vector<PlaneFace>& planes, bool across_objects) {
  DisjointSets groups(planes.size());
  std::vector<int> order(planes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto start = [&](int p) { return extent(planes[idx(p)]).min()[0]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return start(a) < start(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PlaneFace& a = planes[idx(order[i])];
    const double end = extent(a).max()[0];
    for (std::size_t j = i + 1; j < order.size() && start(order[j]) <= end; ++j) {
      const PlaneFace& b = planes[idx(order[j])];
      if (!across_objects && a.object != b.object) continue;
      if (!is_coplanar(a, b) || !touch(a, b)) continue;
      groups.join(order[i], order[j]);
    }
  }
  std::vector<int> roots(planes.size());
  for (std::size_t p = 0; p < roots.size(); ++p) roots[p] = groups.root(static_cast<int>(p));
  return roots;
}

}  // namespace illustrate
