// How much of the drawing hangs on a crossing or a cusp: what would be drawn otherwise without it.
#pragma once

#include "visibility/labels/path_arcs.h"

namespace illustrate {

// Pixels of line; infinite where nothing bounds it.
struct Extents {
  // (crossings) along either of its two paths to their nearest other crossing (a lens), or from a
  // crossing of a path with itself round to itself (a loop).
  std::vector<double> crossings;
  // (paths)(steps) from the cusp between one strand of a path and the one before to the path's next
  // cusp, or to where the path goes under cover; infinite where there is none.
  std::vector<std::vector<double>> cusps;
};

Extents extents(const Arrangement& arrangement, const std::vector<std::vector<PathArc>>& arcs);

}  // namespace illustrate
