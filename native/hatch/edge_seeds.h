// Seeds in the narrow strips along critical curves.
#pragma once

#include "hatch/streamline_set.h"

namespace illustrate {

// Nodes near critical curves, from a lattice of the image: strips behind the edge of a fold may be
// so narrow that no seed of the surface lies in them. Only where streamlines of one family at most
// are near.
std::vector<StreamlineNode> edge_seeds(const StreamlineSet& set, const HatchView& view);

}  // namespace illustrate
