// Even streamlines as hatches.
#pragma once

#include "hatch/hatches.h"
#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// Smooth lines on the surface through the nodes of all streamlines, with points a fifth of a
// spacing apart. Streamlines that are longer than max_length_px, or turn more than max_turn_deg in
// the world from their middle, become several. What may not lie where it does is cut out. They are
// of the view's kind; fixed streamlines are left out.
Hatches finished(const Streamlines& streamlines, const HatchView& view);

}  // namespace illustrate
