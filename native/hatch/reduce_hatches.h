// Stage `hatch`, reduction (paper section 6.5): one direction is left in single-hatch regions.
//
// Breadth-first over parallel neighbours, so that single-hatch regions come out locally consistent.
// A hatch that is perpendicular to another within 2 * spacing inside a single-hatch region, no
// visible critical curve between, is clipped to the cross-hatch region: shadows and undercuts. What
// is left of it there is of kind cross_hatch, and so is a hatch that lies there altogether.
// Undercut hatches stay as they are.
//
// Departure from section 6.5: a hatch that is perpendicular to another somewhere is deleted
// everywhere, and where both directions went, each because of what it met elsewhere, nothing would
// be left. Pieces that cross nothing come back there.
#pragma once

#include "hatch/place_hatches.h"

namespace illustrate {

// `spacing_scale`: as for place_hatches.
Hatches reduce_hatches(const Hatches& hatches, const Surface& surface, const ToneMap& tone,
                       const LabelledGraph& graph, const HatchOptions& options, Counts& counts,
                       const std::vector<double>& spacing_scale = {});

}  // namespace illustrate
