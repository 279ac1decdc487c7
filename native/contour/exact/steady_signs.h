// Signs that noisy numbers in a row have for longer.
#pragma once

#include <vector>

namespace illustrate {

// +1 or -1 for each number: of all ways to choose them the one with the least sum of the sizes of
// numbers whose own sign is another one, and of `price` for each change from one to the next. In
// time of the count (two states of Viterbi's algorithm). Of ways of equal cost one that ends with
// +1, and changes late.
std::vector<int> steady_signs(const std::vector<double>& numbers, double price);

}  // namespace illustrate
