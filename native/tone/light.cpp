#include "tone/light.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors.h"
#include "tone/area_light.h"

namespace illustrate {
namespace {

Vec3 unit(const Vec3& v) {
  const double square = v.squaredNorm();
  const bool is_exact = square > 1e-250 && square < 1e250;
  const double length = is_exact ? std::sqrt(square) : v.stableNorm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

bool has_place(LightKind kind) {
  return kind == LightKind::point || kind == LightKind::spot || kind == LightKind::area;
}

// What of its light a spot sends at a cosine from its axis: it fades smoothly towards the edge of
// the cone.
double spot_lobe(const Light& light, double cosine) {
  const double edge = std::cos(light.angle_rad);
  if (!(cosine >= edge)) return 0;
  const double fade = (1 - edge) * light.blend;
  const double t = fade > 0 ? std::min(1.0, (cosine - edge) / fade) : 1;
  return (light.cosine ? std::max(0.0, cosine) : 1) * t * t * (3 - 2 * t);
}

// What of its light a lamp sends along `ray`, a unit vector away from the lamp.
double lobe(const Light& light, const Vec3& ray) {
  const double cosine = unit(light.direction).dot(ray);
  switch (light.kind) {
    case LightKind::spot:
      return spot_lobe(light, cosine);
    case LightKind::area:
      return std::max(0.0, cosine) * spread_share(light, cosine);
    default:
      return 1;
  }
}

// Closer than this share of its distance of full strength a lamp grows no stronger.
constexpr double least_distance = 1e-6;

double from_lamp(const Light& light, const Vec3& position, const Vec3& normal) {
  const Vec3 to_lamp = light.vector - position;
  const double distance = to_lamp.stableNorm(), full = light.falloff_distance;
  if (light.kind == LightKind::area && light.has_extent()) {
    const double scale = full > 0 ? full : distance;
    return light.strength * scale * scale * mean_form_factor(light, position, normal) *
           mean_spread_share(light, position, normal);
  }
  const Vec3 towards = unit(to_lamp);
  const double nearest = std::max(distance, least_distance * full);
  const double share = full > 0 ? full / std::hypot(nearest, light.radius) : 1;
  return light.strength * share * share * std::max(0.0, normal.dot(towards)) *
         lobe(light, -towards);
}

void validate_lobe(const Light& light, const std::string& name) {
  if (light.direction.isZero(0)) throw InvalidInput(name + "direction must not be zero");
  if (light.kind != LightKind::spot) return;
  if (!(light.angle_rad > 0 && light.angle_rad <= 3.2)) {
    throw InvalidInput(name + "angle_rad must be the half angle of the cone, in (0, pi]");
  }
  if (!(light.blend >= 0 && light.blend <= 1)) {
    throw InvalidInput(name + "blend must be in [0, 1]");
  }
}

void validate_extent(const Light& light, const std::string& name) {
  if (!(light.spread_rad > 0 && light.spread_rad <= 3.2)) {
    throw InvalidInput(name + "spread_rad must be an angle in (0, pi]");
  }
  if (!light.edge_u.allFinite() || !light.edge_v.allFinite()) {
    throw InvalidInput(name + "edges must be finite");
  }
  const double area = light.edge_u.cross(light.edge_v).norm();
  if (light.has_extent() && !(area > 0 && std::isfinite(area))) {
    throw InvalidInput(name + "edges must span a rectangle; both zero for a lamp without extent");
  }
}

}  // namespace

void validate(const Light& light, std::size_t index) {
  const std::string name = "lights[" + std::to_string(index) + "].";
  if (static_cast<int>(light.kind) > static_cast<int>(LightKind::ambient)) {
    throw InvalidInput(name + "kind is unknown");
  }
  if (!light.vector.allFinite()) throw InvalidInput(name + "vector must be finite");
  if (!light.direction.allFinite()) throw InvalidInput(name + "direction must be finite");
  if (!(light.strength >= 0) || !std::isfinite(light.strength)) {
    throw InvalidInput(name + "strength must be finite and at least 0");
  }
  if (!(light.falloff_distance >= 0) || !std::isfinite(light.falloff_distance)) {
    throw InvalidInput(name + "falloff_distance must be finite and at least 0");
  }
  if (!(light.radius >= 0) || !std::isfinite(light.radius)) {
    throw InvalidInput(name + "radius must be finite and at least 0");
  }
  const bool is_directed = light.kind == LightKind::sun || light.kind == LightKind::side;
  if (is_directed && light.vector.isZero(0)) {
    throw InvalidInput(name + "vector must point towards the light, it is zero");
  }
  if (light.kind == LightKind::spot || light.kind == LightKind::area) validate_lobe(light, name);
  if (light.kind == LightKind::area) validate_extent(light, name);
}

Vec3 side_direction(const Light& light, const Camera& camera) {
  return unit(camera.view().topLeftCorner<3, 3>().transpose() * light.vector);
}

namespace {

// Unit, from a point towards a light; of ambient light zero.
Vec3 direction_to(const Light& light, const Camera& camera, const Vec3& position) {
  if (light.kind == LightKind::head) return unit(camera.to_eye(position));
  if (light.kind == LightKind::side) return side_direction(light, camera);
  return unit(has_place(light.kind) ? Vec3(light.vector - position) : light.vector);
}

}  // namespace

double received(const Light& light, const Camera& camera, const Vec3& position,
                const Vec3& normal) {
  if (light.kind == LightKind::ambient) return light.strength;
  if (has_place(light.kind)) {
    const double light_there = from_lamp(light, position, normal);
    return std::isfinite(light_there) ? light_there : 0;
  }
  return light.strength * std::max(0.0, normal.dot(direction_to(light, camera, position)));
}

Vec3 light_side(const std::vector<Light>& lights, const Camera& camera, const Vec3& position) {
  Vec3 sum = Vec3::Zero();
  double all = 0;
  for (const Light& light : lights) {
    const Vec3 towards = direction_to(light, camera, position);
    const double strength = received(light, camera, position, towards);
    const bool has_side = light.kind != LightKind::head && light.kind != LightKind::ambient;
    if (has_side) sum += strength * towards;
    all += strength;
  }
  return all > 0 ? Vec3(sum / all) : Vec3::Zero();
}

double brightness(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& normal) {
  const Vec3 to_eye = unit(camera.to_eye(position));
  const Vec3 n = normal.dot(to_eye) < 0 ? Vec3(-normal) : normal;
  if (lights.empty()) return std::min(1.0, std::max(0.0, n.dot(to_eye)));
  double sum = 0;
  for (const Light& light : lights) sum += received(light, camera, position, n);
  return std::min(1.0, sum);
}

}  // namespace illustrate
