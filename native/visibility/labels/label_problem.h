// Labels of a whole view as one convex problem, on plain data.
//
// Unknown are whole numbers x >= 0. What is known of one of them, and what two of them differ by,
// has a price that grows with the distance from what is asked: every term is convex in one unknown
// or in a difference of two, so that the sum is L-natural-convex (Murota 2003, "Discrete convex
// analysis"). Where no set of unknowns can be raised together by one, nor lowered, with gain, the
// least of all sums is reached, and the best set is a minimum cut (Kolmogorov and Shioura 2009,
// "New algorithms for convex cost tension problem with application to computer vision").
#pragma once

#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "core/types.h"

namespace illustrate {

// Prices are whole numbers, so that sums are exact: this many to a pixel of line.
constexpr double price_of_pixel = 1 << 21;

// below * (low - x) under low, above * (x - high) over high >= low.
struct ValueTerm {
  int unknown;
  int low, high;
  std::int64_t below, above;
};

// The same for the difference x(to) - x(from), under and over one value.
struct DifferenceTerm {
  int from, to;
  int wanted;
  std::int64_t below, above;
};

struct LabelProblem {
  int unknowns = 0;
  std::vector<ValueTerm> values;
  std::vector<DifferenceTerm> differences;
};

// The sum of all terms.
std::int64_t price(const LabelProblem& problem, const std::vector<int>& x);

// Of all x with the least sum the one with the least numbers, whatever the start (unknowns, >= 0);
// only the time depends on that. Throws Cancelled through `progress`, which it asks before each
// cut.
std::vector<int> least_labels(const LabelProblem& problem, std::vector<int> start,
                              const Progress& progress = {});

}  // namespace illustrate
