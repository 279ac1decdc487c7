// Rigid motions with a uniform scale: what leaves the shape of a surface as it is.
#pragma once

#include <optional>

#include "core/types.h"

namespace illustrate {

// p -> scale * rotation * p + translation
struct Similarity {
  Mat3 rotation = Mat3::Identity();  // without a mirror
  double scale = 1;                  // > 0
  Vec3 translation = Vec3::Zero();

  Vec3 point(const Vec3& p) const { return scale * (rotation * p) + translation; }
  Vec3 direction(const Vec3& d) const { return rotation * d; }
  Vec3 length(const Vec3& d) const { return scale * (rotation * d); }

  // The other one first.
  Similarity operator*(const Similarity& other) const {
    return {rotation * other.rotation, scale * other.scale, point(other.translation)};
  }

  bool operator==(const Similarity& other) const {
    return rotation == other.rotation && scale == other.scale && translation == other.translation;
  }
};

// The affine map as a similarity: nothing where it mirrors, or where lengths along any two
// directions are scaled by factors that differ by more than single precision explains
// (tolerance::similarity).
std::optional<Similarity> as_similarity(const Mat4& map);

}  // namespace illustrate
