// The section of the surface with a plane, followed over its triangles from a point on it.
#pragma once

#include "contour/zero_curves.h"

namespace illustrate {

struct SectionPlane {
  Vec3 point, normal;  // the normal of any length

  // Above 0 on the side that the normal points to, in proportion to the distance.
  double side(const Vec3& p) const { return normal.dot(p - point); }
};

// Follows the section from `start`, a point inside a triangle and in the plane, towards `goal` and
// up to it, also across creases and over the border between sheets, and adds a segment for every
// triangle that it passes. `start` becomes the point that was reached. False where the section ends
// before the goal: at a boundary, where it turns back from the goal (the horizon of a round form),
// or where rounding puts the start beside its triangle.
bool follow_section(const Surface& surface, const SectionPlane& section, const SectionPlane& goal,
                    ZeroPoint& start, std::vector<ZeroSegment>& way);

}  // namespace illustrate
