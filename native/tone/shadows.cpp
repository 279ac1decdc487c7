#include "tone/shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tone/area_light.h"

namespace illustrate {
namespace {

// Rays start so far above the surface, in edges of its triangle, and end so far before the lamp, in
// lengths of the ray: more than any rounding, less than anybody sees.
constexpr double lift = 1e-4;
constexpr double ray_end = 1 - 1e-6;

constexpr int area_places = 64;  // of an area, that are asked in a half-shadow

// Places that tell whether an area is hidden in part: whatever is wide enters it across its
// outline, so that corners and sides come first.
constexpr std::array<std::array<double, 2>, 8> outline_places{
    {{0, 0}, {1, 1}, {0, 1}, {1, 0}, {0.5, 0}, {0.5, 1}, {0, 0.5}, {1, 0.5}}};
constexpr int inner_places = 8;  // the first of area_places

// The k-th place on an area: the additive sequence whose steps are the first two powers of the
// plastic number's inverse. However many there are, they are even over the area and across it in
// any direction, so that shadows of edges and rods have no steps.
Vec3 place_on(const Light& light, int k) {
  const double u = 0.5 + k * 0.7548776662466927, v = 0.5 + k * 0.5698402909980532;
  return point_on(light, u - std::floor(u), v - std::floor(v));
}

// How many places of an area are over the horizon of a point, and how many of them are seen.
struct Seen {
  int asked = 0;
  int lit = 0;

  bool is_in_part() const { return lit > 0 && lit < asked; }
};

class AreaFromPoint {
 public:
  AreaFromPoint(const Light& light, const Bvh& casters, const Vec3& origin, const Vec3& normal)
      : light_(light), casters_(casters), origin_(origin), normal_(normal) {}

  double share_seen() const {
    Seen seen;
    for (const auto& [u, v] : outline_places) ask(point_on(light_, u, v), seen);
    for (int k = 0; k < inner_places && !seen.is_in_part(); ++k) ask(place_on(light_, k), seen);
    if (seen.is_in_part()) {
      seen = {};
      for (int k = 0; k < area_places; ++k) ask(place_on(light_, k), seen);
    }
    return seen.asked > 0 ? double(seen.lit) / seen.asked : 1;
  }

 private:
  void ask(const Vec3& place, Seen& seen) const {
    const Vec3 ray = place - origin_;
    if (ray.dot(normal_) <= 0) return;
    ++seen.asked;
    seen.lit += casters_.is_hit(origin_, ray, 0, ray_end) ? 0 : 1;
  }

  const Light& light_;
  const Bvh& casters_;
  const Vec3& origin_;
  const Vec3& normal_;
};

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
  constexpr double endless = std::numeric_limits<double>::infinity();
  switch (light.kind) {
    case LightKind::head:
      return 1;
    case LightKind::sun:
      return casters.is_hit(origin, light.vector, 0, endless) ? 0 : 1;
    case LightKind::side:
      return casters.is_hit(origin, side_direction(light, camera), 0, endless) ? 0 : 1;
    default:
      break;
  }
  if (light.kind == LightKind::area && light.has_extent()) {
    return AreaFromPoint(light, casters, origin, normal).share_seen();
  }
  return casters.is_hit(origin, light.vector - origin, 0, ray_end) ? 0 : 1;
}

}  // namespace illustrate
