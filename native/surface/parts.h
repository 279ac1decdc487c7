// The connected parts of a surface.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// What edges connect, also creases.
struct SurfaceParts {
  std::vector<int> of_triangle;   // (t)
  std::vector<double> diagonals;  // (parts) how large each is (core/spread.h)
  Points middles;                 // (parts) of area
  std::vector<double> areas;      // (parts)
};

SurfaceParts surface_parts(const Surface& surface);

}  // namespace illustrate
