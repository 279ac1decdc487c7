#include "field/cross_direction.h"

#include <cmath>

namespace illustrate {
namespace {

// v, tangent at normal `from`, carried to normal `to` by the shortest rotation.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double closeness = 1 + from.dot(to);
  // Between opposite normals no rotation is the shortest.
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

// Tangent directions at a normal, by what they share with two at right angles.
struct Frame2 {
  const Vec3& normal;
  const Vec3& base;
  Vec3 aside;

  // The same as of carried(v, from, normal).
  Vec2 carried(const Vec3& v, const Vec3& from) const {
    const double closeness = 1 + from.dot(normal);
    const double share = closeness < 1e-9 ? 0 : v.dot(normal) / closeness;
    return {v.dot(base) - share * from.dot(base), v.dot(aside) - share * from.dot(aside)};
  }
};

// The branch of a cross that is nearest to the first axis.
inline Vec2 first_branch(const Vec2& v) {
  if (std::abs(v.x()) >= std::abs(v.y())) return v.x() < 0 ? Vec2(-v) : v;
  return v.y() < 0 ? Vec2(-v.y(), v.x()) : Vec2(v.y(), -v.x());
}

inline std::size_t heaviest_of(const std::array<double, 3>& weights) {
  std::size_t heaviest = weights[1] > weights[0] ? 1 : 0;
  return weights[2] > weights[heaviest] ? 2 : heaviest;
}

}  // namespace

Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& towards) {
  return cross_direction(surface, field, at, normal_at(surface, at), towards);
}

Vec3 cross_direction(const Surface& surface, const CrossField& field, const SurfacePoint& at,
                     const Vec3& normal, const Vec3& towards) {
  const Triangle& vertices = surface.triangles[idx(at.triangle)];
  const std::array<double, 3> weights{1 - at.b1 - at.b2, at.b1, at.b2};
  const auto normal_of = [&](std::size_t k) -> Vec3 {
    return surface.corner_sign(at.triangle, static_cast<int>(k)) *
           surface.normals[idx(vertices[k])];
  };
  const auto direction_of = [&](std::size_t k) -> const Vec3& {
    return field.directions[idx(vertices[k])];
  };
  const std::size_t heaviest = heaviest_of(weights);
  const Vec3 turned = towards.cross(normal);
  const Vec3 base = nearest_branch(carried(direction_of(heaviest), normal_of(heaviest), normal),
                                   normal, towards, turned);
  const Frame2 frame{normal, base, normal.cross(base)};
  Vec2 sum = weights[heaviest] * Vec2(base.squaredNorm(), 0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == heaviest) continue;
    sum += weights[k] * first_branch(frame.carried(direction_of(k), normal_of(k)));
  }
  const double length = sum.norm();
  if (!(length > 0)) return base;
  const Vec3 tangent = (sum.x() * frame.base + sum.y() * frame.aside) / length;
  return nearest_branch(tangent, normal, towards, turned);
}

}  // namespace illustrate
