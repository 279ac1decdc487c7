// Normals and triangles of single polygons, planar or not, convex or not.
#pragma once

#include "core/ragged.h"
#include "core/types.h"

namespace illustrate {

// v / |v| without overflow; zero where v has no direction.
Vec3 unit_or_zero(const Vec3& v);
// The same of a sum of unit vectors: zero also where they cancel out but for rounding.
Vec3 unit_of_sum(const Vec3& sum);

// Some unit vector across `v` (unit).
Vec3 any_tangent(const Vec3& v);

// The unit vector at right angles to the unit vector v that is nearest to `wanted`; any where
// `wanted` runs along v.
Vec3 tangent_towards(const Vec3& wanted, const Vec3& v);

// Newell's normal: twice the area vector of the polygon. Any length, zero for a degenerate polygon.
Vec3 newell_normal(Span<const Vec3> polygon);

// n - 2 triangles of corner numbers, wound as the polygon. A quad is split along its shorter
// diagonal, ties towards corner 0, unless only the other one lies inside; larger polygons into
// Delaunay's triangles in Newell's plane.
std::vector<Triangle> triangulate(Span<const Vec3> polygon);

}  // namespace illustrate
