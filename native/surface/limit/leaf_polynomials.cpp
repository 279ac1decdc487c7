#include "surface/limit/leaf_polynomials.h"

#include <opensubdiv/bfr/patchTree.h>

#include <algorithm>

namespace illustrate {
namespace {

namespace Far = OpenSubdiv::Far;

constexpr int most_leaves = 64;

// Of a box spline, a B-spline, and at most of a patch beside an extraordinary vertex.
constexpr std::size_t triangle_points = 12, quad_points = 16, most_points = 20;

using Tree = OpenSubdiv::Bfr::internal::IrregularPatchType;
using Weights = std::array<double, most_points>;

// The points of one patch of a tree.
class PatchPoints {
 public:
  template <typename TreePoint>
  PatchPoints(const Tree& tree, int patch, const TreePoint& tree_point)
      : tree_(tree), patch_(patch) {
    for (const int i : tree.GetSubPatchPoints(patch)) points_[count_++] = tree_point(i);
  }

  template <std::size_t count>
  std::array<Vec3, count> all() const {
    std::array<Vec3, count> points;
    std::copy_n(points_.begin(), count, points.begin());
    return points;
  }

  Vec3 position(const Vec2& uv) const {
    Weights weights;
    tree_.EvalSubPatchBasis<double>(patch_, uv.x(), uv.y(), weights.data(), nullptr, nullptr,
                                    nullptr, nullptr, nullptr);
    return sum(weights);
  }

  LimitPoint evaluate(const Vec2& uv) const {
    std::array<Weights, 6> weights;
    tree_.EvalSubPatchBasis(patch_, uv.x(), uv.y(), weights[0].data(), weights[1].data(),
                            weights[2].data(), weights[3].data(), weights[4].data(),
                            weights[5].data());
    LimitPoint p;
    const std::array<Vec3*, 6> sums{&p.position, &p.du, &p.dv, &p.duu, &p.duv, &p.dvv};
    for (std::size_t d = 0; d < sums.size(); ++d) *sums[d] = sum(weights[d]);
    return p;
  }

 private:
  Vec3 sum(const Weights& weights) const {
    Vec3 total = Vec3::Zero();
    for (std::size_t i = 0; i < count_; ++i) total += weights[i] * points_[i];
    return total;
  }

  const Tree& tree_;
  int patch_;
  std::size_t count_ = 0;
  std::array<Vec3, most_points> points_;
};

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

// Leaves end along edges of triangles, where contours are asked for, and beside an extraordinary
// point the curvature of one does not go over into that of the next: rounding is not to say which
// one it is. So a point counts as nearer by this share to the middle of a triangle, through which
// no border runs: that is a millionth of the smallest leaf, and more than rounding for each border.
constexpr double past_border = 1e-9;

}  // namespace

LeafPolynomials::LeafPolynomials(Tree tree, Points controls, LeafRoom& room)
    : tree_(std::move(tree)),
      controls_(std::move(controls)),
      room_(room),
      triangular_(false),
      leaves_(idx(std::min(tree_->GetNumPatches(), most_leaves))) {
  for (int i = 0; i < tree_->GetNumPatches(); ++i) {
    triangular_ |= tree_->GetSubPatchParam(i).IsRegular() &&
                   idx(tree_->GetSubPatchPoints(i).size()) == triangle_points;
  }
}

LeafPolynomials::~LeafPolynomials() {
  for (const auto& slot : leaves_) {
    const Leaf* leaf = slot.load();
    if (leaf) room_.give_back(sizeof(Leaf));
    delete leaf;
  }
}

LimitPoint LeafPolynomials::evaluate(int sub_face, const Vec2& uv) const {
  const Vec2 within = uv + past_border * (Vec2(1. / 3, 1. / 3) - uv);
  const int index = tree_->FindSubPatch(within.x(), within.y(), sub_face);
  const bool may_be_kept = idx(index) < leaves_.size();
  if (!may_be_kept || !tree_->GetSubPatchParam(index).IsRegular()) return evaluate_patch(index, uv);
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
  const PatchPoints points(*tree_, index, [&](int i) { return tree_point(i); });
  const auto polynomial = [&] {
    if (place.GetBoundary() == 0) {
      return triangular_ ? PolynomialPatch::box_spline(points.all<triangle_points>())
                         : PolynomialPatch::b_spline(points.all<quad_points>());
    }
    const auto position = [&](const Vec2& uv) { return points.position(face_uv(uv)); };
    const auto corner = [&](const Vec2& uv) { return points.evaluate(face_uv(uv)); };
    return triangular_ ? PolynomialPatch::quartic(position) : bicubic(corner, place);
  };
  const Vec2 first = face_uv({0, 0});
  return std::make_unique<const Leaf>(Leaf{first, face_uv({1, 0}).x() - first.x(), polynomial()});
}

// OpenSubdiv's derivatives are by a quad's coordinates, also in the sub-face of a corner, which has
// half of a quad's length.
LimitPoint LeafPolynomials::evaluate_patch(int index, const Vec2& uv) const {
  LimitPoint p = PatchPoints(*tree_, index, [&](int i) { return tree_point(i); }).evaluate(uv);
  if (!tree_->HasSubFaces()) return p;
  for (Vec3* first : {&p.du, &p.dv}) *first /= 2;
  for (Vec3* second : {&p.duu, &p.duv, &p.dvv}) *second /= 4;
  return p;
}

// A control point, or what a row of the tree's matrix makes of all of them.
Vec3 LeafPolynomials::tree_point(int index) const {
  if (idx(index) < controls_.size()) return controls_[idx(index)];
  const std::size_t row = idx(index) - controls_.size();
  const double* weights = tree_->GetStencilMatrix<double>() + row * controls_.size();
  Vec3 total = weights[0] * controls_[0];
  for (std::size_t i = 1; i < controls_.size(); ++i) total += weights[i] * controls_[i];
  return total;
}

}  // namespace illustrate
