// Flat faces in one plane beside each other: they are hatched alike.
#pragma once

#include "surface/surface.h"

namespace illustrate {

// (planes) a number for each group of flat faces that lie in one plane, face the same way, and
// touch or have a narrow gap between them, directly or by way of others: its lowest member. Faces
// of different objects are of one group only `across_objects`.
std::vector<int> coplanar_groups(const std::vector<PlaneFace>& planes, bool across_objects);

}  // namespace illustrate
