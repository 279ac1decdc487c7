// Strands cut off at the near plane.
#pragma once

#include "contour/network/network.h"

namespace illustrate {

// The network cut off at the near plane; nodes that lose strands become ends or disappear.
CurveNetwork clip_near(const Surface& surface, const CurveNetwork& network, const Camera& camera);

}  // namespace illustrate
