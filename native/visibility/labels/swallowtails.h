// Pairs of cusps that the interpolation has made, and cusps that are none.
#pragma once

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// Joins pairs of cusps that turn the same way with no more than a pixel of strand between them, on
// cycles whose changes do not sum to zero: swallowtails whose crossing the interpolation has lost;
// those that have it, within a pixel, stay. The smallest go first. Single cusps go where an open
// path ends, a tenth of a pixel from there. Returns the number of pairs and single ones; the cusps'
// jumps become 0.
int collapse_swallowtails(Arrangement& arrangement, double& moved_px);

}  // namespace illustrate
