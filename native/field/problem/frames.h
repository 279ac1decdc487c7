// A right-handed frame in the tangent plane of every vertex, and directions as unit complex numbers
// in it (paper section 5: phi_ij is the argument of the direction of edge ij in the frame of i).
#pragma once

#include "core/progress.h"
#include "core/types.h"
#include "field/problem/cross_number.h"

namespace illustrate {

struct TangentFrames {
  Points normals;  // (n) unit, the given ones; z where one has no usable length
  Points x;        // (n) unit tangent: the reference direction that theta is measured from
  Points y;        // (n) normal x x

  std::size_t size() const { return normals.size(); }
  Vec3 direction(std::size_t vertex, double angle) const {
    return std::cos(angle) * x[vertex] + std::sin(angle) * y[vertex];
  }
};

TangentFrames tangent_frames(const Points& normals, int threads, const Progress& progress = {});

// The direction of the projection of v into the tangent plane of a vertex. `otherwise` where the
// projection is shorter than `least` times v.
CrossNumber direction_in_frame(const TangentFrames& frames, std::size_t vertex, const Vec3& v,
                               const CrossNumber& otherwise = 1, double least = 1e-12);

// The angle from `start` to `end` about `normal`, both projected into its plane, in (-pi, pi].
double angle_about(const Vec3& normal, const Vec3& start, const Vec3& end);

}  // namespace illustrate
