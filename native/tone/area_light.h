// Lamps with an extent: a rectangle or an ellipse.
#pragma once

#include "tone/light.h"

namespace illustrate {

// The integral over an area light of cosine at the point * cosine at the lamp / distance squared,
// per unit of its area: exact for rectangles, ellipses as polygons of 24 sides of the same area.
// What is below the point's horizon counts for nothing, nor does a lamp seen from behind.
double mean_form_factor(const Light& light, const Vec3& position, const Vec3& normal);

// What of its light an area with a spread sends at a cosine from where it shines to, as a share of
// what one without sends: 1 - tan / tan of half the spread, times what keeps all of its light as
// strong as before. A grid of slats before the lamp does so.
double spread_share(const Light& light, double cosine);

// The same of all that reaches a point: the mean over places on the area, weighted by the two
// cosines and the distance.
double mean_spread_share(const Light& light, const Vec3& position, const Vec3& normal);

// The place on an area light at (u, v) in [0, 1]^2; equal areas stay equal, also on ellipses.
Vec3 point_on(const Light& light, double u, double v);

}  // namespace illustrate
