// The cross at a place whose normal is known.
#pragma once

#include "field/cross_field.h"

namespace illustrate {

// cross_direction, given the surface's unit normal at the place.
Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& normal, const Vec3& towards);

}  // namespace illustrate
