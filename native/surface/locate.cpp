#include "surface/locate.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// Of coordinates that are shares of a triangle: far above their rounding, far below any angle
// between two curves that cross.
constexpr double parallel = 1e-12;

}  // namespace

Vec2 barycentrics(const std::array<Vec3, 3>& corners, const Vec3& p) {
  const Vec3& origin = corners[0];
  const Vec3 u = corners[1] - origin, v = corners[2] - origin;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return Vec2::Zero();
  const double pu = (p - origin).dot(u), pv = (p - origin).dot(v);
  return Vec2(pu * vv - pv * uv, pv * uu - pu * uv) / determinant;
}

Vec2 barycentrics(const Surface& surface, int triangle, const Vec3& p) {
  const Triangle& c = surface.triangles[idx(triangle)];
  const Points& at = surface.positions;
  return barycentrics({at[idx(c[0])], at[idx(c[1])], at[idx(c[2])]}, p);
}

SurfacePoint locate(const Surface& surface, int triangle, const Vec3& p) {
  const Vec2 weights = barycentrics(surface, triangle, p);
  return {triangle, weights.x(), weights.y()};
}

SurfacePoint nearest_on(const Surface& surface, int triangle, const Vec3& p) {
  const Vec2 weights = barycentrics(surface, triangle, p);
  const double b1 = std::clamp(weights.x(), 0.0, 1.0);
  return {triangle, b1, std::clamp(weights.y(), 0.0, 1.0 - b1)};
}

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double& f,
                    double& h) {
  const double determinant = cross(b - a, d - c);
  const double rounding = parallel * ((b - a).norm() + (d - c).norm());
  if (std::abs(determinant) <= rounding) return false;
  f = cross(c - a, d - c) / determinant;
  h = cross(c - a, b - a) / determinant;
  return f >= 0 && f < 1 && h >= 0 && h < 1;
}

double longest_edge(const Surface& surface, int triangle) {
  const Triangle& v = surface.triangles[idx(triangle)];
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = surface.positions[idx(v[idx(k)])];
    longest = std::max(longest, (surface.positions[idx(v[idx(next_corner(k))])] - a).norm());
  }
  return longest;
}

double reach_of_own_curves(const Surface& surface, int triangle) {
  constexpr double of_edge = 3, of_everything = 0.01, of_object = 0.05;
  const double object = surface.object_diagonals[idx(surface.object_of(triangle))];
  return std::min({of_edge * longest_edge(surface, triangle), of_everything * surface.diagonal,
                   of_object * object});
}

}  // namespace illustrate
