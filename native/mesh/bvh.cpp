#include "mesh/bvh.h"

#include <algorithm>
#include <cmath>

namespace illustrate {

// Descends into two nodes at once.
class Bvh::Pairs {
 public:
  Pairs(const Bvh& tree, const std::function<void(int, int)>& visit, double margin)
      : tree_(tree), visit_(visit), margin_(margin) {}

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
  void within(const BvhNode& node) {
    if (node.count == 0) {
      // The last one pushed comes first: left by itself, right by itself, then left with right.
      stack_.push_back({node.first, node.first + 1});
      stack_.push_back({node.first + 1, node.first + 1});
      stack_.push_back({node.first, node.first});
      return;
    }
    for (int i = node.first; i < node.first + node.count; ++i)
      for (int j = i + 1; j < node.first + node.count; ++j) test(i, j);
  }

  void between(int a, int b) {
    const BvhNode &first = tree_.nodes_[a], &second = tree_.nodes_[b];
    if (!are_near(first.box, second.box)) return;
    // Of two inner nodes the larger box is opened: its halves are likelier to lie apart from the
    // other.
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

  bool are_near(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) const {
    for (int k = 0; k < 3; ++k) {
      if (a.min()[k] - margin_ > b.max()[k] || b.min()[k] - margin_ > a.max()[k]) return false;
    }
    return true;
  }

  static bool is_larger(const BvhNode& a, const BvhNode& b) {
    return half_area(a.box) >= half_area(b.box);
  }

  void test(int i, int j) const {
    if (!are_near(tree_.boxes_[i], tree_.boxes_[j])) return;
    visit_(std::min(tree_.order_[i], tree_.order_[j]), std::max(tree_.order_[i], tree_.order_[j]));
  }

  const Bvh& tree_;
  const std::function<void(int, int)>& visit_;
  double margin_;
  std::vector<Edge> stack_;
};

template <class Meets>
void Bvh::visit_boxes(const Meets& meets, const std::function<void(int)>& visit) const {
  std::array<int, depth_limit> stack;
  std::size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const BvhNode& node = nodes_[idx(stack[--depth])];
    if (!meets(node.box)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first + 1;
      stack[depth++] = node.first;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (meets(boxes_[idx(i)])) visit(order_[idx(i)]);
    }
  }
}

void Bvh::met_by_plane(const Vec4& plane, const std::function<void(int)>& visit) const {
  const auto meets = [&](const Eigen::AlignedBox3d& box) {
    const double middle = plane.dot(box.center().homogeneous());
    return std::abs(middle) <= plane.head<3>().cwiseAbs().dot(box.sizes()) / 2;
  };
  visit_boxes(meets, visit);
}

void Bvh::near_point(const Vec3& p, double reach, const std::function<void(int)>& visit) const {
  const auto meets = [&](const Eigen::AlignedBox3d& box) {
    return ((box.min() - p).array() <= reach).all() && ((p - box.max()).array() <= reach).all();
  };
  visit_boxes(meets, visit);
}

void Bvh::overlapping_pairs(const std::function<void(int, int)>& visit, double margin) const {
  Pairs(*this, visit, margin).run();
}

}  // namespace illustrate
