// Few of many whole numbers put into ascending order.
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.h"

namespace illustrate {

// Sorts numbers from 0 to `end` - 1 and leaves one of each, in time of their count plus end / 64.
inline void sort_unique(std::vector<int>& numbers, std::size_t end) {
  constexpr int word_bits = 64;
  std::vector<std::uint64_t> words(end / word_bits + 1, 0);
  for (const int n : numbers) words[idx(n) / word_bits] |= std::uint64_t{1} << (n % word_bits);
  numbers.clear();
  for (std::size_t w = 0; w < words.size(); ++w) {
    for (std::uint64_t rest = words[w]; rest != 0; rest &= rest - 1) {
      numbers.push_back(static_cast<int>(w) * word_bits + __builtin_ctzll(rest));
    }
  }
}

}  // namespace illustrate
