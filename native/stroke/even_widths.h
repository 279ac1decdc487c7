// Widths along a stroke that do not jump.
#pragma once

#include "stroke/stroke_path.h"

namespace illustrate {

// Each width the mean of those within half of `blend_px` along the path, at points no farther apart
// than a quarter of it, each once: where one arc is thinner than the next, whose first point is its
// last, the stroke thins out in between.
StrokePath with_even_widths(const StrokePath& path, double blend_px, const Camera& camera);

// The parts of a path whose points have a width, longer than `speck_px`, or all of it. Ends that
// are cut are not free.
std::vector<StrokePath> parts_with_width(const StrokePath& path, double speck_px);

}  // namespace illustrate
