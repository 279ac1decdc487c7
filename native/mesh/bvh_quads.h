// The boxes of a binary tree four by four, in single precision: a ray is asked about four at once.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/types.h"

namespace illustrate {

struct BvhNode {
  Eigen::AlignedBox3d box;
  int first = 0;  // leaf: its first triangle; inner: index of the left child (right = left + 1)
  int count = 0;  // leaf: number of triangles; inner: 0
};

// What a node holds: four nodes further down, or the triangles of a leaf. Two lines of the
// processor's cache.
struct alignas(64) BvhQuad {
  static constexpr int size = 4;
  using Lanes = Eigen::Array<float, size, 1>;

  std::array<Lanes, 3> low, high;  // as BvhQuads places them; empty boxes where there are fewer
  std::array<int, size> children;  // a quad, or ~ the place of a triangle among those of the leaves
};

// Boxes are moved to the middle of the tree, made smaller by its half size, and rounded outward.
class BvhQuads {
 public:
  BvhQuads() = default;
  // boxes: of the triangles of the leaves.
  BvhQuads(const std::vector<BvhNode>& nodes, const std::vector<Eigen::AlignedBox3d>& boxes);

  const BvhQuad& operator[](int quad) const { return quads_[idx(quad)]; }
  const Vec3& middle() const { return middle_; }
  double scale() const { return scale_; }

 private:
  using Lanes = BvhQuad::Lanes;

  int empty_quad();
  void put(int quad, int lane, const Eigen::AlignedBox3d& box, int child);

  std::vector<BvhQuad> quads_;  // root first
  Vec3 middle_ = Vec3::Zero();
  double scale_ = 1;
};

// The part of a ray within the box of a tree. No box is missed that the ray passes through; a few
// are found that it does not.
class QuadRay {
 public:
  // direction: not zero. From `low`, which is not before the ray enters the box of the tree, to
  // `high`, in units of |direction|. error: how far places on the ray may be off by rounding.
  QuadRay(const BvhQuads& quads, const Vec3& origin, const Vec3& direction, double low, double high,
          double error);

  // Calls use(child) for those whose box the ray passes through, the last one first.
  template <class Use>
  void each_passed(const BvhQuad& quad, const Use& use) const {
    Lanes near = Lanes::Zero(), far = Lanes::Constant(length_);
    for (std::size_t k = 0; k < 3; ++k) {
      const Lanes& in = is_negative_[k] ? quad.high[k] : quad.low[k];
      const Lanes& out = is_negative_[k] ? quad.low[k] : quad.high[k];
      near = near.max((in - near_origin_[k]) * inverse_[k]);
      far = far.min((out - far_origin_[k]) * inverse_[k]);
    }
    far *= slack;
    for (int i = BvhQuad::size; i-- > 0;) {
      if (near[i] <= far[i]) use(quad.children[idx(i)]);
    }
  }

 private:
  using Lanes = BvhQuad::Lanes;
  // More than the roundings of a difference, an inverse and their product, on both sides.
  static constexpr float slack = 1 + 8 * std::numeric_limits<float>::epsilon();

  std::array<float, 3> near_origin_{}, far_origin_{}, inverse_{};
  std::array<bool, 3> is_negative_{};
  float length_;
};

}  // namespace illustrate
