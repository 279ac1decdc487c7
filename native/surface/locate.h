// From world positions back to places on the surface.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// Barycentric weights of corners 1 and 2 of the point of the triangle's plane nearest to p; not
// clamped to the triangle; (0, 0) for a triangle without area.
Vec2 barycentrics(const Surface& surface, int triangle, const Vec3& p);

// At `fraction` of the edge from `corner` to the next one.
SurfacePoint on_edge(int triangle, int corner, double fraction);

// The same as `barycentrics`, as a SurfacePoint.
SurfacePoint locate(const Surface& surface, int triangle, const Vec3& p);

}  // namespace illustrate
