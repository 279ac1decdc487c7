// The neighbourhood of cusps cleared of what the image cannot show.
#pragma once

#include "contour/exact/exact_chain.h"

namespace illustrate {

// Leaves one point between cusp_reach_px and 1.6 times that beyond each cusp (where the next cusp
// or the end of the chain is not nearer) and none closer.
void thin_at_cusps(const Surface& surface, const Camera& camera, ExactSegment& segment,
                   ExactPolyline& line);

// Segments of the linear chain on which the two strands that leave a cusp cross each other before
// the next cusp, and the length in the image of what crosses there. Two strands of one cusp do not
// cross unless they are drawn too coarsely.
struct CrossedSegment {
  int segment;
  double length_px;
};
std::vector<CrossedSegment> crossed_at_cusps(const Camera& camera, const ExactPolyline& line);

// Turns pairs of neighbouring cusps of the same jump that are less than a quarter pixel apart into
// one plain point. Returns the number of pairs.
int collapse_swallowtails(const Surface& surface, const Camera& camera, ExactPolyline& line);

}  // namespace illustrate
