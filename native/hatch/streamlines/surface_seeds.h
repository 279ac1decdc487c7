// Where streamlines of a view start from: places fixed on the surface.
#pragma once

#include "hatch/curves/object_curves.h"
#include "hatch/view/hatch_view.h"

namespace illustrate {

// (objects) world lengths, on average over what is seen; 0 where nothing is seen and hatched.
struct ObjectSpacings {
  std::vector<double> plain;  // of spacing_px pixels, where nothing scales it
  std::vector<double> least;  // the same where it is scaled most
};
ObjectSpacings object_spacings(const HatchScene& scene, double spacing_px);

// What streamlines in one area of a view, all hatches or undercuts, start from besides places fixed
// on the surface: found once for all objects.
struct SeedPlaces {
  std::vector<double> spacings;       // (objects) plain ones, as above
  std::vector<SurfacePoint> lattice;  // under a lattice of the image: on objects so near that
                                      // places fixed on them lie too far apart
  std::vector<SurfacePoint> strips;   // beside critical curves (edge_seeds.h)
};
SeedPlaces seed_places(const HatchScene& scene, const HatchView& view,
                       const CurvesOfObjects& curves);

// Along both directions of the cross, where the view's hatches may run: at places fixed on the
// objects that have curves, and those of the lattice. `passable`: of the view
// (passable_triangles.h).
std::vector<StreamlineNode> surface_seeds(const HatchView& view, const CurvesOfObjects& curves,
                                          const SeedPlaces& places,
                                          const std::vector<std::uint8_t>& passable);

}  // namespace illustrate
