#include "tone/light.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors.h"

namespace illustrate {
namespace {

Vec3 unit(const Vec3& v) {
  const double length = v.stableNorm();
  return length > 0 ? Vec3(v / length) : Vec3::Zero();
}

// What of its light a lamp sends along `ray`, a unit vector away from the lamp.
double lobe(const Light& light, const Vec3& ray) {
  const double cosine = unit(light.direction).dot(ray);
  switch (light.kind) {
    case LightKind::spot:
      return cosine >= std::cos(light.angle_rad) ? std::max(0.0, cosine) : 0;
    case LightKind::area:
      return std::max(0.0, cosine);
    default:
      return 1;
  }
}

double received(const Light& light, const Vec3& position, const Vec3& normal, const Vec3& to_eye) {
  switch (light.kind) {
    case LightKind::head:
      return light.strength * std::max(0.0, normal.dot(to_eye));
    case LightKind::sun:
      return light.strength * std::max(0.0, normal.dot(unit(light.vector)));
    default:
      break;
  }
  const Vec3 to_light = unit(light.vector - position);
  return light.strength * std::max(0.0, normal.dot(to_light)) * lobe(light, -to_light);
}

}  // namespace

void validate(const Light& light, std::size_t index) {
  const std::string name = "lights[" + std::to_string(index) + "].";
  if (static_cast<int>(light.kind) > static_cast<int>(LightKind::area)) {
    throw InvalidInput(name + "kind is unknown");
  }
  if (!light.vector.allFinite()) throw InvalidInput(name + "vector must be finite");
  if (!light.direction.allFinite()) throw InvalidInput(name + "direction must be finite");
  if (!(light.strength >= 0) || !std::isfinite(light.strength)) {
    throw InvalidInput(name + "strength must be finite and at least 0");
  }
  const bool has_lobe = light.kind == LightKind::spot || light.kind == LightKind::area;
  if (light.kind == LightKind::sun && light.vector.isZero(0)) {
    throw InvalidInput(name + "vector must point towards the sun, it is zero");
  }
  if (has_lobe && light.direction.isZero(0)) {
    throw InvalidInput(name + "direction must not be zero");
  }
  if (light.kind == LightKind::spot && !(light.angle_rad > 0 && light.angle_rad <= 3.2)) {
    throw InvalidInput(name + "angle_rad must be the half angle of the cone, in (0, pi]");
  }
}

double brightness(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& normal) {
  const Vec3 to_eye = unit(camera.to_eye(position));
  const Vec3 n = normal.dot(to_eye) < 0 ? Vec3(-normal) : normal;
  if (lights.empty()) return std::min(1.0, std::max(0.0, n.dot(to_eye)));
  double sum = 0;
  for (const Light& light : lights) sum += received(light, position, n, to_eye);
  return std::min(1.0, sum);
}

}  // namespace illustrate
