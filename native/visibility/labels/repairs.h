// Crossings that only the interpolation of the contour has made: sub-pixel twists and lenses.
#pragma once

#include "visibility/arrangement/arrangement.h"

namespace illustrate {

// Drops twists (a path crosses itself, all between stays within a pixel, at most one cusp, or
// within two, no cusp, where nothing else unbalances a closed path; that must come nearer to
// balance) and lenses whose two crossings contradict each other: consecutive on both strands,
// everything between closer than 0.3 px, front and back exchanged. Returns the number of crossings
// dropped; `moved_px` grows to the farthest distance bridged.
int drop_twists_and_lenses(Arrangement& arrangement, double& moved_px);

// A curve that runs through a contour touches it there in the image, since its surface lies on one
// side of the contour only, near strand and far strand: drops crossings between a contour and such
// a curve where both run on, less than a pixel apart and without crossing again, into their
// joint, or near it past other nodes (joint_touches.h). So between a contour and the feature curve
// that it ends on, also past a node of that curve, or past a cusp of the contour no farther than
// Reaches::end from its end. Returns their number.
int drop_touches(Arrangement& arrangement, double& moved_px);

}  // namespace illustrate
