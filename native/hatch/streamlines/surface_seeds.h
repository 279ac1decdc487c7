// Where streamlines of a view start from: places fixed on the surface.
#pragma once

#include "hatch/curves/object_curves.h"
#include "hatch/view/hatch_view.h"

namespace illustrate {

// (objects) world length of a spacing of spacing_px pixels, on average over what is seen; 0 where
// nothing is seen and hatched.
std::vector<double> mean_spacings(const HatchScene& scene, double spacing_px);

// Along both directions of the cross, where the view's hatches may run. On objects so near that
// their places lie too far apart, from a lattice of the image too.
std::vector<StreamlineNode> surface_seeds(const HatchScene& scene, const HatchView& view,
                                          const CurvesOfObjects& curves);

}  // namespace illustrate
