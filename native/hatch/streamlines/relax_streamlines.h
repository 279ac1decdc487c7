// Streamlines move sideways until neighbours are evenly spaced, drifting a little off the field.
#pragma once

#include "core/progress.h"
#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// `sweeps` rounds; in each, every node is drawn to the middle between its neighbours, one spacing
// where it has only one, and whole streamlines answer as stiff lines that keep to the field (one
// tridiagonal system for each streamline). Outlines and other critical curves count as neighbours.
// The angle to the cross, in the tangent plane, stays small. Nodes that would move by less than
// `least_move` spacings stay where they are. The same for any number of threads. Throws
// Cancelled through `progress`.
void relax_streamlines(StreamlineSet& set, const HatchView& view, int sweeps, int threads,
                       const Progress& progress = {}, double least_move = 0);

// Those that were joined since they were relaxed bend where they are, so that no bridge shows:
// nodes are drawn to their own places. One stays as it is where it would come too near to another.
void straighten_joined(StreamlineSet& set, const HatchView& view, int sweeps, int threads);

}  // namespace illustrate
