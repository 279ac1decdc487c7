// A bounding volume hierarchy over triangles: rays, nearest points, and pairs of triangles whose
// boxes overlap.
#pragma once

#include <functional>

#include "core/progress.h"
#include "core/types.h"
#include "mesh/bvh_quads.h"

namespace illustrate {

struct RayHit {
  int triangle;
  double distance;  // in units of |direction|
};

class Bvh {
 public:
  Bvh() = default;
  // Keeps pointers to both arrays: they must outlive the tree. Triangles with a corner that is not
  // finite are left out. threads: 0 = all cores; the tree is the same for any number.
  // Throws Cancelled through `progress`.
  Bvh(const Points& positions, const std::vector<Triangle>& triangles, int threads = 0,
      const Progress& progress = {});

  // Adds all hits with low < distance < high, in no particular but always the same order. A ray
  // through a shared edge hits exactly one of its triangles (watertight, Woop et al. 2013), or both
  // or none where the surface folds there; one through a vertex hits as a ray beside it would. A
  // ray in a triangle's plane does not hit it. Nothing is hit by a direction that is zero, or by
  // anything not finite.
  void hits(const Vec3& origin, const Vec3& direction, double low, double high,
            std::vector<RayHit>& found) const;

  // Whether there is any such hit.
  bool is_hit(const Vec3& origin, const Vec3& direction, double low, double high) const;

  // The point of the triangles that is nearest to p, none where all are farther than `reach`. Of
  // triangles that are equally near, the first.
  SurfacePoint nearest(const Vec3& p, double reach) const;

  // Calls visit(a, b), a < b, for every pair of triangles whose boxes overlap, touch or are at most
  // `margin` apart along each axis; each pair once, in a fixed order.
  void overlapping_pairs(const std::function<void(int, int)>& visit, double margin = 0) const;

  // Calls visit(t) for every triangle whose box a plane passes through or touches, in a fixed
  // order. plane: zero for homogeneous points on it.
  void met_by_plane(const Vec4& plane, const std::function<void(int)>& visit) const;

  // Calls visit(t) for every triangle whose box is at most `reach` from p along each axis, in a
  // fixed order.
  void near_point(const Vec3& p, double reach, const std::function<void(int)>& visit) const;

  // Half of the area of a box's surface, 0 for an empty one.
  static double half_area(const Eigen::AlignedBox3d& box);

 private:
  class Builder;
  class Pairs;
  // Calls visit(RayHit) for the hits of a ray until it returns true; whether it did.
  template <class Visit>
  bool any_hit(const Vec3& origin, const Vec3& direction, double low, double high,
               const Visit& visit) const;
  // Calls visit(t) for every triangle whose box meets, as all boxes round it do.
  template <class Meets>
  void visit_boxes(const Meets& meets, const std::function<void(int)>& visit) const;
  static constexpr std::size_t depth_limit = 128;  // no path from the root is longer

  const Points* positions_ = nullptr;
  const std::vector<Triangle>* triangles_ = nullptr;
  std::vector<BvhNode> nodes_;              // root first
  std::vector<int> order_;                  // triangles, those of a leaf side by side
  std::vector<Eigen::AlignedBox3d> boxes_;  // of each entry of order_
  BvhQuads quads_;                          // of nodes_, for rays
};

}  // namespace illustrate
