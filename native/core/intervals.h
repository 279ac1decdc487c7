// Stretches of a line.
#pragma once

#include "core/types.h"

namespace illustrate {

struct Interval {
  double from, to;
};

using Intervals = std::vector<Interval>;

// Those that overlap, or have no more than `gap` between them, become one. The result is
// ascending and its intervals are apart, as the others here want it.
Intervals joined(Intervals parts, double gap);

// What both have.
Intervals common(const Intervals& a, const Intervals& b);

// What `whole` has and `parts` have not.
Intervals without(const Interval& whole, const Intervals& parts);

}  // namespace illustrate
