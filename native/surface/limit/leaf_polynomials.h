// An irregular face of the limit surface (OpenSubdiv Bfr) is a tree of patches. The points of a
// patch are worked out from the control points when it is asked for: of a triangle's tree that has
// hundreds of points one patch needs twelve. Regular leaves are polynomials, which evaluated as
// such take a tenth of the time. Each is made when it is first asked for, the same whoever asks,
// and kept while there is room.
#pragma once

#include <opensubdiv/bfr/irregularPatchType.h>

#include <atomic>
#include <memory>
#include <vector>

#include "surface/limit/polynomial_patch.h"

namespace illustrate {

// What all faces of one mesh may keep in leaves, in bytes; safe between threads.
class LeafRoom {
 public:
  explicit LeafRoom(std::size_t bytes) : left_(static_cast<std::ptrdiff_t>(bytes)) {}

  // Whether so many were left; they are taken then.
  bool take(std::size_t bytes) {
    const auto wanted = static_cast<std::ptrdiff_t>(bytes);
    if (left_.fetch_sub(wanted) >= wanted) return true;
    left_ += wanted;
    return false;
  }

  void give_back(std::size_t bytes) { left_ += static_cast<std::ptrdiff_t>(bytes); }

 private:
  std::atomic<std::ptrdiff_t> left_;
};

class LeafPolynomials {
 public:
  using Tree = OpenSubdiv::Bfr::internal::IrregularPatchSharedPtr;

  // controls: the tree's control points. The room is to outlive this.
  LeafPolynomials(Tree tree, Points controls, LeafRoom& room);
  ~LeafPolynomials();

  // At uv of the face, or of its sub-face, as the tree has them. Safe between threads.
  LimitPoint evaluate(int sub_face, const Vec2& uv) const;

  // Without the polynomials.
  std::size_t bytes() const {
    return sizeof(*this) + sizeof(leaves_[0]) * leaves_.size() + sizeof(Vec3) * controls_.size();
  }

 private:
  // The leaf's own coordinates are (uv - first) / side; side is negative in a triangle turned over.
  struct Leaf {
    Vec2 first;
    double side;
    PolynomialPatch polynomial;

    LimitPoint evaluate(const Vec2& uv) const;
  };

  LimitPoint make_and_evaluate(int index, const Vec2& uv) const;
  std::unique_ptr<const Leaf> make(int index) const;
  LimitPoint evaluate_patch(int index, const Vec2& uv) const;
  Vec3 tree_point(int index) const;

  Tree tree_;
  Points controls_;
  LeafRoom& room_;
  bool triangular_;
  mutable std::vector<std::atomic<const Leaf*>> leaves_;
};

}  // namespace illustrate
