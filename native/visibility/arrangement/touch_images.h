// Images of curves that touch a contour: on its surface, also where their polylines are not.
#pragma once

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// Crossings that were dropped as touches of a contour and a curve that runs through it.
std::vector<int> dropped_crossings(const Arrangement& arrangement);

// Between the joint and a touch of two strands both polylines are the image of a fold and of a
// curve on its surface, which cannot stand out of it: where it does, its points are moved onto the
// contour, and then the contour's points that are still on the surface's side of it onto the curve.
// Only `image.image` changes. Points next to which another curve crosses stay, and so do nodes and
// what is more than a tenth of a pixel away.
void pull_touches_together(Arrangement& arrangement, const std::vector<int>& touches);

}  // namespace illustrate
