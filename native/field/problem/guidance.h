// What an artist may ask of the field beyond thresholds: the paper's future work.
#pragma once

#include "core/types.h"

namespace illustrate {

// A stroke for the field to follow: a polyline on the surface or near it.
struct Guide {
  Points points;       // (k) world
  double weight = 10;  // at each vertex that it passes, against 1 for an edge of a triangle
};

// The singularities that the field is to have.
struct PrescribedSingularities {
  Points positions;          // (k) world; the nearest point of the surface is meant
  std::vector<int> indices;  // (k) quarter turns

  bool empty() const { return positions.empty(); }
};

}  // namespace illustrate
