// Strokes end where what they run over has another pen.
#pragma once

#include <vector>

#include "stroke/stroke_path.h"

namespace illustrate {

struct PenPart {
  StrokePath path;
  int pen = 0;
};

// The parts of a path by the pens of the triangles that its points lie on, in order; a part ends
// with the point that the next one starts with. Parts of at most `speck_px` join the one before
// them. pens: (t), empty: all 0. Ends that are cut are not free.
std::vector<PenPart> parts_by_pen(const StrokePath& path, const std::vector<int>& pens,
                                  double speck_px);

}  // namespace illustrate
