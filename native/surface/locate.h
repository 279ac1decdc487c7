// From world positions back to places on the surface.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// Barycentric weights of corners 1 and 2 of the point of the triangle's plane nearest to p; not
// clamped to the triangle; (0, 0) for a triangle without area.
Vec2 barycentrics(const std::array<Vec3, 3>& corners, const Vec3& p);
Vec2 barycentrics(const Surface& surface, int triangle, const Vec3& p);

// At `fraction` of the edge from `corner` to the next one.
inline SurfacePoint on_edge(int triangle, int corner, double fraction) {
  const double rest = 1 - fraction;
  return {triangle,
          corner == 0   ? fraction
          : corner == 1 ? rest
                        : 0,
          corner == 1   ? fraction
          : corner == 2 ? rest
                        : 0};
}

// Whether the segments a b and c d, in shares of a triangle, cross; then at the shares f and h of
// their lengths, each in [0, 1). Not where they are parallel up to rounding: two pieces of a
// straight line would cross anywhere.
bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double& f,
                    double& h);

// The same as `barycentrics`, as a SurfacePoint.
SurfacePoint locate(const Surface& surface, int triangle, const Vec3& p);

// Likewise, but no farther than the triangle's edges.
SurfacePoint nearest_on(const Surface& surface, int triangle, const Vec3& p);

// The length of the longest of the triangle's edges.
double longest_edge(const Surface& surface, int triangle);

// How far from the triangle curves of the curved surface that it stands for may lie: a few of its
// edges, and never more than a hundredth of everything's size, nor a twentieth of the object's: a
// ground may be huge, and so may what stands round a small thing.
double reach_of_own_curves(const Surface& surface, int triangle);

}  // namespace illustrate
