// The curves that bound the outside of a drawing: nothing can lie in front of them.
#pragma once

#include "visibility/arrangement/crossings.h"

namespace illustrate {

// For each strand the places, one for each segment at most and in order, at which it is the first
// or the last curve on a scan line through the whole drawing. Empty where a silhouette ends at the
// near plane: what is cut off there may hide without an outline.
std::vector<std::vector<StrandPlace>> outline_places(const CurveNetwork& network,
                                                     const ImageStrands& strands);

}  // namespace illustrate
