#include "surface/limit/limit_point.h"

#include <algorithm>

#include "mesh/polygons.h"

namespace illustrate {
namespace {

// Sine of the angle between tangents below which they span no plane, and the share of what they
// were made of below which they vanish: a thousand times what rounding leaves of a sum that cancels
// out, some sizes away from the origin.
constexpr double rounding = 1e-10;

}  // namespace

Vec3 spanned_normal(const Vec3& a, const Vec3& b, double reach, double least) {
  const double shortest = std::min(a.stableNorm(), b.stableNorm());
  if (!(shortest > std::max(rounding * reach, least))) return Vec3::Zero();
  const Vec3 across = unit_or_zero(a).cross(unit_or_zero(b));
  return across.norm() > rounding ? across.normalized() : Vec3::Zero();
}

}  // namespace illustrate
