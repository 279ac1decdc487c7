// Short streamlines that their neighbours can do without.
#pragma once

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// Streamlines shorter than 6 spacings go, the shortest first, where parallel ones that stay pass
// near enough to them and to half a spacing on both sides: within `reach` spacings of a streamline
// without length, down to 0.85 of one of 6. A wide gap that is short is left open: a short stroke
// in it would be seen more than the gap.
void thin_streamlines(StreamlineSet& set, const HatchView& view, double reach);

}  // namespace illustrate
