#include "field/cross_direction.h"

#include <cmath>

namespace illustrate {
namespace {

// v, tangent at normal `from`, carried to normal `to` by the shortest rotation.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double closeness = 1 + from.dot(to);
  if (closeness < 1e-9) return v;
  return v - v.dot(to) / closeness * (from + to);
}

// The branch of the cross of `direction` about `normal` that is nearest to `towards`; `turned` is
// towards x normal.
inline Vec3 nearest_branch(const Vec3& direction, const Vec3& normal, const Vec3& towards,
                           const Vec3& turned) {
  const double along = towards.dot(direction), aside = turned.dot(direction);
  if (std::abs(along) >= std::abs(aside)) return along < 0 ? Vec3(-direction) : direction;
  return aside < 0 ? Vec3(direction.cross(normal)) : Vec3(normal.cross(direction));
}

}  // namespace

CrossField diagonals(const Surface& surface, CrossField field) {
  constexpr double eighth = 0.78539816339744831;
  for (std::size_t v = 0; v < field.directions.size(); ++v) {
    field.theta[v] += eighth;
    Vec3& direction = field.directions[v];
    direction = std::sqrt(0.5) * (direction + surface.normals[v].cross(direction));
  }
  return field;
}

Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& towards) {
  return cross_direction(surface, field, at, normal_at(surface, at), towards);
}

Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& normal, const Vec3& towards) {
  const Triangle& vertices = surface.triangles[static_cast<std::size_t>(at.triangle)];
  const std::array<double, 3> weights{1 - at.b1 - at.b2, at.b1, at.b2};
  std::array<Vec3, 3> corners;
  std::size_t heaviest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto vertex = static_cast<std::size_t>(vertices[k]);
    const Vec3 own =
        surface.corner_sign(at.triangle, static_cast<int>(k)) * surface.normals[vertex];
    corners[k] = carried(field.directions[vertex], own, normal);
    if (weights[k] > weights[heaviest]) heaviest = k;
  }
  const Vec3 turned = towards.cross(normal);
  const Vec3 base = nearest_branch(corners[heaviest], normal, towards, turned);
  const Vec3 turned_base = base.cross(normal);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    sum +=
        weights[k] * (k == heaviest ? base : nearest_branch(corners[k], normal, base, turned_base));
  }
  const Vec3 tangent = sum - sum.dot(normal) * normal;
  const double length = tangent.norm();
  return length > 0 ? nearest_branch(tangent / length, normal, towards, turned) : base;
}

}  // namespace illustrate
