// Seeds in the narrow strips along critical curves.
#pragma once

#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// What is seen near critical curves, under a lattice of the image: strips behind the edge of a fold
// may be so narrow that no seed of the surface lies in them.
std::vector<SurfacePoint> edge_places(const HatchView& view);

// Nodes at those of the places where streamlines of one family at most are near.
std::vector<StreamlineNode> edge_seeds(const StreamlineSet& set, const HatchView& view,
                                       const std::vector<SurfacePoint>& places);

}  // namespace illustrate
