// The cross that the rim of a flat face asks for, and the rectangle round it.
#pragma once

#include "surface/surface.h"

namespace illustrate {

struct RimEdge {
  Vec3 from, to;
};

// Sets what a plane face with a normal has of its rim. The direction is that of the cross which most
// of the rim's length runs along or across within a few degrees; of equals the one of the longest
// edge, the first of these.
void measure_rim(const std::vector<RimEdge>& edges, PlaneFace& plane);

}  // namespace illustrate
