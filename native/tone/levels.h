// Which brightness is a highlight, and which a shadow (paper section 6.2).
#pragma once

#include <array>
#include <vector>

namespace illustrate {

struct ToneOptions;

// Brighter than `highlight`: highlight; at most `shadow`: shadow; at most extra[i]: extra level
// i + 1 too. Infinite where no light is so bright.
struct Thresholds {
  double highlight;
  double shadow;
  std::array<double, 3> extra;
};

// Those of the options, or those that divide `light`, the visible places, into the shares asked for
// as exactly as equal values allow. Extra levels divide the shadows evenly: their light where the
// threshold is given, their area where the share is.
Thresholds find_thresholds(const ToneOptions& options, std::vector<double> light);

}  // namespace illustrate
