#include "hatch/streamlines/neighbours.h"

#include <algorithm>
#include <cmath>

namespace illustrate {
namespace {

// In spacings.
constexpr double near_reach = 1.25;    // most are found so near
constexpr double neighbour_reach = 2;  // of all

constexpr double band = 0.55;  // half a neighbour's piece of line, in node steps

std::array<Neighbour, 2> neighbours_within(const StreamlineSet& set, int number, int index,
                                           double far) {
  const Streamline& streamline = set.streamlines[idx(number)];
  const StreamlineNode& node = streamline.nodes[idx(index)];
  const Vec2 left = node.left();
  const double half_piece = std::min(streamline.spacing * node_step, double(set.grid.widest()));
  const double beside = 2 * band * half_piece;
  const Vec2 half = far * left.cwiseAbs() + beside * node.heading.cwiseAbs();
  const Eigen::AlignedBox2d box(node.image - half, node.image + half);
  std::array<Neighbour, 2> nearest;
  const Vec2 strip(beside, far + 2 * band * double(set.grid.widest()));
  set.grid.visit_strip(box, node.image, node.heading, strip, [&](const GridNode& other) {
    const Vec2 offset = other.image - node.image;
    const double along = offset.dot(node.heading);
    if (std::abs(along) > beside) return;
    if (other.streamline == number && std::abs(other.index - index) <= own_nodes) return;
    const double at = along / other.heading.dot(node.heading);  // along the neighbour
    if (!(std::abs(at) <= 2 * band * double(other.half))) return;
    const double across = offset.dot(left) - at * other.heading.dot(left);
    Neighbour& best = nearest[across < 0];
    if (std::abs(across) < std::min(best.distance, far) &&
        HatchView::is_alike(node, other, streamline.spacing)) {
      best = {std::abs(across), other.streamline};
    }
  });
  return nearest;
}

}  // namespace

std::array<Neighbour, 2> neighbours(const StreamlineSet& set, int number, int index) {
  const double spacing = set.streamlines[idx(number)].spacing;
  const auto near = neighbours_within(set, number, index, near_reach * spacing);
  if (near[0].streamline != none && near[1].streamline != none) return near;
  return neighbours_within(set, number, index, neighbour_reach * spacing);
}

double curve_beside(const HatchView& view, const StreamlineNode& node, const Vec2& side,
                    double reach) {
  const double share = view.curves.first_crossing(node.image, node.image + reach * side);
  return share <= 1 ? reach * share : std::numeric_limits<double>::infinity();
}

}  // namespace illustrate
