// The limit surface and its derivatives in the coordinates of a ptex face.
#pragma once

#include "core/types.h"

namespace illustrate {

struct LimitPoint {
  Vec3 position, du, dv, duu, duv, dvv;
};

// Unit normal of the plane that two tangents span. Zero where nothing but rounding tells it: where
// they are parallel, one is shorter than `least`, or vanishes beside `reach`, the longest of what
// they were made of.
Vec3 spanned_normal(const Vec3& a, const Vec3& b, double reach, double least);

}  // namespace illustrate
