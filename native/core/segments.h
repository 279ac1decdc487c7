// Segments of the plane.
#pragma once

#include <algorithm>

#include "core/types.h"

namespace illustrate {

// The share of the way from a to b at which p is nearest; 0 where a and b are one point.
inline double nearest_share(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
}

}  // namespace illustrate
