#include "contour/dual_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/prefetch.h"
#include "core/radix_sort.h"

namespace illustrate {
namespace {

// A corner is projected to a face only where its component there is at least this, for a unit
// normal: margins then grow at most by its inverse. Neighbouring corners of a smooth surface have
// more than .5 on their best face.
constexpr double least_component = 0.25;

// Fewer items to a leaf visit fewer triangles, more save nodes.
constexpr int leaf_items = 4;

constexpr int octree_levels = 16;
constexpr int key_bits = 3 * octree_levels + 3;

// The face whose component is largest in the corner where it is smallest.
int best_face(const std::array<Vec4, 3>& corners) {
  int best = none;
  double most = least_component;
  for (int i = 0; i < 4; ++i) {
    const double a = corners[0][i], b = corners[1][i], c = corners[2][i];
    const double positive = std::min({a, b, c}), negative = -std::max({a, b, c});
    if (positive >= most || negative >= most) {
      best = 2 * i + (positive < negative);
      most = std::max(positive, negative);
    }
  }
  return best;
}

// The largest float below x, or one beside it; and the smallest above.
float below(double x) {
  const auto f = static_cast<float>(x);
  return f - std::abs(f) * 0x1p-23F;
}
float above(double x) {
  const auto f = static_cast<float>(x);
  return f + std::abs(f) * 0x1p-23F;
}

// Bits of n with two zeros between each and the next.
std::uint64_t spread(std::uint64_t n) {
  n = (n | n << 32) & 0x001f00000000ffff;
  n = (n | n << 16) & 0x001f0000ff0000ff;
  n = (n | n << 8) & 0x100f00f00f00f00f;
  n = (n | n << 4) & 0x10c30c30c30c30c3;
  return (n | n << 2) & 0x1249249249249249;
}

// Morton code of the box's centre in the octree over [-1, 1]^3, behind the face.
std::uint64_t key_of(const DualItem& item) {
  std::uint64_t key = static_cast<std::uint64_t>(item.face) << 3 * octree_levels;
  for (std::size_t j = 0; j < 3; ++j) {
    const float centre = (item.low[j] + item.high[j]) / 2;
    const float cell = (std::clamp(centre, -1.0F, 1.0F) + 1) * (1 << (octree_levels - 1));
    const auto most = (std::uint64_t{1} << octree_levels) - 1;
    key |= spread(std::min(static_cast<std::uint64_t>(cell), most)) << j;
  }
  return key;
}

struct Entry {
  std::uint64_t key;
  int item;
};

}  // namespace

std::optional<DualItem> dual_item(int id, const std::array<Vec4, 3>& corners) {
  const int face = best_face(corners);
  if (face == none) return std::nullopt;
  const int axis = face / 2;
  std::array<double, 3> scales;
  for (std::size_t k = 0; k < 3; ++k) scales[k] = 1 / std::abs(corners[k][axis]);
  DualItem item{id, face, {}, {}};
  for (int i = 0, j = 0; i < 4; ++i) {
    if (i == axis) continue;
    const double a = corners[0][i] * scales[0], b = corners[1][i] * scales[1],
                 c = corners[2][i] * scales[2];
    const double low = std::min({a, b, c}), high = std::max({a, b, c});
    if (!std::isfinite(a + b + c)) return std::nullopt;
    item.low[idx(j)] = below(low);
    item.high[idx(j)] = above(high);
    ++j;
  }
  return item;
}

class DualTree::Builder {
 public:
  Builder(const std::vector<DualItem>& items, int threads, DualTree& tree)
      : items_(items), threads_(threads), tree_(tree), entries_(items.size()) {}

  void run() {
    parallel_for(items_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        entries_[i] = {key_of(items_[i]), static_cast<int>(i)};
      }
    });
    radix_sort(entries_, key_bits, [](const Entry& e) { return e.key; });
    add_roots();
    fit_leaves();
    fit_parents();
    tree_.ids_.reserve(entries_.size());
    for (const Entry& e : entries_) tree_.ids_.push_back(items_[idx(e.item)].id);
  }

 private:
  void add_roots() {
    tree_.nodes_.reserve(entries_.size() / 2);
    std::size_t begin = 0;
    for (std::size_t face = 0; face < 8; ++face) {
      const std::size_t end = end_of(begin, entries_.size(), face, octree_levels);
      if (begin < end) add_node(begin, end, octree_levels);
      tree_.roots_[face + 1] = static_cast<int>(tree_.nodes_.size());
      begin = end;
    }
    tree_.nodes_.push_back({{}, {}, 0, static_cast<int>(entries_.size())});
  }

  std::uint64_t octant(std::size_t entry, int level) const {
    return entries_[entry].key >> 3 * level;
  }

  // Where the entries of one octant end.
  std::size_t end_of(std::size_t begin, std::size_t end, std::uint64_t code, int level) const {
    const auto inside = [&](const Entry& e) { return e.key >> 3 * level <= code; };
    const auto first = entries_.begin();
    return static_cast<std::size_t>(std::partition_point(first + static_cast<std::ptrdiff_t>(begin),
                                                         first + static_cast<std::ptrdiff_t>(end),
                                                         inside) -
                                    first);
  }

  // A node for the entries of one octant of `level` (0: the finest). Octants with a single child
  // are passed over.
  void add_node(std::size_t begin, std::size_t end, int level) {
    const std::size_t node = tree_.nodes_.size();
    tree_.nodes_.push_back({{}, {}, 0, static_cast<int>(begin)});
    if (end - begin > leaf_items) {
      while (level > 0 && octant(begin, level - 1) == octant(end - 1, level - 1)) --level;
      for (std::size_t b = begin, e = begin; level > 0 && b < end; b = e) {
        e = end_of(b, end, octant(b, level - 1), level - 1);
        add_node(b, e, level - 1);
      }
    }
    tree_.nodes_[node].next = static_cast<int>(tree_.nodes_.size());
  }

  template <class Box>
  static void grow(Node& node, const Box& box) {
    for (std::size_t j = 0; j < 3; ++j) {
      node.low[j] = std::min(node.low[j], box.low[j]);
      node.high[j] = std::max(node.high[j], box.high[j]);
    }
  }

  bool is_leaf(std::size_t node) const {
    return tree_.nodes_[node].next == static_cast<int>(node) + 1;
  }

  void fit_leaves() {
    std::vector<Node>& nodes = tree_.nodes_;
    parallel_for(nodes.size() - 1, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        if (!is_leaf(n)) continue;
        const DualItem& first = items_[idx(entries_[idx(nodes[n].first)].item)];
        nodes[n].low = first.low;
        nodes[n].high = first.high;
        for (int i = nodes[n].first + 1; i < nodes[n + 1].first; ++i) {
          grow(nodes[n], items_[idx(entries_[idx(i)].item)]);
        }
      }
    });
  }

  void fit_parents() {
    std::vector<Node>& nodes = tree_.nodes_;
    for (std::size_t n = nodes.size() - 1; n-- > 0;) {
      if (is_leaf(n)) continue;
      nodes[n].low = nodes[n + 1].low;
      nodes[n].high = nodes[n + 1].high;
      for (int child = nodes[n + 1].next; child < nodes[n].next; child = nodes[idx(child)].next) {
        grow(nodes[n], nodes[idx(child)]);
      }
    }
  }

  const std::vector<DualItem>& items_;
  int threads_;
  DualTree& tree_;
  std::vector<Entry> entries_;
};

DualTree::DualTree(const std::vector<DualItem>& items, std::vector<int> always, int threads)
    : always_(std::move(always)) {
  Builder(items, threads, *this).run();
}

void DualTree::find(const Vec4& viewpoint, double margin, std::vector<int>& found) const {
  found.insert(found.end(), always_.begin(), always_.end());
  if (ids_.empty()) return;
  const double reach = margin / least_component;
  for (int face = 0; face < 8; ++face) {
    const int axis = face / 2;
    const double offset = face % 2 ? -viewpoint[axis] : viewpoint[axis];
    const std::array<double, 3> slope{viewpoint[axis > 0 ? 0 : 1], viewpoint[axis > 1 ? 1 : 2],
                                      viewpoint[axis > 2 ? 2 : 3]};
    for (int n = roots_[idx(face)]; n < roots_[idx(face) + 1];) {
      const Node& node = nodes_[idx(n)];
      prefetch(&nodes_[idx(node.next)]);
      double least = offset, most = offset;
      for (std::size_t j = 0; j < 3; ++j) {
        const double a = slope[j] * node.low[j], b = slope[j] * node.high[j];
        least += std::min(a, b);
        most += std::max(a, b);
      }
      if (least > reach || most < -reach) {  // never where they are not numbers
        n = node.next;
        continue;
      }
      ++n;
      if (n == node.next) {
        for (int i = node.first; i < nodes_[idx(n)].first; ++i) found.push_back(ids_[idx(i)]);
      }
    }
  }
}

}  // namespace illustrate
