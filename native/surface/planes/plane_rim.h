// The cross that the rim of a flat face asks for, and the rectangle round it.
#pragma once

#include "surface/surface.h"

namespace illustrate {

struct RimEdge {
  Vec3 from, to;
};

// Sets what a plane face with a normal has of its rim. The direction is that of the cross which
// most of the rim's length runs along or across within a few degrees; of equals the one of the
// longest edge, the first of these.
void measure_rim(const std::vector<RimEdge>& edges, PlaneFace& plane);

// Whether enough of the rim runs along or across its direction: a fifth, more than of a circle;
// where the face goes on smoothly half of it, since what is beyond speaks as well.
bool has_direction(const PlaneFace& plane);

// Whether its form is its own; else it is part of the form that it goes on into.
inline bool stands_alone(const PlaneFace& plane) {
  return plane.ends_sharply || has_direction(plane);
}

}  // namespace illustrate
