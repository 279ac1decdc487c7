#include "contour/contour_functions.h"

namespace illustrate {

bool ContourFunctions::front(int triangle, int corner) const {
  const int v = surface_.triangles[idx(triangle)][idx(corner)];
  return (g(v) >= 0) == (surface_.corner_sign(triangle, corner) > 0);
}

double ContourFunctions::zero_fraction(int triangle, int corner) const {
  const int a = surface_.triangles[idx(triangle)][idx(corner)];
  const int b = surface_.triangles[idx(triangle)][idx(next_corner(corner))];
  const double zero = zero_between(g(std::min(a, b)), g(std::max(a, b)));
  return a < b ? zero : 1 - zero;
}

Vec3 winding_normal(const Surface& surface, int triangle) {
  const Triangle& corners = surface.triangles[idx(triangle)];
  const Vec3& a = surface.positions[idx(corners[0])];
  return (surface.positions[idx(corners[1])] - a).cross(surface.positions[idx(corners[2])] - a);
}

Vec3 face_normal(const Surface& surface, int triangle) {
  return winding_normal(surface, triangle).normalized();
}

bool is_front_face(const Surface& surface, const Camera& camera, int triangle) {
  const Vec3 view = camera.to_eye(surface.positions[idx(surface.triangles[idx(triangle)][0])]);
  return !(without_facing_noise(face_normal(surface, triangle).dot(view), view) < 0);
}

}  // namespace illustrate
