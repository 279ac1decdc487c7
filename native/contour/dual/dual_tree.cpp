#include "contour/dual/dual_tree.h"

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

// Of nodes and items: far more than fit in memory.
constexpr std::uint32_t largest_index = (1U << 30) - 1;

// Of the grid on which a face's boxes are rounded outward.
constexpr double most_steps = 65535;

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

// The face's steps that the box reaches, rounded outward.
std::array<std::uint16_t, 6> in_steps(const DualItem& item, const std::array<double, 3>& origin,
                                      const std::array<double, 3>& step) {
  std::array<std::uint16_t, 6> box{};
  for (std::size_t j = 0; j < 3; ++j) {
    if (!(step[j] > 0)) continue;
    const double low = std::floor((item.low[j] - origin[j]) / step[j]);
    const double high = std::ceil((item.high[j] - origin[j]) / step[j]);
    box[j] = static_cast<std::uint16_t>(std::clamp(low, 0., most_steps));
    box[j + 3] = static_cast<std::uint16_t>(std::clamp(high, 0., most_steps));
  }
  return box;
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
    tree_.ids_.reserve(entries_.size());
    for (const Entry& e : entries_) tree_.ids_.push_back(items_[idx(e.item)].id);
    add_faces();
    fit_leaves();
    fit_parents();
    for (const Leaf& leaf : leaves_) tree_.ids_[leaf.end - 1] = ~tree_.ids_[leaf.end - 1];
  }

 private:
  // The entries of a leaf.
  struct Leaf {
    std::size_t node, begin, end;
    std::size_t face;
  };

  void add_faces() {
    tree_.nodes_.reserve(entries_.size() / 2);
    std::size_t begin = 0;
    for (std::size_t face = 0; face < 8; ++face) {
      const std::size_t end = end_of(begin, entries_.size(), face, octree_levels);
      tree_.roots_[face] = none;
      if (begin < end) {
        set_grid(face, begin, end);
        tree_.roots_[face] = static_cast<int>(tree_.nodes_.size());
        tree_.nodes_.emplace_back();
        fill_node(idx(tree_.roots_[face]), begin, end, octree_levels, /*is_last=*/true);
      }
      begin = end;
    }
  }

  void set_grid(std::size_t face, std::size_t begin, std::size_t end) {
    Grid& grid = tree_.grids_[face];
    for (std::size_t j = 0; j < 3; ++j) {
      double low = items_[idx(entries_[begin].item)].low[j], high = low;
      for (std::size_t i = begin; i < end; ++i) {
        const DualItem& item = items_[idx(entries_[i].item)];
        low = std::min(low, double{item.low[j]});
        high = std::max(high, double{item.high[j]});
      }
      grid.origin[j] = low;
      grid.step[j] = (high - low) / most_steps;
    }
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

  // A node for the entries of one octant of `level` (0: the finest), with all below it. Octants
  // with a single child are passed over.
  void fill_node(std::size_t node, std::size_t begin, std::size_t end, int level, bool is_last) {
    const auto is_one = [&](int l) { return octant(begin, l) == octant(end - 1, l); };
    if (end - begin <= leaf_items) level = 0;
    while (level > 0 && is_one(level - 1)) --level;
    const bool is_leaf = level == 0;
    const std::size_t first = is_leaf ? begin : tree_.nodes_.size();
    tree_.nodes_[node].is_leaf = is_leaf;
    tree_.nodes_[node].is_last = is_last;
    tree_.nodes_[node].first = static_cast<std::uint32_t>(first) & largest_index;
    if (is_leaf) {
      leaves_.push_back({node, begin, end, entries_[begin].key >> 3 * octree_levels});
      return;
    }
    std::array<std::size_t, 9> ends{begin};
    std::size_t count = 0;
    while (ends[count] < end) {
      ends[count + 1] = end_of(ends[count], end, octant(ends[count], level - 1), level - 1);
      ++count;
    }
    tree_.nodes_.resize(first + count);
    for (std::size_t i = 0; i < count; ++i) {
      fill_node(first + i, ends[i], ends[i + 1], level - 1, i + 1 == count);
    }
  }

  using Box = std::array<std::uint16_t, 6>;
  static void grow(Box& box, const Box& other) {
    for (std::size_t j = 0; j < 3; ++j) {
      box[j] = std::min(box[j], other[j]);
      box[j + 3] = std::max(box[j + 3], other[j + 3]);
    }
  }

  void fit_leaves() {
    parallel_for(leaves_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t l = begin; l < end; ++l) {
        const Leaf& leaf = leaves_[l];
        const Grid& grid = tree_.grids_[leaf.face];
        Box& box = tree_.nodes_[leaf.node].box;
        box = in_steps(items_[idx(entries_[leaf.begin].item)], grid.origin, grid.step);
        for (std::size_t i = leaf.begin + 1; i < leaf.end; ++i) {
          grow(box, in_steps(items_[idx(entries_[i].item)], grid.origin, grid.step));
        }
      }
    });
  }

  void fit_parents() {
    for (std::size_t n = tree_.nodes_.size(); n-- > 0;) {
      Node& node = tree_.nodes_[n];
      if (node.is_leaf) continue;
      const Node* child = &tree_.nodes_[node.first];
      node.box = child->box;
      while (!child->is_last) grow(node.box, (++child)->box);
    }
  }

  const std::vector<DualItem>& items_;
  int threads_;
  DualTree& tree_;
  std::vector<Entry> entries_;
  std::vector<Leaf> leaves_;
};

DualTree::DualTree(const std::vector<DualItem>& items, std::vector<int> always, int threads)
    : always_(std::move(always)) {
  Builder(items, threads, *this).run();
}

// The plane viewpoint . x = 0 on one face, in its steps.
class DualTree::Plane {
 public:
  Plane(const Vec4& viewpoint, int face, const Grid& grid, double reach) : reach_(reach) {
    const int axis = face / 2;
    offset_ = face % 2 ? -viewpoint[axis] : viewpoint[axis];
    for (int i = 0, j = 0; i < 4; ++i) {
      if (i == axis) continue;
      const std::size_t k = idx(j++);
      offset_ += viewpoint[i] * grid.origin[k];
      slopes_[k] = viewpoint[i] * grid.step[k];
      least_[k] = slopes_[k] < 0 ? k + 3 : k;
      most_[k] = slopes_[k] < 0 ? k : k + 3;
    }
  }

  // Whether the box comes within reach of the plane; so it does where that is not a number.
  bool meets(const Node& node) const {
    return !(value(node, least_) > reach_ || value(node, most_) < -reach_);
  }

 private:
  double value(const Node& node, const std::array<std::size_t, 3>& corner) const {
    return offset_ + slopes_[0] * node.box[corner[0]] + slopes_[1] * node.box[corner[1]] +
           slopes_[2] * node.box[corner[2]];
  }

  double reach_;
  double offset_;
  std::array<double, 3> slopes_;
  std::array<std::size_t, 3> least_, most_;  // which sides of a box bound the values in it
};

// Level by level, so that what is looked at next was asked for long before.
void DualTree::find_leaves(int root, const Plane& plane, std::vector<int>& leaves) const {
  std::vector<int> families{root};
  for (std::size_t i = 0; i < families.size(); ++i) {
    for (const Node* node = &nodes_[idx(families[i])];; ++node) {
      if (plane.meets(*node)) {
        const auto first = static_cast<int>(node->first);
        (node->is_leaf ? leaves : families).push_back(first);
        node->is_leaf ? prefetch(&ids_[node->first]) : prefetch(&nodes_[node->first]);
      }
      if (node->is_last) break;
    }
  }
}

void DualTree::find(const Vec4& viewpoint, double margin, std::vector<int>& found) const {
  found.insert(found.end(), always_.begin(), always_.end());
  const double reach = margin / least_component;
  std::vector<int> leaves;
  for (int face = 0; face < 8; ++face) {
    const int root = roots_[idx(face)];
    if (root != none) {
      find_leaves(root, Plane(viewpoint, face, grids_[idx(face)], reach), leaves);
    }
  }
  for (const int leaf : leaves) {
    const int* id = &ids_[idx(leaf)];
    for (; *id >= 0; ++id) found.push_back(*id);
    found.push_back(~*id);
  }
}

}  // namespace illustrate
