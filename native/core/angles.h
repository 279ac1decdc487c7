// Angles between directions of any length.
#pragma once

#include <cmath>

#include "core/pi.h"
#include "core/types.h"

namespace illustrate {

// Radians, 0 to pi. By the tangent: the cosine tells small angles and those near pi badly.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

constexpr double radians(double degrees) { return degrees * pi / 180; }

inline double degrees_between(const Vec3& a, const Vec3& b) {
  return angle_between(a, b) * 180 / pi;
}

}  // namespace illustrate
