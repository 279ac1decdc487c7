// Cast shadows: rays to the lights.
#pragma once

#include "mesh/bvh.h"
#include "surface/surface.h"
#include "tone/light.h"

namespace illustrate {

// Where rays from a point of the surface start, so that its triangles throw no shadow on the smooth
// surface they stand for. `normal`: unit, of the lit side.
Vec3 shadow_origin(const Surface& surface, const SurfacePoint& at, const Vec3& normal);

// The share of a light that reaches `origin`, in [0, 1]: all or nothing, but for areas with an
// extent, told by sixty-four places where some but not all of sixteen others are hidden.
// Headlights reach all that is seen.
double share_reaching(const Light& light, const Camera& camera, const Bvh& casters,
                      const Vec3& origin, const Vec3& normal);

}  // namespace illustrate
