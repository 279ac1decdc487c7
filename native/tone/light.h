// Lights and the brightness they give a point (paper section 6.1).
#pragma once

#include "core/pi.h"
#include "view/camera.h"

namespace illustrate {

// ambient: from everywhere, as strong at every place and for every normal.
enum class LightKind : std::uint8_t { head, sun, point, spot, area, side, ambient };

struct Light {
  LightKind kind = LightKind::head;
  // sun: direction towards the light, world; side: the same as the viewer sees it (right, up,
  // towards the viewer); point, spot, area: position.
  Vec3 vector = Vec3::Zero();
  double strength = 1;
  Vec3 direction = -Vec3::UnitZ();  // spot, area: where it shines
  double angle_rad = 0;             // spot: half angle of its cone
  double blend = 0;                 // spot: share of the cone over which it fades, [0, 1]
  bool cosine = true;  // spot: weaker by the cosine from its axis; else by `blend` only
  // area: its light stays within this angle from where it shines to, as between slats, pi: all
  // before it; as much light in all, in (0, pi].
  double spread_rad = pi;
  double radius = 0;  // point, spot: of what shines; it softens the fall-off, not the shadows
  // point, spot, area: the distance at which it is as strong as `strength` (with a radius: at which
  // a point would be), which falls with the square of the distance; 0: as strong everywhere.
  double falloff_distance = 0;
  Vec3 edge_u = Vec3::Zero();  // area: sides of its rectangle, centred at its position; both zero:
  Vec3 edge_v = Vec3::Zero();  // no larger than a point
  bool ellipse = false;        // area: the ellipse that touches the rectangle's sides instead
  bool casts_shadows = true;   // where shadows are asked for
  bool contours = true;  // has lines of its light (light_contours.h), where they are asked for

  bool has_extent() const { return !edge_u.isZero(0) || !edge_v.isZero(0); }
};

// Throws InvalidInput naming the field of light `index`.
void validate(const Light& light, std::size_t index);

// What one light gives to a point, unless something is between them: strength * max(0, n . l), of
// ambient light its strength, of spots and areas times what the lamp sends that way; of areas with
// an extent summed over it, exactly without a spread. `normal`: unit, turned to the eye.
double received(const Light& light, const Camera& camera, const Vec3& position, const Vec3& normal);

// min(1, sum of what is received), `normal` of either side. No lights: one headlight.
double brightness(const std::vector<Light>& lights, const Camera& camera, const Vec3& position,
                  const Vec3& normal);

// Where the light at a point comes from: the mean of the unit directions towards the lights, each
// as strong as it is there; shorter than 1 the more sides it comes from, zero in the dark.
// Headlights and ambient light count, but come from no side. No lights: zero.
Vec3 light_side(const std::vector<Light>& lights, const Camera& camera, const Vec3& position);

// World direction towards a side light.
Vec3 side_direction(const Light& light, const Camera& camera);

}  // namespace illustrate
