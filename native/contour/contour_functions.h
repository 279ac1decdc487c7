// g and the cusp function C at the corners of triangles, with the one rule for ties.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/tolerances.h"
#include "surface/surface.h"
#include "view/camera.h"

namespace illustrate {

// What is left of g, seen along `view`, where it is more than rounding noise.
inline double without_facing_noise(double g, const Vec3& view) {
  const double size = std::abs(g);
  // The sum of its components is never shorter than the vector.
  if (size >=
      tolerance::facing_noise * (std::abs(view.x()) + std::abs(view.y()) + std::abs(view.z())))
    return g;
  return size < tolerance::facing_noise * view.norm() ? 0 : g;
}

// The two functions of paper sections 4.1 and 4.2 at corners, with the sign of the triangle's
// sheet; computed when asked for.
class ContourFunctions {
 public:
  ContourFunctions(const Surface& surface, const Camera& camera)
      : surface_(surface), camera_(camera) {}

  const Camera& camera() const { return camera_; }

  // g at a vertex, on its own sheet; rounding noise is 0. At a tip only its sign is known; it is so
  // small that contours pass there.
  double g(int vertex) const {
    constexpr double at_tip = 1e-9;
    const Vec3 view = camera_.to_eye(surface_.positions[idx(vertex)]);
    const double g = without_facing_noise(surface_.normals[idx(vertex)].dot(view), view);
    return surface_.is_tip(vertex) ? at_tip * g : g;
  }

  // g = 0 is front, decided once per vertex, so that both sheets of a double cover agree.
  bool front(int triangle, int corner) const;

  // Where g vanishes on an edge whose corners differ, from its first corner; the same point from
  // both sides of the edge.
  double zero_fraction(int triangle, int corner) const;

  // C = k1 (v.w1)^2 + k2 (v.w2)^2, v towards the eye, at a vertex, on its own sheet.
  double cusp_function(int vertex) const {
    const Vec3 view = camera_.to_eye(surface_.positions[idx(vertex)]);
    const PrincipalCurvature& c = surface_.curvature[idx(vertex)];
    const double along1 = view.dot(c.w1), along2 = view.dot(c.w2);
    return c.k1 * along1 * along1 + c.k2 * along2 * along2;
  }

 private:
  const Surface& surface_;
  const Camera& camera_;
};

// Where a linear function that is `low` and `high` at the ends of an edge, of different signs,
// vanishes: a share of the edge from `low`, kept off its ends, so that curves through the triangles
// of a fan never meet at its vertex.
inline double zero_between(double low, double high) {
  constexpr double least = 1e-5;  // of an edge: far below what can be seen
  const double sum = std::abs(low) + std::abs(high);
  return std::clamp(sum > 0 ? std::abs(low) / sum : 0.5, least, 1 - least);
}

// Normal of a triangle's plane as it is wound, twice as long as its area.
Vec3 winding_normal(const Surface& surface, int triangle);
// The same as a unit; zero where the triangle has no area.
Vec3 face_normal(const Surface& surface, int triangle);

// Whether a face of a polygon object is front-facing; faces seen exactly edge-on are front.
bool is_front_face(const Surface& surface, const Camera& camera, int triangle);

}  // namespace illustrate
