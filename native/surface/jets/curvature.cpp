#include "surface/jets/curvature.h"

#include <algorithm>
#include <cmath>

#include "mesh/polygons.h"

namespace illustrate {
namespace {

using Mat2 = Eigen::Matrix2d;

// Radians from a point to its neighbours below which a surface is flat: rounding leaves less, and
// its sign would tell of cusps.
constexpr double least_bend = 1e-9;

// Determinant of the parametrisation against the lengths of its tangents: below this there is no
// plane.
constexpr double parallel_tangents = 1e-10;

PrincipalCurvature undefined(const Vec3& normal) {
  PrincipalCurvature result;
  const Vec3 n = normal.isZero() ? Vec3::UnitZ() : normal;
  result.w1 = any_tangent(n);
  result.w2 = n.cross(result.w1);
  return result;
}

// Eigenvalues of a symmetric matrix, the larger magnitude first, and the angle of the first
// direction.
struct Eigen2 {
  double first, second, angle;
};
Eigen2 eigen(const Mat2& m) {
  const double mean = (m(0, 0) + m(1, 1)) / 2, half = (m(0, 0) - m(1, 1)) / 2;
  const double off = (m(0, 1) + m(1, 0)) / 2, radius = std::hypot(half, off);
  // At an umbilic, where any direction will do, atan2(0, 0) gives 0.
  const double angle = std::atan2(off, half) / 2;  // of the larger eigenvalue
  if (mean >= 0) return {mean + radius, mean - radius, angle};
  return {mean - radius, mean + radius, angle + std::acos(0.)};
}

}  // namespace

PrincipalCurvature principal_curvature(const Vec3& du, const Vec3& dv, const Vec3& duu,
                                       const Vec3& duv, const Vec3& dvv, const Vec3& normal) {
  const Vec3 x = unit_or_zero(du - normal.dot(du) * normal);
  if (normal.isZero() || x.isZero()) return undefined(normal);
  const Vec3 y = normal.cross(x);
  Mat2 tangents;  // columns: du, dv in the frame (x, y)
  tangents << x.dot(du), x.dot(dv), y.dot(du), y.dot(dv);
  const double size = du.norm() * dv.norm();
  if (!(std::abs(tangents.determinant()) > parallel_tangents * size)) return undefined(normal);
  Mat2 second;
  second << normal.dot(duu), normal.dot(duv), normal.dot(duv), normal.dot(dvv);
  const Mat2 inverse = tangents.inverse();
  const Mat2 shape = inverse.transpose() * second * inverse;
  if (!shape.allFinite()) return undefined(normal);
  const Eigen2 e = eigen(shape);
  PrincipalCurvature result;
  result.k1 = e.first;
  result.k2 = e.second;
  result.w1 = std::cos(e.angle) * x + std::sin(e.angle) * y;
  result.w2 = normal.cross(result.w1);
  return result;
}

PrincipalCurvature principal_curvature(const LimitPoint& p, const Vec3& normal) {
  const double least = least_bend * std::max(p.du.norm(), p.dv.norm());
  const auto bend = [&](const Vec3& second) -> Vec3 {
    return std::abs(normal.dot(second)) > least ? second : Vec3::Zero();
  };
  return principal_curvature(p.du, p.dv, bend(p.duu), bend(p.duv), bend(p.dvv), normal);
}

}  // namespace illustrate
