// Streamlines end where they come too near to longer ones, or where none may run.
#pragma once

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// From short to long streamlines, nodes nearer than `test` spacings to a parallel one that is still
// there go, and those where hatches may not run; streamlines are cut at critical curves. Pieces of
// `least_length` spacings stay, fixed streamlines as they are.
void cut_streamlines(StreamlineSet& set, const HatchView& view, double test, double least_length);

}  // namespace illustrate
