// Nodes of streamlines, found by their place in the image.
#pragma once

#include <algorithm>
#include <cmath>

#include "hatch/streamline.h"

namespace illustrate {

// A node as neighbours see it: a piece of a line, half a step to both sides.
struct GridNode {
  float x, y;    // px
  float ux, uy;  // heading
  float half;    // px, length to each side
  float depth;   // world
  Eigen::Vector3f tangent;
  int streamline;
  int index;
};

class StreamlineGrid {
 public:
  StreamlineGrid(double width_px, double height_px, double cell_px)
      : cell_px_(static_cast<float>(std::max(1e-3, cell_px))),
        columns_(1 + static_cast<int>(width_px / cell_px)),
        rows_(1 + static_cast<int>(height_px / cell_px)),
        first_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none) {}

  void add(const StreamlineNode& node, double half_px, int streamline, int index) {
    int& first =
        first_[cell_of(static_cast<float>(node.image.x()), static_cast<float>(node.image.y()))];
    entries_.push_back({{static_cast<float>(node.image.x()), static_cast<float>(node.image.y()),
                         static_cast<float>(node.heading.x()), static_cast<float>(node.heading.y()),
                         static_cast<float>(half_px), static_cast<float>(node.depth),
                         node.tangent.cast<float>(), streamline, index},
                        first});
    first = static_cast<int>(entries_.size()) - 1;
  }

  void add(const Streamline& streamline, int number) {
    for (std::size_t i = 0; i < streamline.nodes.size(); ++i) {
      add(streamline.nodes[i], streamline.spacing * node_step / 2, number, static_cast<int>(i));
    }
  }

  std::size_t size() const { return entries_.size(); }

  void clear() {
    std::fill(first_.begin(), first_.end(), none);
    entries_.clear();
  }

  // Puts the nodes of a cell side by side in memory, in the order in which they are visited.
  void gather() {
    std::vector<Entry> gathered;
    gathered.reserve(entries_.capacity());
    for (int& first : first_) {
      int at = first;
      if (at != none) first = static_cast<int>(gathered.size());
      for (; at != none; at = entries_[idx(at)].next) {
        gathered.push_back(entries_[idx(at)]);
        gathered.back().next = static_cast<int>(gathered.size());
      }
      if (first != none) gathered.back().next = none;
    }
    entries_.swap(gathered);
  }

  // Takes the last nodes away again, until `size` are left; not those that were gathered.
  void shrink(std::size_t size) {
    for (; entries_.size() > size; entries_.pop_back()) {
      const GridNode& last = entries_.back().node;
      first_[cell_of(last.x, last.y)] = entries_.back().next;
    }
  }

  // Whether `test` accepts a node in the cells that the square of half side `radius` touches. It is
  // asked in the middle cell first, where what is near is most likely.
  template <class Test>
  bool any_near(const Vec2& p, double radius, const Test& test) const {
    const auto middle =
        static_cast<int>(cell_of(static_cast<float>(p.x()), static_cast<float>(p.y())));
    return any_in_cell(first_[idx(middle)], test) ||
           any_in_box(p, Vec2(radius, radius), test, middle);
  }
  // The same for a rectangle of half sides `reach`, cell by cell in their order, without `passed`.
  template <class Test>
  bool any_in_box(const Vec2& p, const Vec2& reach, const Test& test, int passed = none) const {
    const int column_from = column_of(static_cast<float>(p.x() - reach.x()));
    const int column_to = column_of(static_cast<float>(p.x() + reach.x()));
    const int row_to = row_of(static_cast<float>(p.y() + reach.y()));
    for (int row = row_of(static_cast<float>(p.y() - reach.y())); row <= row_to; ++row) {
      for (int column = column_from; column <= column_to; ++column) {
        const int cell = static_cast<int>(index(row, column));
        if (cell != passed && any_in_cell(first_[idx(cell)], test)) return true;
      }
    }
    return false;
  }

 private:
  struct Entry {
    GridNode node;
    int next;
  };
  template <class Test>
  bool any_in_cell(int first, const Test& test) const {
    for (int at = first; at != none; at = entries_[idx(at)].next) {
      if (test(entries_[idx(at)].node)) return true;
    }
    return false;
  }
  int column_of(float x) const {
    return static_cast<int>(std::clamp(x / cell_px_, 0.0F, static_cast<float>(columns_ - 1)));
  }
  int row_of(float y) const {
    return static_cast<int>(std::clamp(y / cell_px_, 0.0F, static_cast<float>(rows_ - 1)));
  }
  std::size_t index(int row, int column) const { return idx(row) * idx(columns_) + idx(column); }
  std::size_t cell_of(float x, float y) const { return index(row_of(y), column_of(x)); }

  float cell_px_;
  int columns_, rows_;
  std::vector<int> first_;  // of each cell, its last added node
  std::vector<Entry> entries_;
};

}  // namespace illustrate
