// Pairs of segments of a plane whose boxes overlap.
#pragma once

#include <functional>

#include "core/types.h"

namespace illustrate {

struct SegmentBox {
  std::array<std::int64_t, 2> low;
  std::array<std::int64_t, 2> high;
};

// Calls visit(i, j), i < j, once for every pair of boxes that overlap or touch, in a fixed order.
void overlapping_boxes(const std::vector<SegmentBox>& boxes,
                       const std::function<void(int, int)>& visit);

}  // namespace illustrate
