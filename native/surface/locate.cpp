#include "surface/locate.h"

namespace illustrate {

Vec2 barycentrics(const Surface& surface, int triangle, const Vec3& p) {
  const Triangle& c = surface.triangles[idx(triangle)];
  const Vec3& origin = surface.positions[idx(c[0])];
  const Vec3 u = surface.positions[idx(c[1])] - origin, v = surface.positions[idx(c[2])] - origin;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return Vec2::Zero();
  const double pu = (p - origin).dot(u), pv = (p - origin).dot(v);
  return Vec2(pu * vv - pv * uv, pv * uu - pu * uv) / determinant;
}

SurfacePoint on_edge(int triangle, int corner, double fraction) {
  std::array<double, 3> weights{0, 0, 0};
  weights[idx(corner)] = 1 - fraction;
  weights[idx(next_corner(corner))] = fraction;
  return {triangle, weights[1], weights[2]};
}

SurfacePoint locate(const Surface& surface, int triangle, const Vec3& p) {
  const Vec2 weights = barycentrics(surface, triangle, p);
  return {triangle, weights.x(), weights.y()};
}

}  // namespace illustrate
