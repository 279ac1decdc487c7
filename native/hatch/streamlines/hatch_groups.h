// Objects that are hatched together. None hinders another, so groups can be hatched side by side;
// which group an object is in changes none of its hatches.
#pragma once

#include "hatch/curves/object_curves.h"
#include "hatch/hatches.h"
#include "hatch/streamlines/surface_seeds.h"

namespace illustrate {

// What the objects of a group have of a view: the same as all have together, less the others' part.
struct HatchGroup {
  CurvesOfObjects curves;         // null for objects of other groups
  Ragged<SurfacePoint> first;     // streamlines of the last drawing
  SeedPlaces hatched, undercuts;  // of all hatches, and of undercuts
};

// A few groups about as large in the image, the largest first; objects of which nothing is seen and
// hatched are in none. One, which may be empty, where nothing can be divided. `all`: of all
// objects.
std::vector<HatchGroup> hatch_groups(const HatchScene& scene, HatchGroup all);

// The hatches of all groups, object after object: as if they had been hatched one after another.
Hatches joined(std::vector<Hatches> groups);

}  // namespace illustrate
