// The connected parts of a surface.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// What edges connect, also creases.
struct SurfaceParts {
  std::vector<int> of_triangle;   // (t)
  std::vector<double> diagonals;  // (parts) of the box round each
};

SurfaceParts surface_parts(const Surface& surface);

}  // namespace illustrate
