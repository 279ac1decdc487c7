#include "mesh/bvh_quads.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// A component this small, of the largest one, moves a ray by less than any rounding.
constexpr double least_component = 1e-18;

float room(float value) {
  return std::abs(value) * std::numeric_limits<float>::epsilon() +
         std::numeric_limits<float>::min();
}

float rounded_down(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest - room(nearest);
}

float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest + room(nearest);
}

double half_size(const Eigen::AlignedBox3d& box) {
  const double size = (box.max() / 2 - box.min() / 2).maxCoeff();
  return size > 0 ? size : 1;
}

// Descendants that together hold what an inner node holds; the largest are opened first.
std::vector<int> opened(const BvhNode& root, const std::vector<BvhNode>& nodes) {
  std::vector<int> parts{root.first, root.first + 1};
  const auto size = [&](int part) {
    const BvhNode& node = nodes[idx(part)];
    return node.count != 0 ? -1 : node.box.sizes().squaredNorm();
  };
  const auto is_smaller = [&](int a, int b) { return size(a) < size(b); };
  while (parts.size() < BvhQuad::size) {
    const auto largest = std::max_element(parts.begin(), parts.end(), is_smaller);
    const BvhNode& node = nodes[idx(*largest)];
    if (node.count != 0) break;
    *largest = node.first;
    parts.insert(largest + 1, node.first + 1);
  }
  return parts;
}

}  // namespace

BvhQuads::BvhQuads(const std::vector<BvhNode>& nodes,
                   const std::vector<Eigen::AlignedBox3d>& boxes) {
  if (nodes.empty()) return;
  const Eigen::AlignedBox3d& whole = nodes.front().box;
  middle_ = whole.min() / 2 + whole.max() / 2;
  scale_ = 1 / half_size(whole);
  quads_.reserve(nodes.size());
  struct Open {
    int quad, node;
  };
  std::vector<Open> open{{empty_quad(), 0}};
  while (!open.empty()) {
    const int quad = open.back().quad;
    const BvhNode& node = nodes[idx(open.back().node)];
    open.pop_back();
    for (int i = 0; i < node.count; ++i)
      put(quad, i, boxes[idx(node.first + i)], ~(node.first + i));
    if (node.count != 0) continue;
    int lane = 0;
    for (const int part : opened(node, nodes)) {
      open.push_back({empty_quad(), part});
      put(quad, lane++, nodes[idx(part)].box, open.back().quad);
    }
  }
}

int BvhQuads::empty_quad() {
  BvhQuad& quad = quads_.emplace_back();
  quad.low.fill(Lanes::Constant(infinite));
  quad.high.fill(Lanes::Constant(-infinite));
  return static_cast<int>(quads_.size()) - 1;
}

void BvhQuads::put(int quad, int lane, const Eigen::AlignedBox3d& box, int child) {
  BvhQuad& parent = quads_[idx(quad)];
  for (int k = 0; k < 3; ++k) {
    parent.low[idx(k)][lane] = rounded_down((box.min()[k] - middle_[k]) * scale_);
    parent.high[idx(k)][lane] = rounded_up((box.max()[k] - middle_[k]) * scale_);
  }
  parent.children[idx(lane)] = child;
}

QuadRay::QuadRay(const BvhQuads& quads, const Vec3& origin, const Vec3& direction, double low,
                 double high, double error) {
  const double largest = direction.cwiseAbs().maxCoeff();
  const Vec3 start = (origin + low * direction - quads.middle()) * quads.scale();
  const double off = error * quads.scale();
  for (int k = 0; k < 3; ++k) {
    const double share = direction[k] / largest;
    const double along = std::abs(share) < least_component ? least_component : share;
    const bool is_negative = along < 0;
    is_negative_[idx(k)] = is_negative;
    inverse_[idx(k)] = static_cast<float>(1 / along);
    const float before = rounded_down(start[k] - off), after = rounded_up(start[k] + off);
    near_origin_[idx(k)] = is_negative ? before : after;
    far_origin_[idx(k)] = is_negative ? after : before;
  }
  length_ = rounded_up((high - low) * largest * quads.scale());
}

}  // namespace illustrate
