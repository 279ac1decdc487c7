#include <cmath>

#include "mesh/bvh.h"

namespace illustrate {
namespace {

// How far along the segment from a to b its point nearest to p is, in [0, 1].
double along_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 side = b - a;
  const double squared = side.squaredNorm();
  return squared > 0 ? std::min(1.0, std::max(0.0, side.dot(p - a) / squared)) : 0.0;
}

// Weights of the second and third corner of the point nearest to p of the three sides.
Vec2 nearest_on_sides(const std::array<Vec3, 3>& corners, const Vec3& p) {
  Vec2 best = Vec2::Zero();
  double least = -1;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = corners[idx(k)], &b = corners[idx(next_corner(k))];
    const double t = along_segment(a, b, p);
    const double squared = (a + t * (b - a) - p).squaredNorm();
    if (least >= 0 && squared >= least) continue;
    Vec3 weights = Vec3::Zero();
    weights[k] = 1 - t;
    weights[next_corner(k)] = t;
    least = squared;
    best = weights.tail<2>();
  }
  return best;
}

// Weights of the second and third corner of the point of a triangle nearest to p.
Vec2 nearest_in_triangle(const std::array<Vec3, 3>& corners, const Vec3& p) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0], d = p - corners[0];
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  // Rounding may leave a sliver none: then its sides alone are asked.
  if (determinant > 0) {
    const double b1 = (vv * u.dot(d) - uv * v.dot(d)) / determinant;
    const double b2 = (uu * v.dot(d) - uv * u.dot(d)) / determinant;
    if (b1 >= 0 && b2 >= 0 && b1 + b2 <= 1) return {b1, b2};
  }
  return nearest_on_sides(corners, p);
}

}  // namespace

SurfacePoint Bvh::nearest(const Vec3& p, double reach) const {
  SurfacePoint best;
  if (nodes_.empty() || !p.allFinite() || !(reach >= 0)) return best;
  double least = reach * reach;
  std::array<int, depth_limit> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  const auto squared_to = [&](int node) {
    return nodes_[idx(node)].box.squaredExteriorDistance(p);
  };
  while (depth > 0) {
    const int top = stack[--depth];
    const BvhNode& node = nodes_[idx(top)];
    // A box that is as near may hold a triangle of a lower number.
    if (!(squared_to(top) <= least)) continue;
    if (node.count == 0) {
      // The nearer child comes first: what it finds mostly rules out the other.
      const bool left_first = squared_to(node.first) <= squared_to(node.first + 1);
      stack[depth++] = node.first + (left_first ? 1 : 0);
      stack[depth++] = node.first + (left_first ? 0 : 1);
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int triangle = order_[idx(i)];
      const Triangle& t = (*triangles_)[idx(triangle)];
      const std::array<Vec3, 3> corners{(*positions_)[idx(t[0])], (*positions_)[idx(t[1])],
                                        (*positions_)[idx(t[2])]};
      const Vec2 b = nearest_in_triangle(corners, p);
      const Vec3 at = (1 - b.sum()) * corners[0] + b[0] * corners[1] + b[1] * corners[2];
      const double squared = (at - p).squaredNorm();
      const bool is_first = squared == least && (best.triangle == none || triangle < best.triangle);
      if (!(squared < least || is_first)) continue;
      least = squared;
      best = {triangle, b[0], b[1]};
    }
  }
  return best;
}

}  // namespace illustrate
