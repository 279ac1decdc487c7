// Bits so mixed that numbers close to each other have nothing in common.
#include "core/mixed_bits.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>

namespace illustrate {
namespace {

// Its first numbers with seed 0.
TEST(MixedBits, MakeTheNumbersOfSplitMix64) {
  EXPECT_EQ(mixed_bits(mixing_step), 0xe220a8397b1dcdafU);
  EXPECT_EQ(mixed_bits(2 * mixing_step), 0x6e789e6aa1b965f4U);
  EXPECT_EQ(mixed_bits(3 * mixing_step), 0x06c45d188009454fU);
}

TEST(MixedBits, NeighboursDifferInHalfOfThem) {
  constexpr int count = 10'000;
  double sum = 0;
  for (std::uint64_t i = 0; i < count; ++i)
    sum += static_cast<double>(std::bitset<64>(mixed_bits(i) ^ mixed_bits(i + 1)).count());
  EXPECT_LT(std::abs(sum / count - 32), 5 * 4 / std::sqrt(count));
}

}  // namespace
}  // namespace illustrate
