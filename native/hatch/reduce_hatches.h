// Stage `hatch`, reduction (paper section 6.5): one direction is left in single-hatch regions.
//
// Where there is room for one family only the one that stays was placed
// (field/families/families.h). Here hatches give way at the seams: no two points in single-hatch
// regions are perpendicular within a spacing on one sheet; the one nearer to an end of its hatch
// goes, so that hatches that run along a seam stay and those that end there are cut. Crease,
// boundary and self-intersection part sheets, a silhouette where what lies on its two sides is more
// than 3 * spacing apart in depth. A hatch that lies in shadows and undercuts altogether is of kind
// cross_hatch. Undercut hatches stay as they are. Strokes shorter than 1.5 * spacing with no longer
// parallel one near are dropped outside undercuts; below 3 those in shadows of the family that
// stays nowhere else there. What the frame before drew goes later (last_hatches.h), and at seams
// before what it did not.
//
// Departure from section 6.5, where all hatches are placed and in each view those are deleted that
// are perpendicular to others, breadth-first over parallel neighbours: patches of the other
// direction remain, framed in white, and not the same from view to view.
#pragma once

#include "hatch/greedy/place_hatches.h"

namespace illustrate {

Hatches reduce_hatches(const Hatches& hatches, const HatchScene& scene, const HatchOptions& options,
                       Counts& counts);

}  // namespace illustrate
