// Lines thin out where they crowd, as one takes a finer pen for what is small on the page.
//
// Far or finely made things ask for more ink than their place on the page has room for: gaps
// between lines close, and a hand, a hedge or a town is a black spot. How crowded a place is, is
// the share of the paper that the lines round it would cover if none overlapped another. Beyond
// what still reads as lines, those that have others on both sides thin out in proportion, so that
// detail turns grey; the outline of a crowd, which has room on one side, keeps its weight. Nothing
// is left out, and nothing jumps as the camera moves.
#pragma once

#include <vector>

#include "stroke/stroke_path.h"

namespace illustrate {

// `reach_px`: from how far round a place lines count, the less the farther; several widths of a
// line. share in [0, 1]: of what lines have to thin out, so much they do; 0: they stay as they are.
// Lines that are not crowded anywhere stay as they are to the bit, others get points between
// theirs.
void thin_where_crowded(std::vector<StrokePath>& paths, double reach_px, double share,
                        const Camera& camera);

}  // namespace illustrate
