// Where three sheets of surface meet in one point: each two of them cross in a curve, which passes
// through the third.
#pragma once

#include "contour/intersections.h"

namespace illustrate {

// A curve's segment that passes, at `fraction` of its way, through a triangle of the third sheet.
struct Passage {
  int curve;
  int segment;
  double fraction;
  int through;
};

struct TriplePoint {
  Vec3 position;
  std::vector<Passage> passages;  // three, or two where the third curve was not found
};

// All of them, in a fixed order.
std::vector<TriplePoint> triple_points(const Surface& surface,
                                       const IntersectionCurves& intersections);

}  // namespace illustrate
