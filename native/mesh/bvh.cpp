#include "mesh/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/predicates.h"

namespace illustrate {
namespace {

using Box = Eigen::AlignedBox3d;

constexpr int leaf_size = 4;
constexpr int bin_count = 12;

// Below this depth nodes are halved whatever their shape, so no path is longer than this plus 32.
constexpr int surface_area_depth = 60;
constexpr std::size_t stack_size = 128;

double half_area(const Box& box) {
  if (box.isEmpty()) return 0;
  const Vec3 s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

Box box_of(const Points& positions, const Triangle& triangle) {
  Box box(positions[triangle[0]]);
  box.extend(positions[triangle[1]]);
  return box.extend(positions[triangle[2]]);
}

struct Item {
  Box box;
  Vec3 centre;
  int triangle;
};

struct Bin {
  Box box;
  int count = 0;
};

// Where a range of items is cut: bins [0, bin] of the axis go left.
struct Cut {
  int axis = 0;
  int bin = none;  // none: there is no cut between bins
};

// Bins of equal width along one axis of the box of the centres.
struct Binning {
  double low, scale;

  Binning(const Box& centres, int axis)
      : low(centres.min()[axis]), scale(bin_count / (centres.max()[axis] - low)) {}

  // False where the centres do not differ enough to be told apart.
  bool is_usable() const { return std::isfinite(scale); }

  int bin(double centre) const {
    return std::clamp(static_cast<int>((centre - low) * scale), 0, bin_count - 1);
  }
};

// The cut of the least surface area heuristic, along the longest axis of the centres.
Cut best_cut(const Item* begin, const Item* end, const Box& centres) {
  Cut cut;
  centres.sizes().maxCoeff(&cut.axis);
  const Binning binning(centres, cut.axis);
  if (!binning.is_usable()) return cut;
  std::array<Bin, bin_count> bins;
  for (const Item* item = begin; item != end; ++item) {
    Bin& bin = bins[static_cast<std::size_t>(binning.bin(item->centre[cut.axis]))];
    bin.box.extend(item->box);
    ++bin.count;
  }
  std::array<double, bin_count> left_cost{};
  Bin sum;
  for (std::size_t i = 0; i + 1 < bin_count; ++i) {
    sum.box.extend(bins[i].box);
    sum.count += bins[i].count;
    left_cost[i] = half_area(sum.box) * sum.count;
  }
  double best = std::numeric_limits<double>::infinity();
  sum = {};
  for (std::size_t i = bin_count - 1; i > 0; --i) {
    sum.box.extend(bins[i].box);
    sum.count += bins[i].count;
    const double cost = left_cost[i - 1] + half_area(sum.box) * sum.count;
    if (sum.count == end - begin || sum.count == 0 || !(cost < best)) continue;
    best = cost;
    cut.bin = static_cast<int>(i) - 1;
  }
  return cut;
}

// Orders the items by the cut and returns where the right part begins; halves them where no cut is.
Item* divide(Item* begin, Item* end, const Box& centres, bool in_halves) {
  const Cut cut = in_halves ? Cut{} : best_cut(begin, end, centres);
  if (cut.bin == none) return begin + (end - begin) / 2;
  const Binning binning(centres, cut.axis);
  return std::partition(
      begin, end, [&](const Item& item) { return binning.bin(item.centre[cut.axis]) <= cut.bin; });
}

// A ray in the space of Woop et al. 2013: sheared so that it runs along +z from the origin.
class ShearedRay {
 public:
  ShearedRay(const Vec3& origin, const Vec3& direction) : origin_(origin) {
    direction.cwiseAbs().maxCoeff(&z_);
    x_ = next_corner(z_);
    y_ = next_corner(x_);
    shear_ = {direction[x_] / direction[z_], direction[y_] / direction[z_], 1 / direction[z_]};
  }

  // Whether the ray's line meets the triangle, and where along it.
  bool meets(const Vec3& p, const Vec3& q, const Vec3& r, double& distance) const {
    const Vec3 a = sheared(p), b = sheared(q), c = sheared(r);
    const int side = side_of_origin(b, c);
    if (side != side_of_origin(c, a) || side != side_of_origin(a, b)) return false;
    const double u = b.x() * c.y() - c.x() * b.y(), v = c.x() * a.y() - a.x() * c.y();
    const double w = a.x() * b.y() - b.x() * a.y(), sum = u + v + w;
    distance = (u / sum) * a.z() + (v / sum) * b.z() + (w / sum) * c.z();
    return std::isfinite(distance);
  }

 private:
  Vec3 sheared(const Vec3& p) const {
    const Vec3 d = p - origin_;
    return {d[x_] - shear_.x() * d[z_], d[y_] - shear_.y() * d[z_], shear_.z() * d[z_]};
  }

  // On which side of the line from a to b the ray is. Exact, so both triangles of an edge agree; a
  // ray on the line is moved by (s, s^2) for an infinitely small s.
  static int side_of_origin(const Vec3& a, const Vec3& b) {
    const int side = sign_of_difference(a.x(), b.y(), b.x(), a.y());
    if (side != 0) return side;
    if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
    return b.x() > a.x() ? 1 : -1;
  }

  Vec3 origin_, shear_;
  int x_, y_, z_ = 0;
};

// Whether a ray passes through boxes, with a margin for all rounding on the way.
class BoxTest {
 public:
  BoxTest(const Vec3& origin, const Vec3& direction, const Box& root)
      : origin_(origin), inverse_(direction.cwiseInverse()) {
    const double extent = std::max((root.min() - origin).cwiseAbs().maxCoeff(),
                                   (root.max() - origin).cwiseAbs().maxCoeff());
    margin_ = 16 * std::numeric_limits<double>::epsilon() * extent;
    const double largest = direction.cwiseAbs().maxCoeff();
    // A component this small moves the ray by less than the margin.
    for (int k = 0; k < 3; ++k) is_still_[k] = std::abs(direction[k]) < 1e-18 * largest;
  }

  bool passes(const Box& box, double low, double high) const {
    for (int k = 0; k < 3; ++k) {
      const double from = box.min()[k] - margin_ - origin_[k];
      const double to = box.max()[k] + margin_ - origin_[k];
      if (is_still_[k]) {
        if (from > 0 || to < 0) return false;
        continue;
      }
      const double enter = from * inverse_[k], leave = to * inverse_[k];
      low = std::max(low, std::min(enter, leave));
      high = std::min(high, std::max(enter, leave));
      if (low > high) return false;
    }
    return true;
  }

 private:
  Vec3 origin_, inverse_;
  double margin_ = 0;
  std::array<bool, 3> is_still_{};
};

}  // namespace

class Bvh::Builder {
 public:
  explicit Builder(Bvh& tree) : tree_(tree) {}

  void build() {
    gather();
    if (items_.empty()) return;
    tree_.nodes_.reserve(items_.size());
    tree_.nodes_.emplace_back();
    std::vector<Task> tasks{{0, 0, static_cast<int>(items_.size()), 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      build_node(task, tasks);
    }
    for (const Item& item : items_) {
      tree_.order_.push_back(item.triangle);
      tree_.boxes_.push_back(item.box);
    }
  }

 private:
  struct Task {
    int node, first, count, depth;
  };

  void gather() {
    const auto& triangles = *tree_.triangles_;
    items_.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Triangle& triangle = triangles[t];
      const auto is_finite = [&](int v) { return (*tree_.positions_)[v].allFinite(); };
      if (!std::all_of(triangle.begin(), triangle.end(), is_finite)) continue;
      const Box box = box_of(*tree_.positions_, triangle);
      items_.push_back({box, box.min() / 2 + box.max() / 2, static_cast<int>(t)});
    }
  }

  void build_node(const Task& task, std::vector<Task>& tasks) {
    Item* const begin = items_.data() + task.first;
    Item* const end = begin + task.count;
    Box box, centres;
    for (const Item* item = begin; item != end; ++item) {
      box.extend(item->box);
      centres.extend(item->centre);
    }
    Node& node = tree_.nodes_[task.node];
    node.box = box;
    if (task.count <= leaf_size) {
      node.first = task.first;
      node.count = task.count;
      return;
    }
    Item* const middle = divide(begin, end, centres, task.depth >= surface_area_depth);
    const int left = static_cast<int>(tree_.nodes_.size()), size = static_cast<int>(middle - begin);
    node.first = left;
    tree_.nodes_.resize(tree_.nodes_.size() + 2);
    tasks.push_back({left + 1, task.first + size, task.count - size, task.depth + 1});
    tasks.push_back({left, task.first, size, task.depth + 1});
  }

  Bvh& tree_;
  std::vector<Item> items_;
};

// Descends into two nodes at once.
class Bvh::Pairs {
 public:
  Pairs(const Bvh& tree, const std::function<void(int, int)>& visit, double margin)
      : tree_(tree), visit_(visit), margin_(Vec3::Constant(margin)) {}

  void run() {
    if (!tree_.nodes_.empty()) stack_.push_back({0, 0});
    while (!stack_.empty()) {
      const auto [a, b] = stack_.back();
      stack_.pop_back();
      if (a == b) {
        within(tree_.nodes_[a]);
      } else {
        between(a, b);
      }
    }
  }

 private:
  void within(const Node& node) {
    if (node.count == 0) {
      stack_.push_back({node.first, node.first + 1});
      stack_.push_back({node.first + 1, node.first + 1});
      stack_.push_back({node.first, node.first});
      return;
    }
    for (int i = node.first; i < node.first + node.count; ++i)
      for (int j = i + 1; j < node.first + node.count; ++j) test(i, j);
  }

  void between(int a, int b) {
    const Node &first = tree_.nodes_[a], &second = tree_.nodes_[b];
    if (!are_near(first.box, second.box)) return;
    if (first.count != 0 && second.count != 0) {
      for (int i = first.first; i < first.first + first.count; ++i)
        for (int j = second.first; j < second.first + second.count; ++j) test(i, j);
    } else if (second.count != 0 || (first.count == 0 && is_larger(first, second))) {
      stack_.push_back({first.first + 1, b});
      stack_.push_back({first.first, b});
    } else {
      stack_.push_back({a, second.first + 1});
      stack_.push_back({a, second.first});
    }
  }

  bool are_near(const Box& a, const Box& b) const {
    return Box(a.min() - margin_, a.max() + margin_).intersects(b);
  }

  static bool is_larger(const Node& a, const Node& b) {
    return half_area(a.box) >= half_area(b.box);
  }

  void test(int i, int j) const {
    if (!are_near(tree_.boxes_[i], tree_.boxes_[j])) return;
    visit_(std::min(tree_.order_[i], tree_.order_[j]), std::max(tree_.order_[i], tree_.order_[j]));
  }

  const Bvh& tree_;
  const std::function<void(int, int)>& visit_;
  Vec3 margin_;
  std::vector<Edge> stack_;
};

Bvh::Bvh(const Points& positions, const std::vector<Triangle>& triangles)
    : positions_(&positions), triangles_(&triangles) {
  Builder(*this).build();
}

void Bvh::hits(const Vec3& origin, const Vec3& direction, double low, double high,
               std::vector<RayHit>& found) const {
  if (nodes_.empty() || direction.isZero(0) || !direction.allFinite() || !origin.allFinite())
    return;
  const ShearedRay ray(origin, direction);
  const BoxTest test(origin, direction, nodes_.front().box);
  std::array<int, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (!test.passes(node.box, low, high)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first + 1;
      stack[depth++] = node.first;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = (*triangles_)[order_[i]];
      double distance = 0;
      if (ray.meets((*positions_)[t[0]], (*positions_)[t[1]], (*positions_)[t[2]], distance) &&
          distance > low && distance < high)
        found.push_back({order_[i], distance});
    }
  }
}

void Bvh::overlapping_pairs(const std::function<void(int, int)>& visit, double margin) const {
  Pairs(*this, visit, margin).run();
}

}  // namespace illustrate
