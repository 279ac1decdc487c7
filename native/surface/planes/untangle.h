// A plane mesh that folds over itself, spread out by moving its vertices one at a time.
//
// L. Freitag, P. Plassmann, "Local optimization-based simplicial mesh untangling and improvement",
// International Journal for Numerical Methods in Engineering 49 (2000): a vertex goes to where the
// smallest of the areas round it is largest, a linear programme in the plane; so do those near it,
// again and again.
#pragma once

#include "core/types.h"

namespace illustrate {

// `triangles`: of points; each is to be counter-clockwise. A quad is given by the triangles at its
// four corners. fixed (points) 1: stays. Only points near triangles that are not are moved. Returns
// the number of triangles that are still clockwise, the least that was reached.
std::size_t untangle(const std::vector<Triangle>& triangles, const std::vector<std::uint8_t>& fixed,
                     std::vector<Vec2>& points);

// How many are clockwise.
std::size_t count_clockwise(const std::vector<Triangle>& triangles,
                            const std::vector<Vec2>& points);

}  // namespace illustrate
