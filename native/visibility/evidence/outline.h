// The curves that bound the outside of a drawing: nothing can lie in front of them.
#pragma once

#include "mesh/bvh.h"
#include "surface/surface.h"
#include "visibility/arrangement/crossings.h"

namespace illustrate {

// Where triangles are cut off at the near plane: there what is before it ends without a curve.
std::vector<ImageSegment> near_cuts(const Surface& surface, const Bvh& bvh, const Camera& camera);

// Whether a silhouette ends other than at the near plane: what lies behind its end may hide without
// an outline.
bool has_open_silhouette(const CurveNetwork& network, const Camera& camera);

// For each strand the places, one for each segment at most and in order, at which it is the first
// or the last curve on a scan line through the frame, cuts included.
std::vector<std::vector<StrandPlace>> outline_places(const CurveNetwork& network,
                                                     const ImageStrands& strands,
                                                     const Eigen::AlignedBox2d& frame,
                                                     const std::vector<ImageSegment>& cuts);

}  // namespace illustrate
