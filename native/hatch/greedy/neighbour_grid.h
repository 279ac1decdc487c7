// Points of placed hatches, found by their place in the image (paper section 6.4).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/types.h"

namespace illustrate {

struct HatchNode {
  Vec2 image;
  Vec3 tangent;  // unit, world
  int point;     // its index in Hatches::curves.values
};

// The paper's angle test: tangent t2 against the unit tangent t1 of a point with unit normal n,
// after projection to its tangent plane.
inline bool are_parallel(const Vec3& t1, const Vec3& n, const Vec3& t2) {
  const Vec3 projected = t2 - n.dot(t2) * n;
  const double along = t1.dot(projected);
  return 2 * along * along > projected.squaredNorm();
}

// A grid of square cells: within one cell size of a point, nine cells are searched.
class NeighbourGrid {
 public:
  NeighbourGrid(double width_px, double height_px, double cell_px)
      : cell_px_(std::max(1.0, cell_px)),
        columns_(1 + static_cast<int>(width_px / cell_px_)),
        rows_(1 + static_cast<int>(height_px / cell_px_)),
        cells_(idx(columns_) * idx(rows_)) {}

  void add(const HatchNode& node) {
    cells_[idx(row_of(node.image.y()) * columns_ + column_of(node.image.x()))].push_back(node);
  }

  // Whether `test` accepts a node nearer to p than `radius`; it is asked cell by cell in order of
  // entry.
  template <class Test>
  bool any_within(const Vec2& p, double radius, const Test& test) const {
    const int row_end = row_of(p.y() + radius), column_end = column_of(p.x() + radius);
    for (int row = row_of(p.y() - radius); row <= row_end; ++row) {
      for (int column = column_of(p.x() - radius); column <= column_end; ++column) {
        for (const HatchNode& node : cells_[idx(row * columns_ + column)]) {
          if ((node.image - p).squaredNorm() < radius * radius && test(node)) return true;
        }
      }
    }
    return false;
  }

 private:
  int column_of(double x) const {
    return static_cast<int>(std::clamp(x / cell_px_, 0.0, columns_ - 1.0));
  }
  int row_of(double y) const {
    return static_cast<int>(std::clamp(y / cell_px_, 0.0, rows_ - 1.0));
  }

  double cell_px_;
  int columns_, rows_;
  std::vector<std::vector<HatchNode>> cells_;
};

}  // namespace illustrate
