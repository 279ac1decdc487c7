// From kept points to strokes, less those that are too short to say anything.
#pragma once

#include "hatch/reduction/hatch_points.h"

namespace illustrate {

// The kept parts of all hatches, in their order. A stroke that lies in shadows and undercuts
// altogether is of kind cross_hatch; one of an undercut hatch stays so. Strokes shorter than 1.5
// spacings with no longer parallel one near are dropped outside undercuts; below 3 those in shadows
// of the family that stays nowhere else there. What the frame before drew goes later
// (last_hatches.h). `is_kept`: (points).
Hatches reduced_strokes(const HatchPoints& points, const std::vector<std::uint8_t>& is_kept,
                        const HatchScene& scene, double spacing_px);

}  // namespace illustrate
