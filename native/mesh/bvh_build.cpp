#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "mesh/bvh.h"

namespace illustrate {
namespace {

using Box = Eigen::AlignedBox3d;

constexpr int leaf_size = BvhQuad::size;
constexpr int bin_count = 12;

// Below this depth nodes are halved whatever their shape, so no path is longer than this plus 32.
constexpr int surface_area_depth = 60;

Box box_of(const Points& positions, const Triangle& triangle) {
  Box box(positions[triangle[0]]);
  box.extend(positions[triangle[1]]);
  return box.extend(positions[triangle[2]]);
}

// A triangle's box. Left as it is until it is set, so that memory is first touched in parallel.
struct Item {
  Vec3 low, high;
  int triangle;

  Item() {}
  Box box() const { return {low, high}; }
  Vec3 centre() const { return low / 2 + high / 2; }
  double centre(int axis) const { return low[axis] / 2 + high[axis] / 2; }
};

// Of items: all of them, and their centres.
struct Extent {
  Box box, centres;

  void add(const Item& item) {
    box.extend(item.box());
    centres.extend(item.centre());
  }
  void add(const Extent& other) {
    box.extend(other.box);
    centres.extend(other.centres);
  }
};

Extent extent_of(const Item* begin, const Item* end) {
  Extent extent;
  for (const Item* item = begin; item != end; ++item) extent.add(*item);
  return extent;
}

struct Bin {
  Extent extent;
  int count = 0;
};
using Bins = std::array<Bin, bin_count>;

// Bins of equal width along the longest axis of the box of the centres.
struct Binning {
  int axis = 0;
  double low, scale;

  explicit Binning(const Box& centres) {
    centres.sizes().maxCoeff(&axis);
    low = centres.min()[axis];
    scale = bin_count / (centres.max()[axis] - low);
  }

  // False where the centres do not differ enough to be told apart.
  bool is_usable() const { return std::isfinite(scale); }

  int bin(const Item& item) const {
    return std::clamp(static_cast<int>((item.centre(axis) - low) * scale), 0, bin_count - 1);
  }
};

Bins fill_bins(const Item* begin, const Item* end, const Binning& binning) {
  Bins bins;
  for (const Item* item = begin; item != end; ++item) {
    Bin& bin = bins[idx(binning.bin(*item))];
    bin.extent.add(*item);
    ++bin.count;
  }
  return bins;
}

// The last bin of the left part, by the least surface area heuristic. None: there is no cut between
// bins.
int best_cut(const Bins& bins, int count) {
  std::array<double, bin_count> left_cost{};
  Box box;
  int sum = 0;
  for (std::size_t i = 0; i + 1 < bin_count; ++i) {
    sum += bins[i].count;
    left_cost[i] = bins[i].count == 0 && i > 0
                       ? left_cost[i - 1]
                       : Bvh::half_area(box.extend(bins[i].extent.box)) * sum;
  }
  double best = std::numeric_limits<double>::infinity();
  int cut = none;
  box.setEmpty();
  sum = 0;
  for (std::size_t i = bin_count - 1; i > 0; --i) {
    // Before an empty bin the cut is the same as after it.
    if (bins[i].count == 0) continue;
    sum += bins[i].count;
    const double cost = left_cost[i - 1] + Bvh::half_area(box.extend(bins[i].extent.box)) * sum;
    // All on one side is no cut. Of equal costs the rightmost stays; what is not a number never
    // wins.
    if (sum == count || !(cost < best)) continue;
    best = cost;
    cut = static_cast<int>(i) - 1;
  }
  return cut;
}

// The two parts of a range of items.
struct Halves {
  int left_count;
  Extent left, right;
};

Halves in_the_middle(const Item* begin, const Item* end) {
  const Item* const middle = begin + (end - begin) / 2;
  return {static_cast<int>(middle - begin), extent_of(begin, middle), extent_of(middle, end)};
}

// Orders the items by the best cut, or only halves them where no cut is.
Halves divide(Item* begin, Item* end, const Extent& extent, bool only_halve) {
  const Binning binning(extent.centres);
  if (only_halve || !binning.is_usable()) return in_the_middle(begin, end);
  const Bins bins = fill_bins(begin, end, binning);
  const int cut = best_cut(bins, static_cast<int>(end - begin));
  if (cut == none) return in_the_middle(begin, end);
  Halves halves{0, {}, {}};
  for (int i = 0; i < bin_count; ++i) {
    const Bin& bin = bins[idx(i)];
    if (bin.count == 0) continue;
    (i <= cut ? halves.left : halves.right).add(bin.extent);
    halves.left_count += i <= cut ? bin.count : 0;
  }
  std::partition(begin, end, [&](const Item& item) { return binning.bin(item) <= cut; });
  return halves;
}

}  // namespace

double Bvh::half_area(const Box& box) {
  if (box.isEmpty()) return 0;
  const Vec3 s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

// The upper part of the tree is made first, down to branches whose size does not depend on the
// number of threads; these are made in parallel, each with nodes of its own.
class Bvh::Builder {
 public:
  Builder(Bvh& tree, int threads, const Progress& progress)
      : tree_(tree), threads_(threads), progress_(progress) {}

  void build() {
    gather();
    if (items_.empty()) return;
    progress_.report(0.3);
    const int count = static_cast<int>(items_.size());
    // One thread needs no branches. Its nodes stand in another order, which shows nowhere: a tree
    // is walked by its links.
    const int grain = threads_ == 1 ? 0 : std::max(smallest_branch, count / branch_count);
    const Extent whole = extent_of(items_.data(), items_.data() + count);
    Nodes& nodes = tree_.nodes_;
    nodes.reserve(items_.size());
    std::vector<Branch> branches = divide_down_to(grain, {0, 0, count, 0, whole}, nodes);
    progress_.report(0.5);
    build_branches(branches);
    progress_.report(0.8);
    append(branches, nodes);
    copy_items();
    tree_.quads_ = BvhQuads(nodes, tree_.boxes_);
  }

 private:
  using Nodes = std::vector<BvhNode>;
  struct Task {
    int node, first, count, depth;
    Extent extent;  // of the items
  };
  struct Branch {
    Task task;  // its root's place in the upper part
    Nodes nodes;
  };
  // Many more branches than cores, so that none waits long for the last one; none so small that
  // handing it out costs more than building it.
  static constexpr int branch_count = 64, smallest_branch = 4096;

  void gather() {
    const auto& triangles = *tree_.triangles_;
    items_.resize(triangles.size());
    parallel_for(triangles.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) set_item(t, triangles[t]);
    });
    const auto is_left_out = [](const Item& item) { return item.triangle == none; };
    items_.erase(std::remove_if(items_.begin(), items_.end(), is_left_out), items_.end());
  }

  void set_item(std::size_t t, const Triangle& triangle) {
    const auto is_finite = [&](int v) { return (*tree_.positions_)[v].allFinite(); };
    const bool finite = std::all_of(triangle.begin(), triangle.end(), is_finite);
    const Box box = box_of(*tree_.positions_, triangle);
    items_[t].low = box.min();
    items_[t].high = box.max();
    items_[t].triangle = finite ? static_cast<int>(t) : none;
  }

  // Makes the nodes of a root (at the end of `nodes`) down to branches of no more than `grain`
  // items, which are returned in the order of their items; with 0 all nodes.
  std::vector<Branch> divide_down_to(int grain, const Task& root, Nodes& nodes) {
    std::vector<Branch> branches;
    nodes.emplace_back();
    std::vector<Task> tasks{root};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      if (grain > 0 && task.count <= grain) {
        branches.push_back({task, {}});
      } else {
        build_node(task, nodes, tasks);
      }
    }
    return branches;
  }

  void build_branches(std::vector<Branch>& branches) {
    parallel_for(items_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (Branch& branch : branches) {
        const auto first = idx(branch.task.first);
        if (first < begin || first >= end) continue;
        branch.nodes.reserve(idx(branch.task.count));
        const Task& task = branch.task;
        divide_down_to(0, {0, task.first, task.count, task.depth, task.extent}, branch.nodes);
      }
    });
  }

  // The root of a branch takes its place in the upper part, its other nodes follow at the end.
  static void append(std::vector<Branch>& branches, Nodes& nodes) {
    for (Branch& branch : branches) {
      const int offset = static_cast<int>(nodes.size()) - 1;
      for (BvhNode& node : branch.nodes) node.first += node.count == 0 ? offset : 0;
      nodes[branch.task.node] = branch.nodes.front();
      nodes.insert(nodes.end(), branch.nodes.begin() + 1, branch.nodes.end());
      branch.nodes = {};
    }
  }

  void build_node(const Task& task, Nodes& nodes, std::vector<Task>& tasks) {
    BvhNode& node = nodes[task.node];
    node.box = task.extent.box;
    if (task.count <= leaf_size) {
      node.first = task.first;
      node.count = task.count;
      return;
    }
    Item* const begin = items_.data() + task.first;
    const Halves halves =
        divide(begin, begin + task.count, task.extent, task.depth >= surface_area_depth);
    const int left = static_cast<int>(nodes.size()), size = halves.left_count;
    node.first = left;
    nodes.resize(nodes.size() + 2);
    tasks.push_back({left + 1, task.first + size, task.count - size, task.depth + 1, halves.right});
    tasks.push_back({left, task.first, size, task.depth + 1, halves.left});
  }

  void copy_items() {
    tree_.order_.resize(items_.size());
    tree_.boxes_.resize(items_.size());
    parallel_for(items_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        tree_.order_[i] = items_[i].triangle;
        tree_.boxes_[i] = items_[i].box();
      }
    });
  }

  Bvh& tree_;
  int threads_;
  const Progress& progress_;
  std::vector<Item> items_;
};

Bvh::Bvh(const Points& positions, const std::vector<Triangle>& triangles, int threads,
         const Progress& progress)
    : positions_(&positions), triangles_(&triangles) {
  Builder(*this, threads, progress).build();
}

}  // namespace illustrate
