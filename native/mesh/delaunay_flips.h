// The Delaunay triangulation of a polygon, from any other of its triangulations.
//
// Lawson (1977), "Software for C1 surface interpolation", Mathematical Software III: a diagonal
// whose opposite angles sum up to more than 180 degrees is exchanged for the other one of its quad,
// until there is none. The least angle of all is then as large as it can be: fewer needles.
#pragma once

#include "core/types.h"

namespace illustrate {

// triangles: counter-clockwise, of the points' numbers, each side in two triangles at most. Sides
// with one stay. What is as good up to rounding stays as well.
void flip_to_delaunay(const ImagePoints& points, std::vector<Triangle>& triangles);

}  // namespace illustrate
