// What is seen on the two sides of a fold, for bands.h.
#pragma once

#include <vector>

#include "occlusion/visible_image.h"
#include "surface/surface.h"

namespace illustrate {

// Across a fold, in the image.
struct FoldSides {
  double width_px = 0;      // of the part that folds, from the fold inwards
  double light = 0;         // mean brightness of that, in [0, 1]
  double light_beyond = 0;  // and of what is next beyond the fold
};

// The part goes on, up to `most_px`, until another object or flat face begins or a cell is deeper
// than the one before by more than most_step; beyond the frame, too.
// brightness: (cells). at: a place on the fold, px; beyond: unit, away from the part.
FoldSides fold_sides(const Surface& surface, const VisibleImage& visible,
                     const std::vector<float>& brightness, const Vec2& at, const Vec2& beyond,
                     double most_px, double most_step);

// How much of its Mach band a fold keeps, in [0, 1], where the band would be so wide. A band over
// most of a narrow part would make it as white as it is dark: a black wire, the leg of a table. So
// narrow ones that are darker than what lies beyond have none, and need none to stand out from it.
double kept_mach_band(const FoldSides& sides, double band_px);
// Bands' widths beyond which how wide the part is makes no difference.
constexpr double wide_part = 8;

}  // namespace illustrate
