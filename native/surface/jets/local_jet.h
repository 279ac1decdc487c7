// A polynomial fitted to the points round a vertex, in the frame of its normal.
#pragma once

#include "surface/jets/curvature.h"

namespace illustrate {

class LocalJet {
 public:
  // Takes these vertices of a surface, the one that the jet is about first.
  void take(const Surface& surface, const std::vector<int>& vertices);

  // Of degree 4, 3 or 2: the largest that the number of points allows, and at most `most_degree`.
  // Directions lie across the vertex's normal where that is exact, else in the tangent plane of the
  // polynomial. The farthest point weighs 1 - falloff, in [0, 1).
  PrincipalCurvature fit(int most_degree, bool exact_normal, double falloff = 0) const;

 private:
  Vec3 normal_, x_, y_;  // of the frame
  double radius_ = 1;    // of the points
  Points points_;        // in the frame, divided by the radius
};

// Takes every few of the vertices so that at most `most` are left, the first always.
void thin(std::vector<int>& vertices, std::size_t most);

}  // namespace illustrate
