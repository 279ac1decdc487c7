#include <algorithm>
#include <cmath>
#include <limits>

#include "core/predicates.h"
#include "mesh/bvh.h"

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

// Narrows low .. high to what of a ray is in a box; whether anything is. Lets boxes through that a
// ray misses by less than `margin`, which all rounding on the way does not exceed.
bool clip_to_box(const Box& box, const Vec3& origin, const Vec3& direction, double margin,
                 double& low, double& high) {
  const double largest = direction.cwiseAbs().maxCoeff();
  // A component this small moves the ray by less than the margin; larger, it does so, too.
  const double least = 1e-18 * largest;
  for (int k = 0; k < 3; ++k) {
    const double along = std::abs(direction[k]) < least ? least : direction[k];
    const double near = along < 0 ? box.max()[k] + margin : box.min()[k] - margin;
    const double far = along < 0 ? box.min()[k] - margin : box.max()[k] + margin;
    low = std::max(low, (near - origin[k]) / along);
    high = std::min(high, (far - origin[k]) / along);
  }
  return low <= high;
}

// The roundings of clip_to_box and of places on a ray come to a few epsilon.
double margin_of(const Box& box, const Vec3& origin) {
  const auto farthest = [](const Vec3& a, const Vec3& b) {
    return std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  };
  const double extent =
      farthest(box.min() - origin, box.max() - origin) + farthest(box.min(), box.max());
  return 16 * std::numeric_limits<double>::epsilon() * extent;
}

}  // namespace

template <class Visit>
bool Bvh::any_hit(const Vec3& origin, const Vec3& direction, double low, double high,
                  const Visit& visit) const {
  if (nodes_.empty() || direction.isZero(0) || !direction.allFinite() || !origin.allFinite())
    return false;
  const Box& whole = nodes_.front().box;
  const double margin = margin_of(whole, origin);
  double enter = low, leave = high;
  if (!clip_to_box(whole, origin, direction, margin, enter, leave)) return false;
  const ShearedRay ray(origin, direction);
  const QuadRay inside(quads_, origin, direction, enter, high, margin);
  std::array<int, (BvhQuad::size - 1) * depth_limit + 1> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const int next = stack[--depth];
    if (next >= 0) {
      inside.each_passed(quads_[next], [&](int child) { stack[depth++] = child; });
      continue;
    }
    const int triangle = order_[idx(~next)];
    const Triangle& t = (*triangles_)[idx(triangle)];
    double distance = 0;
    if (ray.meets((*positions_)[t[0]], (*positions_)[t[1]], (*positions_)[t[2]], distance) &&
        distance > low && distance < high && visit(RayHit{triangle, distance}))
      return true;
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

}  // namespace illustrate
