// Undercuts are dark: hatches between those that run through them.
#pragma once

#include "core/progress.h"
#include "hatch/streamline_set.h"
#include "hatch/surface_curves.h"

namespace illustrate {

// Adds hatches of kind undercut to `hatches`, in undercuts only, evened out between the streamlines
// of `set`, which they were made of: about undercut_spacing_px from each other and from these, of
// both families. As elsewhere they are long and even; the shortest are `least` of the source.
// `set` ends with them, its own streamlines as they were.
void add_undercuts(Hatches& hatches, StreamlineSet& set, const HatchScene& scene,
                   const CurvesOfObjects& curves, const HatchOptions& options, int threads,
                   const Progress& progress);

}  // namespace illustrate
