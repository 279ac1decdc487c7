// Corners of a refined level from those of the level before, in closed form.
#pragma once

#include "surface/subdivision/refined_mesh.h"

namespace illustrate {

// Numbers as OpenSubdiv's: Catmull-Clark makes of each corner a quad, which is its corner k where
// the parent is a quad and the corner is its k-th, else its corner 0; Loop makes of each triangle
// one at each corner, then the one in the middle, whose corner 0 is the middle of edge 1. Fills
// corners_per_face, mates and corner_kinds of `child` from those of `parent`. threads: 0 = all.
void divide_corners(const RefinedMesh& parent, int threads, RefinedMesh& child);

// The corner of the next level at the vertex that this corner's has become.
int child_corner(const RefinedMesh& parent, int corner);

}  // namespace illustrate
