// From world positions back to places on the surface.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// Barycentric weights of corners 1 and 2 of the point of the triangle's plane nearest to p; not
// clamped to the triangle; (0, 0) for a triangle without area.
Vec2 barycentrics(const Surface& surface, int triangle, const Vec3& p);

// The same as a SurfacePoint.
SurfacePoint locate(const Surface& surface, int triangle, const Vec3& p);

}  // namespace illustrate
