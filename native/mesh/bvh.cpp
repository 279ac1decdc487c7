#include "mesh/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/predicates.h"

namespace illustrate {
namespace {

using Box = Eigen::AlignedBox3d;

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
    // The exact signs have decided whether it is met. u, v, w only say how far along: their
    // rounding loses no hit. A triangle seen along its plane has sum 0, and no distance.
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
  BoxTest(const Vec3& origin, const Vec3& direction, const Box& root) {
    const double extent = std::max((root.min() - origin).cwiseAbs().maxCoeff(),
                                   (root.max() - origin).cwiseAbs().maxCoeff());
    // A box let through in vain costs a few tests, one that is missed costs a hit: the roundings of
    // `passes` come to three or four epsilon.
    const double margin = 16 * std::numeric_limits<double>::epsilon() * extent;
    const double largest = direction.cwiseAbs().maxCoeff();
    // A component this small moves the ray by less than the margin; larger, it does so, too.
    const double least = 1e-18 * largest;
    for (int k = 0; k < 3; ++k) {
      const double along = std::abs(direction[k]) < least ? least : direction[k];
      inverse_[k] = 1 / along;
      is_negative_[k] = along < 0;
      near_origin_[k] = origin[k] + (is_negative_[k] ? -margin : margin);
      far_origin_[k] = origin[k] + (is_negative_[k] ? margin : -margin);
    }
  }

  bool passes(const Box& box, double low, double high) const {
    for (int k = 0; k < 3; ++k) {
      const double near = is_negative_[k] ? box.max()[k] : box.min()[k];
      const double far = is_negative_[k] ? box.min()[k] : box.max()[k];
      low = std::max(low, (near - near_origin_[k]) * inverse_[k]);
      high = std::min(high, (far - far_origin_[k]) * inverse_[k]);
    }
    return low <= high;
  }

 private:
  Vec3 near_origin_, far_origin_, inverse_;
  std::array<bool, 3> is_negative_{};
};

}  // namespace

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
  void within(const Node& node) {
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
    const Node &first = tree_.nodes_[a], &second = tree_.nodes_[b];
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

  bool are_near(const Box& a, const Box& b) const {
    for (int k = 0; k < 3; ++k) {
      if (a.min()[k] - margin_ > b.max()[k] || b.min()[k] - margin_ > a.max()[k]) return false;
    }
    return true;
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
  double margin_;
  std::vector<Edge> stack_;
};

template <class Visit>
bool Bvh::any_hit(const Vec3& origin, const Vec3& direction, double low, double high,
                  const Visit& visit) const {
  if (nodes_.empty() || direction.isZero(0) || !direction.allFinite() || !origin.allFinite())
    return false;
  const ShearedRay ray(origin, direction);
  const BoxTest test(origin, direction, nodes_.front().box);
  std::array<int, depth_limit> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (!test.passes(node.box, low, high)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first + 1;
      stack[depth++] = node.first;
    }
    // An inner node has count 0.
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (!test.passes(boxes_[idx(i)], low, high)) continue;
      const Triangle& t = (*triangles_)[order_[i]];
      double distance = 0;
      if (ray.meets((*positions_)[t[0]], (*positions_)[t[1]], (*positions_)[t[2]], distance) &&
          distance > low && distance < high && visit(RayHit{order_[i], distance}))
        return true;
    }
  }
  return false;
}

void Bvh::hits(const Vec3& origin, const Vec3& direction, double low, double high,
               std::vector<RayHit>& found) const {
  any_hit(origin, direction, low, high, [&](const RayHit& hit) {
    found.push_back(hit);
    return false;
  });
}

bool Bvh::is_hit(const Vec3& origin, const Vec3& direction, double low, double high) const {
  return any_hit(origin, direction, low, high, [](const RayHit&) { return true; });
}

void Bvh::met_by_plane(const Vec4& plane, const std::function<void(int)>& visit) const {
  const auto meets = [&](const Eigen::AlignedBox3d& box) {
    const double middle = plane.dot(box.center().homogeneous());
    return std::abs(middle) <= plane.head<3>().cwiseAbs().dot(box.sizes()) / 2;
  };
  std::vector<int> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const Node& node = nodes_[idx(stack.back())];
    stack.pop_back();
    if (!meets(node.box)) continue;
    if (node.count == 0) {
      stack.push_back(node.first + 1);
      stack.push_back(node.first);
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (meets(boxes_[idx(i)])) visit(order_[idx(i)]);
    }
  }
}

void Bvh::overlapping_pairs(const std::function<void(int, int)>& visit, double margin) const {
  Pairs(*this, visit, margin).run();
}

}  // namespace illustrate
