// Hatches on parts that are small for their spacing are finer; where none fits there are none.
#pragma once

#include <vector>

#include "hatch/greedy/place_hatches.h"
#include "surface/parts.h"

namespace illustrate {

// How large the connected parts of a surface are in a view: all of each, whatever of it is seen.
class SmallParts {
 public:
  // Refers to surface and parts.
  SmallParts(const Surface& surface, const SurfaceParts& parts, const Camera& camera);

  // (t) factors of spacing_px. of_objects: those that are asked for; empty: 1. The same, but on
  // parts smaller than sixteen of their spacings smaller with them, until the spacing is
  // least_spacing_px; that of undercuts shrinks in proportion. So a part that goes away keeps its
  // hatches for a while, and none comes or goes at once. Empty where all are 1.
  std::vector<float> finer(const std::vector<double>& of_objects,
                           const HatchOptions& options) const;

  // (t) 1: of a part that is narrower than its spacing: hairs, wires, blades of grass, far leaves.
  // Their outlines fill them; a hatch between would be a third line along both. Narrow is what has
  // little area for its length, half of that a closed part turns away. scales: of `finer`. Empty
  // where there is none.
  std::vector<std::uint8_t> too_narrow(const std::vector<float>& scales,
                                       const HatchOptions& options) const;

 private:
  const Surface& surface_;
  const SurfaceParts& parts_;
  // (parts) how long and how wide; infinite where nothing is known.
  std::vector<double> size_px_, width_px_;
};

}  // namespace illustrate
