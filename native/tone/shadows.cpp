#include "tone/shadows.h"

#include <algorithm>
#include <limits>

#include "tone/area_light.h"

namespace illustrate {
namespace {

// Rays start so far above the surface, in edges of its triangle, and end so far before the lamp, in
// lengths of the ray: more than any rounding, less than anybody sees.
constexpr double lift = 1e-4;
constexpr double ray_end = 1 - 1e-6;

constexpr int extent_samples = 4;  // along each side of an area

// Of how many of the places (i, j), i and j every `step`, of an area the light reaches `origin`;
// places below the horizon give none and do not count.
struct Reached {
  int lit = 0;
  int asked = 0;
};

Reached reached(const Light& light, const Bvh& casters, const Vec3& origin, const Vec3& normal,
                int step) {
  Reached count;
  for (int i = 0; i < extent_samples; i += step) {
    for (int j = 0; j < extent_samples; j += step) {
      const Vec3 ray =
          point_on(light, (i + 0.5) / extent_samples, (j + 0.5) / extent_samples) - origin;
      if (ray.dot(normal) <= 0) continue;
      ++count.asked;
      count.lit += casters.is_hit(origin, ray, 0, ray_end) ? 0 : 1;
    }
  }
  return count;
}

double share_of_area(const Light& light, const Bvh& casters, const Vec3& origin,
                     const Vec3& normal) {
  Reached count = reached(light, casters, origin, normal, extent_samples - 1);  // the corners
  if (count.lit > 0 && count.lit < count.asked) {
    count = reached(light, casters, origin, normal, 1);
  }
  return count.asked > 0 ? double(count.lit) / count.asked : 1;
}

}  // namespace

// After Hanika, "Hacking the Shadow Terminator": a point below the tangent plane of a corner is
// raised towards it by the corner's weight.
Vec3 shadow_origin(const Surface& surface, const SurfacePoint& at, const Vec3& normal) {
  const Vec3 position = position_at(surface, at);
  const Triangle& corners = surface.triangles[idx(at.triangle)];
  const std::array<double, 3> weights{1 - at.b1 - at.b2, at.b1, at.b2};
  const double side = normal.dot(normal_at(surface, at)) < 0 ? -1 : 1;
  Vec3 origin = position;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3& corner = surface.positions[idx(corners[idx(k)])];
    const Vec3 above =
        side * surface.corner_sign(at.triangle, k) * surface.normals[idx(corners[idx(k)])];
    origin -= weights[idx(k)] * std::min(0.0, above.dot(position - corner)) * above;
    const Vec3& next = surface.positions[idx(corners[idx(next_corner(k))])];
    longest = std::max(longest, (next - corner).squaredNorm());
  }
  return origin + lift * std::sqrt(longest) * normal;
}

double share_reaching(const Light& light, const Camera& camera, const Bvh& casters,
                      const Vec3& origin, const Vec3& normal) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (light.kind) {
    case LightKind::head:
      return 1;
    case LightKind::sun:
      return casters.is_hit(origin, light.vector, 0, infinity) ? 0 : 1;
    case LightKind::side:
      return casters.is_hit(origin, side_direction(light, camera), 0, infinity) ? 0 : 1;
    default:
      break;
  }
  if (light.kind == LightKind::area && light.has_extent()) {
    return share_of_area(light, casters, origin, normal);
  }
  return casters.is_hit(origin, light.vector - origin, 0, ray_end) ? 0 : 1;
}

}  // namespace illustrate
