// Where a curve runs through a contour: what the images of the two do at their joint.
#pragma once

#include <utility>
#include <vector>

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// The image of a curve on a contour's surface only touches the contour where it runs through it, on
// the side where the surface is. Where a polyline leaves the joint on the other side it crosses the
// contour once more nearby, to make up for it: that crossing is none. Or else it passes over the
// tip of a cusp, where two strands of the contour are closer than a polyline follows them, and does
// not cross the other one of them. If that is the near strand the curve should have passed behind
// it: it is taken to run through the near strand instead.

// Mends both. A crossing is dropped where it lies beyond other nodes, both ways to it within a
// pixel of the joint; `is_odd` tells where an odd number has been dropped before: [2 n] before
// node n on the curve that runs through the contour there, [2 n + 1] behind it. Returns the number
// of crossings dropped; `moved_px` grows to the farthest from its joint.
int drop_touches_past_nodes(Arrangement& arrangement, const std::vector<std::uint8_t>& is_odd,
                            double& moved_px);

// Pairs of nodes, the smaller one first, sorted: the two ends of a feature strand that stays within
// a pixel of its start, or of a contour's last strand that stays within Reaches::end.
std::vector<std::pair<int, int>> short_links(const Arrangement& arrangement);

}  // namespace illustrate
