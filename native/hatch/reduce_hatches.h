// Stage `hatch`, reduction (paper section 6.5): one direction is left in single-hatch regions.
//
// Where there is room for one family only the one that stays was placed
// (field/families/families.h). Here hatches give way at the seams (reduction/seams.h): crease,
// boundary and self-intersection part sheets, a silhouette where what lies on its two sides is more
// than 3 * spacing apart in depth. What is left becomes strokes, less those that are too short
// (reduction/reduced_strokes.h). Undercut hatches stay as they are.
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
