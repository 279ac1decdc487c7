// Streamlines along the cross field, step by step: new ones from seeds, and longer ends of old
// ones.
#pragma once

#include "core/progress.h"
#include "hatch/streamlines/streamline_set.h"

namespace illustrate {

// In spacings.
struct GrowRules {
  double clear = 0.75;  // of the seed from parallel streamlines
  double test = 0.6;    // a streamline ends so near to one
  double least_length = 1.5;
};

// Nodes along both directions of the cross at those seeds that are seen and where hatches are
// wanted.
std::vector<StreamlineNode> seed_nodes(const HatchView& view,
                                       const std::vector<SurfacePoint>& seeds);

// New streamlines from the nodes, in their order. Throws Cancelled through `progress`.
void fill_streamlines(StreamlineSet& set, const HatchView& view,
                      const std::vector<StreamlineNode>& seeds, const GrowRules& rules,
                      const Progress& progress = {});

// Both ends of all streamlines go on while they are clear by `test` spacings.
void extend_streamlines(StreamlineSet& set, const HatchView& view, double test);

// The same, and then in finer steps, clear by less, right to what ends them.
void extend_tips(StreamlineSet& set, const HatchView& view, double test, double tip_test);

}  // namespace illustrate
