// Points of placed hatches, found by their place in the image (paper section 6.4).
#pragma once

#include "hatch/view/image_cells.h"

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
      : cells_(width_px, height_px, std::max(1.0, cell_px)), nodes_(idx(cells_.count())) {}

  void add(const HatchNode& node) { nodes_[idx(cells_.of(node.image))].push_back(node); }

  // Whether `test` accepts a node nearer to p than `radius`; it is asked cell by cell in order of
  // entry.
  template <class Test>
  bool any_within(const Vec2& p, double radius, const Test& test) const {
    const int row_end = cells_.row_of(p.y() + radius),
              column_end = cells_.column_of(p.x() + radius);
    for (int row = cells_.row_of(p.y() - radius); row <= row_end; ++row) {
      for (int i = cells_.column_of(p.x() - radius); i <= column_end; ++i) {
        for (const HatchNode& node : nodes_[idx(row * cells_.columns + i)]) {
          if ((node.image - p).squaredNorm() < radius * radius && test(node)) return true;
        }
      }
    }
    return false;
  }

 private:
  ImageCells cells_;
  std::vector<std::vector<HatchNode>> nodes_;  // (cells)
};

}  // namespace illustrate
