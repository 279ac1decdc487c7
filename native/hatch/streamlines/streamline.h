// Hatches while they are placed and evened out in a view.
#pragma once

#include <algorithm>

#include "core/types.h"

namespace illustrate {

struct StreamlineNode {
  SurfacePoint on;
  Vec3 position;
  Vec3 tangent;  // unit: the branch of the cross along the streamline
  Vec2 image;
  Vec2 heading;        // unit: of `tangent` in the image
  double depth;        // world units along the viewing axis
  double pixel;        // world length of a pixel at that depth
  Vec2 depth_slope;    // of a flat face, world units of depth per px; zero elsewhere
  double closeness;    // 1 / depth in perspective, else 0
  Vec3 aside;          // tangent move of one pixel to the left of `heading`; zero at outlines
  double angle_ratio;  // angle in the tangent plane for a small angle in the image
  // Of the last drawing, where nothing has changed: it neither moves nor goes, and an end goes on
  // from there no farther.
  bool is_held = false;

  Vec2 left() const { return {-heading.y(), heading.x()}; }
  // The depth of the flat face's plane where it is seen at p; no finite one beyond its horizon.
  double plane_depth(const Vec2& p) const {
    const double rise = depth_slope.dot(p - image);
    return depth + rise / std::max(1 - closeness * rise, 0.0);
  }
};

struct Streamline {
  std::vector<StreamlineNode> nodes;
  int object = none;
  double spacing = 1;      // px
  bool is_joined = false;  // of others, since it was relaxed
  bool is_fixed = false;   // others mind it, but it stays as it is
};
using Streamlines = std::vector<Streamline>;

// Between nodes of an even streamline, in its spacings.
constexpr double node_step = 0.5;

// The same the other way.
inline void turn(StreamlineNode& node) {
  node.tangent = -node.tangent;
  node.heading = -node.heading;
  node.aside = -node.aside;
}
void turn(std::vector<StreamlineNode>& nodes);

double length_of(const std::vector<StreamlineNode>& nodes);  // px, of the image
bool any_is_held(const std::vector<StreamlineNode>& nodes);

}  // namespace illustrate
