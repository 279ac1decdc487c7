// Where strands cross in the image, decided exactly.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "visibility/arrangement/image_strands.h"

namespace illustrate {

// A place on a strand: behind its point `segment`, `fraction` of the way (in the image) to the next
// point.
struct StrandPlace {
  int strand;
  int segment;
  double fraction;
};

struct Crossing {
  StrandPlace front;  // where it is drawn
  StrandPlace back;
  std::array<double, 2> decided;  // fractions of front and back where that was decided
  Vec2 image;                     // px
  bool enters_left;  // the back strand passes to the front strand's left side as the viewer sees it
  bool at_corner;    // both strands end here, up to how far apart what touches is decided to be
};

// All of them, in a fixed order, but those where curvature lines, which hide nothing, pass in
// front, and those of strands that are buried or
// beyond the frame. Two closed curves cross an even number of times, whatever the degeneracy: ties
// are settled by a symbolic perturbation by point id. Segments that share a node do not cross.
// Nothing where there are more than `most`.
std::optional<std::vector<Crossing>> find_crossings(
    const CurveNetwork& network, const ImageStrands& strands,
    std::size_t most = std::numeric_limits<std::size_t>::max());

// The sign of the turn a, b, c: +1 left (y up), -1 right; never 0 for different ids.
int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c);

}  // namespace illustrate
