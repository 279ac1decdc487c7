#include "surface/limit/leaf_polynomials.h"

#include <opensubdiv/bfr/patchTree.h>

#include <algorithm>

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;

constexpr int most_leaves = 64;

// Of a triangle's box spline; a bicubic has 16.
constexpr int triangle_points = 12;

// at: the tree's point at coordinates of the leaf. OpenSubdiv's derivatives are by those of a quad,
// of which a sub-face is a half.
template <typename At>
PolynomialPatch bicubic(const At& at, const Far::PatchParam& place) {
  std::array<LimitPoint, 4> corners{at({0, 0}), at({1, 0}), at({0, 1}), at({1, 1})};
  const double side = 1. / (1 << place.GetDepth());
  for (LimitPoint& p : corners) {
    p.du *= side;
    p.dv *= side;
    p.duv *= side * side;
  }
  return PolynomialPatch::bicubic(corners);
}

}  // namespace

LeafPolynomials::LeafPolynomials(Tree tree, const std::vector<double>& patch_points, LeafRoom& room)
    : tree_(std::move(tree)),
      patch_points_(patch_points),
      room_(room),
      triangular_(false),
      leaves_(idx(std::min(tree_->GetNumPatches(), most_leaves))) {
  for (int i = 0; i < tree_->GetNumPatches(); ++i) {
    triangular_ |= tree_->GetSubPatchParam(i).IsRegular() &&
                   tree_->GetSubPatchPoints(i).size() == triangle_points;
  }
}

LeafPolynomials::~LeafPolynomials() {
  for (const auto& slot : leaves_) {
    const Leaf* leaf = slot.load();
    if (leaf) room_.give_back(sizeof(Leaf));
    delete leaf;
  }
}

std::optional<LimitPoint> LeafPolynomials::evaluate(int sub_face, const Vec2& uv) const {
  const int index = tree_->FindSubPatch(uv.x(), uv.y(), sub_face);
  const bool may_be_kept = index >= 0 && idx(index) < leaves_.size();
  if (!may_be_kept || !tree_->GetSubPatchParam(index).IsRegular()) return {};
  const Leaf* leaf = leaves_[idx(index)].load(std::memory_order_acquire);
  return leaf ? leaf->evaluate(uv) : make_and_evaluate(index, uv);
}

LimitPoint LeafPolynomials::Leaf::evaluate(const Vec2& uv) const {
  LimitPoint p = polynomial.evaluate((uv - first) / side);
  for (Vec3* slope : {&p.du, &p.dv}) *slope /= side;
  for (Vec3* second : {&p.duu, &p.duv, &p.dvv}) *second /= side * side;
  return p;
}

LimitPoint LeafPolynomials::make_and_evaluate(int index, const Vec2& uv) const {
  std::unique_ptr<const Leaf> made = make(index);
  const LimitPoint p = made->evaluate(uv);
  if (!room_.take(sizeof(Leaf))) return p;
  const Leaf* other = nullptr;
  // Another thread may have been first: its leaf has the same bits, so either will do.
  if (leaves_[idx(index)].compare_exchange_strong(other, made.get())) {
    made.release();
  } else {
    room_.give_back(sizeof(Leaf));
  }
  return p;
}

std::unique_ptr<const LeafPolynomials::Leaf> LeafPolynomials::make(int index) const {
  const Far::PatchParam place = tree_->GetSubPatchParam(index);
  const auto face_uv = [&](Vec2 uv) {
    triangular_ ? place.UnnormalizeTriangle(uv.x(), uv.y()) : place.Unnormalize(uv.x(), uv.y());
    return uv;
  };
  const auto position = [&](const Vec2& uv) { return position_in_tree(index, face_uv(uv)); };
  const auto corner = [&](const Vec2& uv) { return evaluate_tree(index, face_uv(uv)); };
  const Vec2 first = face_uv({0, 0});
  return std::make_unique<const Leaf>(
      Leaf{first, face_uv({1, 0}).x() - first.x(),
           triangular_ ? PolynomialPatch::quartic(position) : bicubic(corner, place)});
}

LimitPoint LeafPolynomials::evaluate_tree(int index, const Vec2& uv) const {
  std::array<std::array<double, 16>, 6> weights;
  tree_->EvalSubPatchBasis(index, uv.x(), uv.y(), weights[0].data(), weights[1].data(),
                           weights[2].data(), weights[3].data(), weights[4].data(),
                           weights[5].data());
  LimitPoint p;
  const std::array<Vec3*, 6> sums{&p.position, &p.du, &p.dv, &p.duu, &p.duv, &p.dvv};
  for (std::size_t d = 0; d < sums.size(); ++d) *sums[d] = sum(index, weights[d]);
  return p;
}

Vec3 LeafPolynomials::position_in_tree(int index, const Vec2& uv) const {
  std::array<double, 16> weights;
  tree_->EvalSubPatchBasis<double>(index, uv.x(), uv.y(), weights.data(), nullptr, nullptr, nullptr,
                                   nullptr, nullptr);
  return sum(index, weights);
}

Vec3 LeafPolynomials::sum(int index, const std::array<double, 16>& weights) const {
  const auto points = tree_->GetSubPatchPoints(index);
  Vec3 total = Vec3::Zero();
  for (int i = 0; i < points.size(); ++i) {
    total += weights[idx(i)] * Eigen::Map<const Vec3>(patch_points_.data() + 3 * idx(points[i]));
  }
  return total;
}

}  // namespace illustrate
