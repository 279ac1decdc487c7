// Surfaces that are one surface in two frames.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// Whether vertices of one number are one, and faces have the same outlines. Triangles may differ:
// quads are split along their shorter diagonals, which change while a mesh deforms.
bool has_same_vertices(const Surface& a, const Surface& b);

}  // namespace illustrate
