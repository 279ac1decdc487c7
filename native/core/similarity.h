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
  Similarity inverse() const {
    const Mat3 back = rotation.transpose();
    return {back, 1 / scale, -(back * translation) / scale};
  }

  bool operator==(const Similarity& other) const {
    return rotation == other.rotation && scale == other.scale && translation == other.translation;
  }
};

// Where a similarity takes things. What it leaves in place stays as it is to the bit: the sign of a
// zero does not survive a product with the identity.
class Move {
 public:
  explicit Move(const Similarity& map) : map_(map), is_none_(map == Similarity()) {}

  double scale() const { return map_.scale; }
  Vec3 point(const Vec3& p) const { return is_none_ ? p : map_.point(p); }
  Vec3 direction(const Vec3& d) const { return is_none_ ? d : map_.direction(d); }

 private:
  Similarity map_;
  bool is_none_;
};

// The affine map as a similarity: nothing where it mirrors, or where lengths along any two
// directions are scaled by factors that differ by more than single precision explains
// (tolerance::similarity).
std::optional<Similarity> as_similarity(const Mat4& map);

// The rigid motion, of scale 1, that takes the points from where they were to where they are, by
// least squares (Kabsch 1976, "A solution for the best rotation to relate two sets of vectors"):
// exactly the identity where they are the same to the last bit. Nothing where a point would end
// further from its place than a share of their size (tolerance::similarity), or where a coordinate
// that has changed is not finite.
std::optional<Similarity> rigid_motion(const Points& from, const Points& to);

}  // namespace illustrate
