// Polygons that come to a vertex twice are taken apart into polygons that do not.
#pragma once

#include "core/ragged.h"
#include "core/types.h"

namespace illustrate {

// The loops between the visits to a vertex, each a polygon of its own. A loop that lies inside the
// rest and runs the other way round is a hole: the ring between is cut by diagonals instead, as is
// a hole that a bridge, an edge run along twice, joins to its outline. What has no area by its
// vertices alone (spikes) vanishes; so the result may be empty.
// `corners`: no two neighbours equal. Every part has at least three corners, all different, and
// keeps the winding.
// `looks`: at corners, counted down; none left, the rest is taken apart without a search, and holes
// are closed.
Ragged<int> split_polygon(Span<const int> corners, const Points& positions, std::size_t& looks);

}  // namespace illustrate
