// The plain data that flows between the stages.
//
// Everything is double precision. World coordinates are whatever the caller's scene uses. Image
// coordinates are pixels, origin top left, y down; pixel (i, j) covers [i, i+1) x [j, j+1).
// An index names an element; `none` (-1) is no element.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace illustrate {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;

using Points = std::vector<Vec3>;
using ImagePoints = std::vector<Vec2>;
using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;

constexpr int none = -1;

// An index as the standard containers want it.
constexpr std::size_t idx(int i) { return static_cast<std::size_t>(i); }

// Twice the signed area of the triangle 0, a, b.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// A place on the triangulated surface: corner 0 has weight 1 - b1 - b2, corners 1 and 2 have b1,
// b2.
struct SurfacePoint {
  int triangle = none;
  double b1 = 0;
  double b2 = 0;
};

// The corner after and before corner k of a triangle.
constexpr int next_corner(int k) { return k == 2 ? 0 : k + 1; }
constexpr int previous_corner(int k) { return k == 0 ? 2 : k - 1; }

// What a curve is. The numbers are public (`illustrate_native.Kind`) and never change.
enum class Kind : std::uint8_t {
  silhouette = 0,
  boundary = 1,
  crease = 2,
  intersection = 3,
  hatch = 4,
  cross_hatch = 5,  // confined to cross-hatched regions
  undercut = 6,
  mark = 7,
  material = 8,
  flat_outline = 9,
  seam = 10,        // where a non-manifold edge was split: hides what a boundary hides, never drawn
  suggestive = 11,  // suggestive contour
  ridge = 12,
  valley = 13,
  loose = 14,           // an edge of no face: hides nothing, lies on no triangle
  terminator = 15,      // where a form turns away from a light
  shadow_outline = 16,  // of a cast shadow, on what receives it
};

// Lines of shape inside a smooth surface.
constexpr bool is_curvature_line(Kind kind) {
  return kind == Kind::suggestive || kind == Kind::ridge || kind == Kind::valley;
}

// Lines on the surface that neither hide nor bound anything.
constexpr bool is_free_line(Kind kind) {
  return is_curvature_line(kind) || kind == Kind::terminator || kind == Kind::shadow_outline;
}

}  // namespace illustrate
