// Objects that are hatched together. None hinders another, so groups can be hatched side by side;
// which group an object is in changes none of its hatches.
#pragma once

#include "hatch/curves/object_curves.h"
#include "hatch/hatches.h"
#include "hatch/view/hatch_scene.h"

namespace illustrate {

// Places beside critical curves (hatch/streamlines/edge_seeds.h), for hatches and for undercuts.
struct EdgeStrips {
  std::vector<SurfacePoint> hatched, undercut;
};

// What the objects of a group have of a view: the same as all have together, less the others' part.
struct HatchGroup {
  CurvesOfObjects curves;      // null for objects of other groups
  Ragged<SurfacePoint> first;  // streamlines of the last drawing
  EdgeStrips strips;
};

// A few groups about as large in the image, the largest first; objects of which nothing is seen and
// hatched are in none. One, which may be empty, where nothing can be divided.
std::vector<HatchGroup> hatch_groups(const HatchScene& scene, const CurvesOfObjects& curves,
                                     const Ragged<SurfacePoint>& first, const EdgeStrips& strips);

// The hatches of all groups, object after object: as if they had been hatched one after another.
Hatches joined(std::vector<Hatches> groups);

}  // namespace illustrate
