// Lamps with an extent: a rectangle or an ellipse.
#pragma once

#include "tone/light.h"

namespace illustrate {

// The integral over an area light of cosine at the point * cosine at the lamp / distance squared,
// per unit of its area: exact for rectangles, ellipses as polygons of 24 sides of the same area.
// What is below the point's horizon counts for nothing, nor does a lamp seen from behind.
double mean_form_factor(const Light& light, const Vec3& position, const Vec3& normal);

// The place on an area light at (u, v) in [0, 1]^2; equal areas stay equal, also on ellipses.
Vec3 point_on(const Light& light, double u, double v);

}  // namespace illustrate
