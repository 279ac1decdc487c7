// Mean value interpolation in the plane: what a border says, carried on to where nothing is said.
//
// M. Floater, "Mean value coordinates", Computer Aided Geometric Design 20 (2003); K. Hormann and
// M. Floater, "Mean value coordinates for arbitrary planar polygons", ACM Transactions on Graphics
// 25 (4), 2006: defined everywhere, smooth off the border, exact for linear functions.
#pragma once

#include "core/types.h"

namespace illustrate {

// A straight piece of the border, which has the inside on its left, and the values at its ends,
// linear in between. Pieces that follow each other agree about their common end.
struct BorderPiece {
  Vec2 from, to;
  Vec2 value_from, value_to;
};

// border: closed polygons, in any order.
Vec2 mean_value(const std::vector<BorderPiece>& border, const Vec2& at);

}  // namespace illustrate
