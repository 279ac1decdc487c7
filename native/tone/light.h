// Lights and the brightness they give a point (paper section 6.1).
#pragma once

#include "view/camera.h"

namespace illustrate {

enum class LightKind : std::uint8_t { head, sun, point, spot, area };

struct Light {
  LightKind kind = LightKind::head;
  Vec3 vector = Vec3::Zero();  // sun: direction towards the light; point, spot, area: position
  double strength = 1;
  Vec3 direction = -Vec3::UnitZ();  // spot, area: where it shines
  double angle_rad = 0;             // spot: half angle of its cone
};

// Throws InvalidInput naming the field of light `index`.
void validate(const Light& light, std::size_t index);

// min(1, sum of strength * max(0, n . l)), n turned to the eye, spot and area times their cosine
// lobe, no fall-off with distance. No lights: one headlight.
double brightness(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& normal);

}  // namespace illustrate
