// What placing hatches asks of a view: nodes on the surface, where they may lie, what is near them.
#pragma once

#include <limits>

#include "hatch/greedy/place_hatches.h"
#include "hatch/streamlines/streamline_grid.h"
#include "hatch/view/critical_curves.h"
#include "hatch/view/hatch_area.h"
#include "hatch/view/walk.h"

namespace illustrate {

// Hatches that run along a critical curve stay away from it, in spacings.
constexpr double curve_clearance = 0.2;

class HatchView {
 public:
  // where: hatches run in these cells only, at the spacing of these.
  HatchView(const HatchScene& scene, const HatchOptions& hatch_options, Area where = Area::hatched)
      : area(scene),
        walker(scene.surface, scene.field, scene.camera),
        curves(scene.curves),
        options(hatch_options),
        scene_(scene),
        where_(where) {}

  // The node at a place, along the branch of the cross nearest to `towards`.
  StreamlineNode node(const SurfacePoint& on, const Vec3& towards) const;
  // The same in two steps: where it is, and how it runs there. `normal`: of the surface.
  StreamlineNode node_at(const SurfacePoint& on) const;
  void direct(StreamlineNode& node, const Vec3& normal, const Vec3& towards) const;
  // The node along the other direction of the cross.
  StreamlineNode across(StreamlineNode node, const Vec3& normal) const;

  // Whether a hatch may run through a node: before the near plane, in the frame, seen, where
  // hatches of its family are wanted, and not close along a critical curve.
  bool may_pass(const StreamlineNode& node, double spacing) const {
    return lies_well(node) && runs_well(node, spacing);
  }
  // The two halves of it: of the place, and of the direction there.
  bool lies_well(const StreamlineNode& node) const { return may_pass(point_of(node)); }
  bool runs_well(const StreamlineNode& node, double spacing) const {
    return area.suits(point_of(node), node.tangent) &&
           !curves.run_along(node.image, node.heading, curve_clearance * spacing);
  }
  bool may_pass(const HatchPoint& point) const { return area.may_pass(point, where_); }
  bool is_wanted(const HatchPoint& point) const { return area.is_wanted(point, where_); }
  // The triangle that is seen at an image point, `none` where it is not to be hatched.
  int triangle_at(const Vec2& image) const {
    const int triangle = area.wanted_triangle(image, where_);
    const bool is_wanted = triangle != none && is_hatched(scene_.surface.object_of(triangle));
    return is_wanted ? triangle : none;
  }
  const HatchScene& scene() const { return scene_; }
  const Camera& camera() const { return scene_.camera; }
  // The flat face that a node lies on (surface/planes/plane_faces.h), or none.
  int plane_of(const StreamlineNode& node) const {
    const std::vector<int>& planes = scene_.surface.triangle_planes;
    return planes.empty() ? none : planes[idx(node.on.triangle)];
  }
  bool is_hatched(int object) const { return scene_.is_hatched(object); }
  // Whether what the last drawing placed there is to stay.
  bool rests(const Vec2& image) const { return scene_.resting && scene_.resting->rests(image); }

  Kind kind() const { return where_ == Area::undercut ? Kind::undercut : Kind::hatch; }
  double spacing_px() const {
    return where_ == Area::undercut ? options.undercut_spacing_px : options.spacing_px;
  }
  double spacing_on(int triangle) const {  // px
    return scene_.spacing_on(triangle, spacing_px());
  }
  double scale_on(int triangle) const { return scene_.scale_on(triangle); }
  // box: where nodes are expected (streamline_grid.h).
  StreamlineGrid empty_grid(const Eigen::AlignedBox2d& box = {}) const {
    return {double(scene_.camera.width_px()), double(scene_.camera.height_px()), spacing_px(), box};
  }

  // Image distance from a node to a piece of a streamline, infinite where the two are not parallel,
  // far apart in depth, or farther than `reach`.
  static double distance(const StreamlineNode& node, const GridNode& other, double spacing,
                         double reach) {
    const Vec2 offset = node.image - other.image;
    const double along = std::abs(offset.dot(other.heading));
    const double beyond = std::max(along - double(other.half), 0.0);
    const double across = cross(offset, other.heading);
    const double square = beyond * beyond + across * across;
    if (!(square < reach * reach) || !is_alike(node, other, spacing)) {
      return std::numeric_limits<double>::infinity();
    }
    return std::sqrt(square);
  }

  // Whether two pieces of streamlines mind each other: parallel in space, and near in depth, or in
  // the plane of one flat face: next to its horizon a ground recedes by far more than its hatches
  // are apart. Bent surfaces turn too far from their tangent plane where they recede so much.
  static bool is_alike(const StreamlineNode& node, const GridNode& other, double spacing) {
    return are_parallel(node, other) &&
           (is_as_deep(node.depth, node, other, spacing) ||
            is_as_deep(node.plane_depth(other.image), node, other, spacing));
  }
  static bool are_parallel(const StreamlineNode& node, const GridNode& other) {
    const double cosine = node.tangent.dot(other.tangent.cast<double>());
    return 2 * cosine * cosine > 1;
  }
  // Whether a piece is near a depth for neighbours of a node.
  static bool is_as_deep(double depth, const StreamlineNode& node, const GridNode& other,
                         double spacing) {
    return std::abs(depth - double(other.depth)) < 3 * spacing * node.pixel;
  }

  // Whether a parallel streamline passes nearer than `radius`, no critical curve between; the same
  // streamline only where it comes round again.
  bool is_near(const StreamlineGrid& grid, const StreamlineNode& node, double spacing,
               double radius, int streamline, int index) const;

  // The distance to the nearest parallel streamline; `reach` where there is none nearer.
  double nearest(const StreamlineGrid& grid, const StreamlineNode& node, double spacing,
                 double reach) const;

  HatchArea area;
  Walker walker;
  const CriticalCurves& curves;
  const HatchOptions& options;

 private:
  static HatchPoint point_of(const StreamlineNode& node) {
    return {node.position, node.on, node.image};
  }
  // All that depends on the node's tangent.
  void show(StreamlineNode& node, const Vec3& normal) const;

  HatchScene scene_;
  Area where_;
};

}  // namespace illustrate
