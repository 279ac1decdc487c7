// Lines too short to be seen as lines.
#pragma once

#include "stroke/chains.h"

namespace illustrate {

// (chains) 0 for specks: chains shorter than `speck_px` with an end (closed ones: everything) that
// meets no other kept chain with as few layers in front. What closes a gap between two others
// stays, but not what is seen in a slit of less than a unit of the graph between two
// curves in front.
std::vector<std::uint8_t> chains_without_specks(const LabelledGraph& graph,
                                                const std::vector<Chain>& chains,
                                                const Ragged<ArcEnd>& ends, double speck_px);

}  // namespace illustrate
