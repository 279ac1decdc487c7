// The last of placement: strokes that a hand would not make are not made.
#pragma once

#include "hatch/greedy/place_hatches.h"

namespace illustrate {

// A crumb is a hatch shorter than two of its spacings. Where it ends at the edge of its tone it is
// left to the tone beside it; between critical curves it is part of a whole, and stays. Stubs,
// crumbs along which longer hatches run within .9 spacings, fill no gap and go. Rungs, crumbs that
// end at a hatch across where there is one family, are left to that. Lone ticks go too: hatches,
// but undercuts, that are shorter than four spacings and have fewer than two others beside them;
// and specks: undercuts beside each other that together are shorter than twenty of their spacings,
// away from all other hatches. What the frame before drew stays down to half of that
// (last_hatches.h).
Hatches without_crumbs(const Hatches& hatches, const HatchScene& scene,
                       const HatchOptions& options);

// Hatches of which more than half lies in undercuts become of that kind.
void mark_undercuts(Hatches& hatches, const ToneMap& tone);

}  // namespace illustrate
