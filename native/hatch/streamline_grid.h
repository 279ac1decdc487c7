// Nodes of streamlines, found by their place in the image.
#pragma once

#include <algorithm>
#include <cmath>

#include "hatch/streamline.h"

namespace illustrate {

// A node as neighbours see it: a piece of a line, half a step to both sides. One line of the
// processor's cache.
struct alignas(64) GridNode {
  Vec2 image;    // px
  Vec2 heading;  // unit
  float half;    // px, length to each side
  float depth;   // world
  Eigen::Vector3f tangent;
  int streamline;
  int index;
  int next;  // of the same cell, none: the last
};

class StreamlineGrid {
 public:
  StreamlineGrid(double width_px, double height_px, double cell_px)
      : cell_px_(static_cast<float>(std::max(1e-3, cell_px))),
        columns_(1 + static_cast<int>(width_px / cell_px)),
        rows_(1 + static_cast<int>(height_px / cell_px)),
        first_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none) {}

  // Rounds to floats.
  void add(const StreamlineNode& node, double half_px, int streamline, int index) {
    int& first = first_[cell_of(node.image)];
    nodes_.push_back({rounded(node.image), rounded(node.heading), static_cast<float>(half_px),
                      static_cast<float>(node.depth), node.tangent.cast<float>(), streamline, index,
                      first});
    first = static_cast<int>(nodes_.size()) - 1;
  }

  void add(const Streamline& streamline, int number) {
    for (std::size_t i = 0; i < streamline.nodes.size(); ++i) {
      add(streamline.nodes[i], streamline.spacing * node_step / 2, number, static_cast<int>(i));
    }
  }

  std::size_t size() const { return nodes_.size(); }

  void clear() {
    std::fill(first_.begin(), first_.end(), none);
    nodes_.clear();
    starts_.clear();
  }

  // Puts the nodes of a cell side by side in memory, in the order in which they are visited, and
  // the cells of a row.
  void gather() {
    if (!starts_.empty() && starts_.back() == static_cast<int>(nodes_.size())) return;
    std::vector<GridNode> gathered;
    gathered.reserve(nodes_.size());
    places_.clear(), starts_.clear(), widest_ = 0;
    for (int& first : first_) {
      starts_.push_back(static_cast<int>(gathered.size()));
      for (int at = first; at != none; at = nodes_[idx(at)].next) {
        gathered.push_back(nodes_[idx(at)]);
        gathered.back().next = static_cast<int>(gathered.size());
        places_.push_back(nodes_[idx(at)].image.cast<float>());
        widest_ = std::max(widest_, nodes_[idx(at)].half);
      }
      if (first == none) continue;
      first = starts_.back();
      gathered.back().next = none;
    }
    starts_.push_back(static_cast<int>(gathered.size()));
    nodes_.swap(gathered);
  }

  // Calls visit(node) for those in the cells that a box touches whose middle is not much farther
  // from p than `half`, along a unit heading and beside it. Everything must be gathered.
  template <class Visit>
  void visit_strip(const Eigen::AlignedBox2d& box, const Vec2& p, const Vec2& heading,
                   const Vec2& half, const Visit& visit) const {
    const Eigen::Vector2f middle = p.cast<float>(), along = heading.cast<float>();
    const Eigen::Vector2f most = (1.001 * half + Vec2(0.01, 0.01)).cast<float>();
    const Eigen::Vector2f low = box.min().cast<float>(), high = box.max().cast<float>();
    const int column_from = column_of(low.x()), column_to = column_of(high.x());
    for (int row = row_of(low.y()); row <= row_of(high.y()); ++row) {
      const int end = starts_[index(row, column_to) + 1];
      for (int i = starts_[index(row, column_from)]; i < end; ++i) {
        const Eigen::Vector2f offset = places_[idx(i)] - middle;
        if (std::abs(offset.x() * along.x() + offset.y() * along.y()) > most.x()) continue;
        if (std::abs(offset.y() * along.x() - offset.x() * along.y()) > most.y()) continue;
        visit(nodes_[idx(i)]);
      }
    }
  }
  float widest() const { return widest_; }  // the greatest half length that was gathered

  // Takes the last nodes away again, until `size` are left; not those that were gathered.
  void shrink(std::size_t size) {
    for (; nodes_.size() > size; nodes_.pop_back()) {
      first_[cell_of(nodes_.back().image)] = nodes_.back().next;
    }
  }

  // Whether `test` accepts a node in the cells that the square of half side `radius` touches. It is
  // asked in the middle cell first, where what is near is most likely.
  template <class Test>
  bool any_near(const Vec2& p, double radius, const Test& test) const {
    const auto middle = static_cast<int>(cell_of(p));
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
  template <class Test>
  bool any_in_cell(int first, const Test& test) const {
    for (int at = first; at != none; at = nodes_[idx(at)].next) {
      if (test(nodes_[idx(at)])) return true;
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
  std::size_t cell_of(const Vec2& p) const {
    return index(row_of(static_cast<float>(p.y())), column_of(static_cast<float>(p.x())));
  }
  static Vec2 rounded(const Vec2& v) { return v.cast<float>().cast<double>(); }

  float cell_px_;
  int columns_, rows_;
  std::vector<int> first_;  // of each cell, its last added node
  std::vector<GridNode> nodes_;
  std::vector<int> starts_;              // of each cell, once all are gathered; empty before
  std::vector<Eigen::Vector2f> places_;  // of those that were gathered
  float widest_ = 0;
};

}  // namespace illustrate
