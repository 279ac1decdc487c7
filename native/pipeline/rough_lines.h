// The lines of a view for a viewer that redraws while it moves: a millisecond, not exact.
#pragma once

#include "pipeline/prepare.h"
#include "view/camera.h"

namespace illustrate {

using Segment = std::array<Eigen::Vector3f, 2>;  // world

// The zero set of n . (c - p), linear on each triangle (paper section 4.1), and the edges of
// polygon objects between a front and a back face (section 4.3), hidden ones too, in no order.
std::vector<Segment> rough_silhouettes(const Prepared& prepared, const Camera& camera);

// Creases, boundaries and the other edges that every view draws, without what lies within a face of
// another part (flush.h); where surfaces pass through each other.
std::vector<Segment> rough_features(const Prepared& prepared);

}  // namespace illustrate
