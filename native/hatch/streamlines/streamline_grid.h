// Nodes of streamlines, found by their place in the image.
#pragma once

#include <algorithm>
#include <cmath>

#include "hatch/streamlines/streamline.h"

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
  // box: where nodes are expected, of the whole frame if it is empty. What is beside it is found as
  // well, in more time.
  StreamlineGrid(double width_px, double height_px, double cell_px,
                 const Eigen::AlignedBox2d& box = {})
      : cell_px_(static_cast<float>(std::max(1e-3, cell_px))) {
    const Vec2 frame(width_px, height_px);
    Vec2 low = Vec2::Zero(), high = frame;
    if (!box.isEmpty()) {
      low = box.min().cwiseMin(frame).cwiseMax(low);
      high = box.max().cwiseMin(frame).cwiseMax(low);
    }
    first_column_ = std::floor(static_cast<float>(low.x()) / cell_px_);
    first_row_ = std::floor(static_cast<float>(low.y()) / cell_px_);
    columns_ = 1 + static_cast<int>(static_cast<float>(high.x()) / cell_px_ - first_column_);
    rows_ = 1 + static_cast<int>(static_cast<float>(high.y()) / cell_px_ - first_row_);
    first_.assign(idx(columns_) * idx(rows_), none);
    starts_.assign(first_.size() + 1, 0);
  }

  // Rounds to floats. An added node is found before those that were there.
  void add(const StreamlineNode& node, double half_px, int streamline, int index) {
    int& first = first_[cell_of(node.image)];
    nodes_.push_back(seen(node, static_cast<float>(half_px), streamline, index, first));
    first = static_cast<int>(nodes_.size()) - 1;
    widest_ = std::max(widest_, nodes_.back().half);
  }

  void add(const Streamline& streamline, int number) {
    for (std::size_t i = 0; i < streamline.nodes.size(); ++i) {
      add(streamline.nodes[i], streamline.spacing * node_step / 2, number, static_cast<int>(i));
    }
  }

  // These alone, found in the same order. But the nodes of a cell lie side by side in memory, and
  // the cells of a row: it takes less than to look for those that were added.
  void assign(const Streamlines& streamlines) {
    count(streamlines);
    const std::size_t size = idx(starts_.back());
    nodes_.resize(size), x_.resize(size + lanes), y_.resize(size + lanes);
    widest_ = 0;
    std::size_t at = 0;
    for (std::size_t s = 0; s < streamlines.size(); ++s) {
      const auto half = static_cast<float>(streamlines[s].spacing * node_step / 2);
      widest_ = std::max(widest_, half);
      const std::vector<StreamlineNode>& nodes = streamlines[s].nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i, ++at) {
        put(seen(nodes[i], half, static_cast<int>(s), static_cast<int>(i), none), cells_[at]);
      }
    }
  }

  std::size_t size() const { return nodes_.size(); }
  bool has_additions() const { return assigned() < static_cast<int>(nodes_.size()); }

  // Calls visit(node) for those in the cells that a box touches whose middle is not much farther
  // from p than `half`, along a unit heading and beside it. Nothing may have been added since they
  // were assigned.
  template <class Visit>
  void visit_strip(const Eigen::AlignedBox2d& box, const Vec2& p, const Vec2& heading,
                   const Vec2& half, const Visit& visit) const {
    const Eigen::Vector2f middle = p.cast<float>(), along = heading.cast<float>();
    const Eigen::Vector2f most = (1.001 * half + Vec2(0.01, 0.01)).cast<float>();
    const Eigen::Vector2f low = box.min().cast<float>(), high = box.max().cast<float>();
    const int column_from = column_of(low.x()), column_to = column_of(high.x());
    const auto excess = [&](const Lanes& x, const Lanes& y) -> Lanes {
      const Lanes dx = x - middle.x(), dy = y - middle.y();
      return ((dx * along.x() + dy * along.y()).abs() - most.x())
          .max((dy * along.x() - dx * along.y()).abs() - most.y());
    };
    const auto use = [&](const GridNode& node) {
      visit(node);
      return false;
    };
    for (int row = row_of(low.y()); row <= row_of(high.y()); ++row) {
      any_assigned(starts_[index(row, column_from)], starts_[index(row, column_to) + 1], excess,
                   use);
    }
  }
  float widest() const { return widest_; }  // the greatest half length

  // Takes the last nodes away again, until `size` are left; not those that were assigned.
  void shrink(std::size_t size) {
    for (; nodes_.size() > size; nodes_.pop_back()) {
      first_[cell_of(nodes_.back().image)] = nodes_.back().next;
    }
  }

  // Whether `test` accepts a node whose piece of line may pass p nearer than `radius`. It is asked
  // in the middle cell first, where what is near is most likely.
  template <class Test>
  bool any_near(const Vec2& p, double radius, const Test& test) const {
    const double reach = radius + double(widest_);
    const Eigen::Vector2f middle = p.cast<float>();
    const auto most = static_cast<float>((1.001 * reach + 0.01) * (1.001 * reach + 0.01));
    const auto excess = [&](const Lanes& x, const Lanes& y) -> Lanes {
      return (x - middle.x()).square() + (y - middle.y()).square() - most;
    };
    const auto any_from = [&](std::size_t cell, std::size_t end) {
      return any_assigned(starts_[cell], starts_[end], excess, test);
    };
    const std::size_t own = cell_of(p);
    if (any_added(own, test) || any_from(own, own + 1)) return true;
    const int column_from = column_of(static_cast<float>(p.x() - reach));
    const int column_to = column_of(static_cast<float>(p.x() + reach));
    const int row_to = row_of(static_cast<float>(p.y() + reach));
    for (int row = row_of(static_cast<float>(p.y() - reach)); row <= row_to; ++row) {
      const std::size_t from = index(row, column_from), end = index(row, column_to) + 1;
      const bool has_own = from <= own && own < end;
      if (any_from(from, has_own ? own : end) || (has_own && any_from(own + 1, end))) return true;
      for (std::size_t cell = from; cell < end; ++cell) {
        if (cell != own && any_added(cell, test)) return true;
      }
    }
    return false;
  }
  // Whether it accepts a node in the cells that a rectangle of half sides `reach` touches, cell by
  // cell in their order.
  template <class Test>
  bool any_in_box(const Vec2& p, const Vec2& reach, const Test& test) const {
    const int column_from = column_of(static_cast<float>(p.x() - reach.x()));
    const int column_to = column_of(static_cast<float>(p.x() + reach.x()));
    const int row_to = row_of(static_cast<float>(p.y() + reach.y()));
    for (int row = row_of(static_cast<float>(p.y() - reach.y())); row <= row_to; ++row) {
      for (int column = column_from; column <= column_to; ++column) {
        for (int at = first_[index(row, column)]; at != none; at = nodes_[idx(at)].next) {
          if (test(nodes_[idx(at)])) return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr int lanes = 4;
  using Lanes = Eigen::Array<float, lanes, 1>;

  int assigned() const { return starts_.back(); }

  static GridNode seen(const StreamlineNode& node, float half, int streamline, int index,
                       int next) {
    return {rounded(node.image),
            rounded(node.heading),
            half,
            static_cast<float>(node.depth),
            node.tangent.cast<float>(),
            streamline,
            index,
            next};
  }

  // Where cells start, and the cell of each node.
  void count(const Streamlines& streamlines) {
    cells_.clear();
    std::fill(starts_.begin(), starts_.end(), 0);
    for (const Streamline& streamline : streamlines) {
      for (const StreamlineNode& node : streamline.nodes) {
        cells_.push_back(cell_of(node.image));
        ++starts_[cells_.back() + 1];
      }
    }
    for (std::size_t cell = 0; cell < first_.size(); ++cell) starts_[cell + 1] += starts_[cell];
    std::fill(first_.begin(), first_.end(), none);
  }

  // Before all that is in its cell; the first one comes last.
  void put(const GridNode& node, std::size_t cell) {
    int& first = first_[cell];
    const int at = (first == none ? starts_[cell + 1] : first) - 1;
    nodes_[idx(at)] = node;
    nodes_[idx(at)].next = first;
    x_[idx(at)] = static_cast<float>(node.image.x());
    y_[idx(at)] = static_cast<float>(node.image.y());
    first = at;
  }

  // Of assigned nodes [from, to) with excess(x, y) <= 0.
  template <class Excess, class Test>
  bool any_assigned(int from, int to, const Excess& excess, const Test& test) const {
    for (int i = from; i < to; i += lanes) {
      const Lanes over = excess(Lanes::Map(&x_[idx(i)]), Lanes::Map(&y_[idx(i)]));
      for (int k = 0; k < std::min(lanes, to - i); ++k) {
        if (over[k] <= 0 && test(nodes_[idx(i + k)])) return true;
      }
    }
    return false;
  }
  // Of those in a cell that were added since.
  template <class Test>
  bool any_added(std::size_t cell, const Test& test) const {
    for (int at = first_[cell]; at >= assigned(); at = nodes_[idx(at)].next) {
      if (test(nodes_[idx(at)])) return true;
    }
    return false;
  }
  int column_of(float x) const {
    return static_cast<int>(
        std::clamp(x / cell_px_ - first_column_, 0.0F, static_cast<float>(columns_ - 1)));
  }
  int row_of(float y) const {
    return static_cast<int>(
        std::clamp(y / cell_px_ - first_row_, 0.0F, static_cast<float>(rows_ - 1)));
  }
  std::size_t index(int row, int column) const { return idx(row) * idx(columns_) + idx(column); }
  std::size_t cell_of(const Vec2& p) const {
    return index(row_of(static_cast<float>(p.y())), column_of(static_cast<float>(p.x())));
  }
  static Vec2 rounded(const Vec2& v) { return v.cast<float>().cast<double>(); }

  float cell_px_, first_column_, first_row_;
  int columns_, rows_;
  std::vector<int> first_;  // of each cell, its last added node
  std::vector<GridNode> nodes_;
  std::vector<int> starts_;         // of each cell, among the nodes that were assigned
  std::vector<float> x_, y_;        // of those, and some more
  std::vector<std::size_t> cells_;  // of those, one streamline after another
  float widest_ = 0;
};

}  // namespace illustrate
