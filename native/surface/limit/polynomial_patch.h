// A regular piece of the limit surface as one polynomial of its two coordinates: bicubic on quads
// (Catmull-Clark's B-spline), of total degree 4 on triangles (Loop's box spline).
#pragma once

#include <functional>

#include "surface/limit/limit_point.h"

namespace illustrate {

class PolynomialPatch {
 public:
  // The bicubic of a uniform B-spline's 16 control points, four of each row in direction u.
  static PolynomialPatch b_spline(const std::array<Vec3, 16>& controls);

  // The quartic of a box spline's 12 control points, in OpenSubdiv's order: those of the triangle
  // are 4, 5 and 8, at (0, 0), (1, 0) and (0, 1).
  static PolynomialPatch box_spline(const std::array<Vec3, 12>& controls);

  // A bicubic is known by position, du, dv and duv at (0, 0), (1, 0), (0, 1), (1, 1).
  static PolynomialPatch bicubic(const std::array<LimitPoint, 4>& corners);

  // A quartic is known by its values at 15 places of the triangle.
  static PolynomialPatch quartic(const std::function<Vec3(const Vec2& uv)>& position);

  LimitPoint evaluate(const Vec2& uv) const;

 private:
  bool triangular_ = false;
  // Of a bicubic those of u^i v^j at 4 j + i; of a quartic row by row, those of u^i v^0, u^i v^1,
  // ...
  alignas(16) std::array<Vec3, 16> coefficients_;
};

}  // namespace illustrate
