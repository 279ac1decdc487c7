// Stage `hatch`, reduction (paper section 6.5): one direction is left in single-hatch regions.
//
// The pieces of hatches in single-hatch regions fall into two families, one of which is kept
// (choose_family.h). No two kept pieces are perpendicular within 2 * spacing on one sheet: the one
// decided later is clipped. Crease, boundary and self-intersection part sheets, a silhouette where
// what lies on its two sides is more than 3 * spacing apart in depth. What is left of a deleted
// hatch in shadows and undercuts is of kind cross_hatch, and so is a hatch that lies there
// altogether. Undercut hatches stay as they are. Strokes shorter than 1.5 * spacing with no longer
// parallel one near are dropped outside undercuts.
//
// Departures from section 6.5. There a hatch is deleted that is perpendicular to another, breadth-
// first over parallel neighbours, and each time the queue is empty any hatch may start it again,
// also one of the family that its surroundings keep: patches of the other direction remain, framed
// in white. Here what is decided spreads over parallel and perpendicular neighbours alike, and the
// form decides between the families: strokes are to run round it, the way it bends more, and where
// it is flat along their greater length. Parts of deleted hatches come back where they cross
// nothing that is kept, the longest first.
#pragma once

#include "hatch/place_hatches.h"

namespace illustrate {

Hatches reduce_hatches(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options,
                       Counts& counts);

}  // namespace illustrate
