// Which objects may show the back of their surface.
#pragma once

#include "contour/intersection/intersections.h"
#include "view/camera.h"

namespace illustrate {

// (objects) 0 where no point of the back can be seen: the surface is closed and has an outside,
// does not pass through itself and lies wholly beyond the near plane.
std::vector<std::uint8_t> shows_back(const Surface& surface,
                                     const IntersectionCurves& intersections, const Camera& camera);

}  // namespace illustrate
