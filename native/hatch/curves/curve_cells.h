// Points of curves in space, found by their place: a grid of cells over a box at the origin.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/types.h"

namespace illustrate {

struct CurveNode {
  Eigen::Vector3f position;
  Eigen::Vector3f tangent;  // unit
  Eigen::Vector3f normal;   // unit
  int object;
  int curve;
  int index;  // along the curve; curves grow both ways, from 0
};

class CurveCells {
 public:
  // Cells of about `radius`; larger where there would be too many.
  CurveCells(const Vec3& size, double radius) {
    const double cell = cell_size(size, radius);
    per_unit_ = static_cast<float>(1 / cell);
    for (int axis = 0; axis < 3; ++axis) {
      count_[idx(axis)] = 1 + static_cast<int>(size[axis] / cell);
    }
    first_.assign(idx(count_[0]) * idx(count_[1]) * idx(count_[2]), none);
  }

  void add(const CurveNode& node) {
    const std::array<int, 3> at = cell_of(node.position);
    int& first = first_[number(at[0], at[1], at[2])];
    nodes_.push_back({node, first});
    first = static_cast<int>(nodes_.size()) - 1;
  }

  std::size_t size() const { return nodes_.size(); }

  // Takes the last nodes away again, until `size` are left.
  void shrink(std::size_t size) {
    for (; nodes_.size() > size; nodes_.pop_back()) {
      const std::array<int, 3> at = cell_of(nodes_.back().node.position);
      first_[number(at[0], at[1], at[2])] = nodes_.back().next;
    }
  }

  // Whether `test` accepts a node in the cells that the cube of half side `radius` round p touches;
  // that of p is the first to be searched.
  template <class Test>
  bool any_near(const Eigen::Vector3f& p, float radius, const Test& test) const {
    const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius);
    const std::array<int, 3> own = cell_of(p), from = cell_of(p - reach), to = cell_of(p + reach);
    const std::size_t own_number = number(own[0], own[1], own[2]);
    if (any_in(own_number, test)) return true;
    for (int k = from[2]; k <= to[2]; ++k) {
      for (int j = from[1]; j <= to[1]; ++j) {
        const std::size_t row = number(0, j, k);
        for (std::size_t cell = row + idx(from[0]); cell <= row + idx(to[0]); ++cell) {
          if (cell != own_number && any_in(cell, test)) return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr double most_cells = 2e6;

  // The least that is not below `radius`: of long and of flat boxes the thin sides need few cells.
  static double cell_size(const Vec3& size, double radius) {
    const auto count = [&](double cell) { return (size.array() / cell).floor() + 1; };
    double cell = std::max(radius, size.maxCoeff() / most_cells);
    while (count(cell).prod() > most_cells) cell *= 1.125;
    return cell;
  }

  struct Entry {
    CurveNode node;
    int next;
  };

  template <class Test>
  bool any_in(std::size_t cell, const Test& test) const {
    for (int at = first_[cell]; at != none; at = nodes_[idx(at)].next) {
      if (test(nodes_[idx(at)].node)) return true;
    }
    return false;
  }
  std::array<int, 3> cell_of(const Eigen::Vector3f& p) const {
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis) {
      const float last = static_cast<float>(count_[idx(axis)] - 1);
      cell[idx(axis)] = static_cast<int>(std::min(last, std::max(0.0F, p[axis] * per_unit_)));
    }
    return cell;
  }
  std::size_t number(int i, int j, int k) const {
    return (idx(k) * idx(count_[1]) + idx(j)) * idx(count_[0]) + idx(i);
  }

  float per_unit_ = 1;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<int> first_;  // of each cell, its last added node
  std::vector<Entry> nodes_;
};

}  // namespace illustrate
