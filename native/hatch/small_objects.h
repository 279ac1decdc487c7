// Hatches on objects that are small for their spacing are finer.
#pragma once

#include <vector>

#include "hatch/greedy/place_hatches.h"

namespace illustrate {

// How large objects are in a view: all of each, whatever of it is seen.
class SmallObjects {
 public:
  SmallObjects(const Surface& surface, const Camera& camera);

  // scales: of spacing_px, by object; empty: 1. The same, but on objects smaller than sixteen of
  // their spacings smaller with them, until the spacing is least_spacing_px; that of undercuts
  // shrinks in proportion. So an object that goes away keeps its hatches for a while, and none
  // comes or goes at once.
  std::vector<double> finer(std::vector<double> scales, const HatchOptions& options) const;

 private:
  std::vector<double> size_px_;  // (objects) infinite where nothing is known
};

}  // namespace illustrate
