// The first streamlines of a view: curves on the surface, as far as they are seen and hatches are
// wanted, where they are clear of those that were placed before.
#pragma once

#include "core/progress.h"
#include "hatch/curves/surface_curves.h"
#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// In spacings. A run of nodes is placed that is nowhere nearer than `test` to a parallel
// streamline, somewhere `clear` of all, and not shorter than `least_length`.
struct PlaceRules {
  double test = 0.65;
  double clear = 0.75;
  double least_length = 1.5;
  bool straight = false;  // between points of a curve; else along the cross
  bool holds = false;     // nodes where the view rests are held, however near to others
};

// In the order of the curves. Nodes come to lie .5 to about 1 `node_step` apart: curves with closer
// points are thinned, with farther ones get others between.
void place_curves(StreamlineSet& set, const HatchView& view, const Ragged<SurfacePoint>& curves,
                  const PlaceRules& rules, const Progress& progress);

}  // namespace illustrate
