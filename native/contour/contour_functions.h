// g and the cusp function C at the corners of triangles, with the one rule for ties.
#pragma once

#include "surface/surface.h"
#include "view/camera.h"

namespace illustrate {

// The two functions of paper sections 4.1 and 4.2 at corners, with the sign of the triangle's
// sheet; computed when asked for.
class ContourFunctions {
 public:
  ContourFunctions(const Surface& surface, const Camera& camera)
      : surface_(surface), camera_(camera) {}

  const Camera& camera() const { return camera_; }

  // g at a vertex, on its own sheet; rounding noise is 0.
  double g(int vertex) const;

  // g = 0 is front, decided once per vertex, so that both sheets of a double cover agree.
  bool front(int triangle, int corner) const;

  // Where g vanishes on an edge whose corners differ, from its first corner; the same point from
  // both sides of the edge.
  double zero_fraction(int triangle, int corner) const;

  // C = k1 (v.w1)^2 + k2 (v.w2)^2, v towards the eye, at the corners of a triangle.
  std::array<double, 3> cusp_functions(int triangle) const;

 private:
  double cusp_at_vertex(int vertex) const;

  const Surface& surface_;
  const Camera& camera_;
};

// Where a linear function that is `low` and `high` at the ends of an edge, of different signs,
// vanishes: a share of the edge from `low`, kept off its ends, so that curves through the triangles
// of a fan never meet at its vertex.
double zero_between(double low, double high);

// Normal of a triangle's plane as it is wound, twice as long as its area.
Vec3 winding_normal(const Surface& surface, int triangle);
// The same as a unit; zero where the triangle has no area.
Vec3 face_normal(const Surface& surface, int triangle);

// Whether a face of a polygon object is front-facing; faces seen exactly edge-on are front.
bool is_front_face(const Surface& surface, const Camera& camera, int triangle);

}  // namespace illustrate
