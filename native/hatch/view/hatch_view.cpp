#include "hatch/view/hatch_view.h"

#include "field/cross_direction.h"

namespace illustrate {
namespace {

// A cross that is seen so edge-on, as a share of its area, cannot be moved sideways.
constexpr double least_facing = 1e-3;

// Nodes of one streamline are neighbours of its own only so many spacings apart.
constexpr double own_reach = 3;

}  // namespace

StreamlineNode HatchView::node(const SurfacePoint& on, const Vec3& towards) const {
  StreamlineNode node = node_at(on);
  direct(node, normal_at(scene_.surface, on), towards);
  return node;
}

StreamlineNode HatchView::node_at(const SurfacePoint& on) const {
  StreamlineNode node;
  node.on = on;
  node.position = position_at(scene_.surface, on);
  const Vec3 mapped = apply(walker.map(), node.position);
  node.image = mapped.head<2>() / mapped[2];
  node.depth = scene_.camera.depth(node.position);
  node.pixel = area.pixel_size(mapped);
  node.closeness = scene_.camera.is_perspective() ? 1 / node.depth : 0;
  return node;
}

void HatchView::direct(StreamlineNode& node, const Vec3& normal, const Vec3& towards) const {
  node.tangent = cross_direction(scene_.surface, scene_.field, node.on, normal, towards);
  show(node, normal);
}

StreamlineNode HatchView::across(StreamlineNode node, const Vec3& normal) const {
  node.tangent = normal.cross(node.tangent);
  show(node, normal);
  return node;
}

void HatchView::show(StreamlineNode& node, const Vec3& normal) const {
  const Vec3 aside = normal.cross(node.tangent);
  const double w = walker.map().row(2).head<3>().dot(node.position) + walker.map()(2, 3);
  const Vec2 a = image_direction(walker.map(), node.image, w, node.tangent);
  const Vec2 b = image_direction(walker.map(), node.image, w, aside);
  const double length = a.norm(), determinant = cross(a, b);
  node.heading = length > 0 ? Vec2(a / length) : Vec2(1, 0);
  node.aside = Vec3::Zero();
  node.depth_slope = Vec2::Zero();
  node.angle_ratio = 1 / least_facing;
  if (std::abs(determinant) > least_facing * length * b.norm() && length > 0) {
    const double by_aside = length / determinant;
    node.aside = by_aside * (aside - (b.dot(a) / (length * length)) * node.tangent);
    node.angle_ratio = length * length / std::abs(determinant);
    if (plane_of(node) != none) {
      const Vec3 away = -scene_.camera.view().row(2).head<3>();
      node.depth_slope =
          away.dot(node.tangent) / length * node.heading + away.dot(node.aside) * node.left();
    }
  }
}

bool HatchView::is_near(const StreamlineGrid& grid, const StreamlineNode& node, double spacing,
                        double radius, int streamline, int index) const {
  const int own = static_cast<int>(own_reach / node_step);
  return grid.any_near(node.image, radius, [&](const GridNode& other) {
    if (other.streamline == streamline && std::abs(other.index - index) <= own) return false;
    return distance(node, other, spacing, radius) < radius &&
           !curves.separate(node.image, other.image);
  });
}

double HatchView::nearest(const StreamlineGrid& grid, const StreamlineNode& node, double spacing,
                          double reach) const {
  double least = reach;
  grid.any_near(node.image, reach, [&](const GridNode& other) {
    const double found = distance(node, other, spacing, least);
    if (found < least && !curves.separate(node.image, other.image)) {
      least = found;
    }
    return false;
  });
  return least;
}

}  // namespace illustrate
