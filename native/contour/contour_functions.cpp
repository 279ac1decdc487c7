#include "contour/contour_functions.h"

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"

namespace illustrate {
namespace {

// Zeros stay this far from an edge's ends, as a share of the edge: chains through the triangles of
// a fan then never meet at its vertex. Far below what can be seen.
constexpr double least_fraction = 1e-5;

double without_noise(double g, double distance) {
  return std::abs(g) < tolerance::facing_noise * distance ? 0 : g;
}

}  // namespace

ContourFunctions::ContourFunctions(const Surface& surface, const Camera& camera)
    : surface_(surface), camera_(camera), g_(surface.positions.size()) {
  for (std::size_t v = 0; v < g_.size(); ++v) {
    const Vec3 view = camera.to_eye(surface.positions[v]);
    g_[v] = without_noise(surface.normals[v].dot(view), view.norm());
  }
}

bool ContourFunctions::front(int triangle, int corner) const {
  const int v = surface_.triangles[idx(triangle)][idx(corner)];
  return (g_[idx(v)] >= 0) == (surface_.corner_sign(triangle, corner) > 0);
}

double ContourFunctions::zero_fraction(int triangle, int corner) const {
  const int a = surface_.triangles[idx(triangle)][idx(corner)];
  const int b = surface_.triangles[idx(triangle)][idx(next_corner(corner))];
  const double g_low = std::abs(g_[idx(std::min(a, b))]);
  const double sum = g_low + std::abs(g_[idx(std::max(a, b))]);
  const double zero = std::clamp(sum > 0 ? g_low / sum : 0.5, least_fraction, 1 - least_fraction);
  return a < b ? zero : 1 - zero;
}

double ContourFunctions::cusp_at_vertex(int vertex) const {
  const Vec3 view = camera_.to_eye(surface_.positions[idx(vertex)]);
  const Curvature& c = surface_.curvature;
  const double along1 = view.dot(c.w1[idx(vertex)]), along2 = view.dot(c.w2[idx(vertex)]);
  return c.k1[idx(vertex)] * along1 * along1 + c.k2[idx(vertex)] * along2 * along2;
}

double ContourFunctions::cusp_function(int triangle, int corner, double fraction) const {
  const int next = next_corner(corner);
  const int a = surface_.triangles[idx(triangle)][idx(corner)];
  const int b = surface_.triangles[idx(triangle)][idx(next)];
  const double here = (1 - fraction) * cusp_at_vertex(a) * surface_.corner_sign(triangle, corner);
  const double there = fraction * cusp_at_vertex(b) * surface_.corner_sign(triangle, next);
  return a < b ? here + there : there + here;
}

bool is_front_face(const Surface& surface, const Camera& camera, int triangle) {
  const Triangle& corners = surface.triangles[idx(triangle)];
  const Vec3& a = surface.positions[idx(corners[0])];
  const Vec3 normal = (surface.positions[idx(corners[1])] - a)
                          .cross(surface.positions[idx(corners[2])] - a)
                          .normalized();
  const Vec3 view = camera.to_eye(a);
  return !(without_noise(normal.dot(view), view.norm()) < 0);
}

}  // namespace illustrate
