// Signs of determinants, exact for double coordinates.
//
// A filter in plain arithmetic decides nearly always; the rest is computed with expansions,
// unevaluated sums of doubles (Shewchuk 1997). Exact while no product leaves the range of a double:
// coordinates zero or of magnitude 2^-200 .. 2^200.
#pragma once

#include "core/types.h"

namespace illustrate {

// Sign of a * b - c * d.
int sign_of_difference(double a, double b, double c, double d);

// Sign of det(a - d, b - d, c - d): positive where a, b, c appear clockwise seen from d, that is, d
// is behind the counter-clockwise triangle. 0: coplanar.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// The same where plain arithmetic is sure of it, else 0: a quick first answer.
int filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace illustrate
