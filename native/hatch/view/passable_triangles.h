// Where on a surface no hatch can pass, told quickly for many triangles at a time.
#pragma once

#include "hatch/view/hatch_area.h"

namespace illustrate {

// (t) 0: HatchArea::may_pass lets nothing pass on the triangle: it lies out of the frame, behind
// all that is seen around it, or where no hatch is wanted. 1: something may. What is said of a
// triangle holds for the 64 that are stored next to each other with it.
std::vector<std::uint8_t> passable_triangles(const HatchScene& scene, Area area);

}  // namespace illustrate
