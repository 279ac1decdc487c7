#include "core/index_map.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace illustrate {
namespace {

TEST(IndexMap, HoldsWhatAnyMapHolds) {
  std::mt19937 random(1);
  for (const int largest : {10, 1000, 2147483647}) {
    IndexMap map;
    std::map<int, int> expected;
    std::uniform_int_distribution<int> any(0, largest);
    for (int i = 0; i < 3000; ++i) {
      const int key = any(random);
      EXPECT_EQ(map.at(key), expected.count(key) ? expected[key] : none);
      map.at(key) = expected[key] = i;
    }
    for (const auto& [key, value] : expected) EXPECT_EQ(map[key], value);
  }
}

TEST(IndexMap, KnowsNothingOfOtherKeys) {
  IndexMap map(100);
  for (int i = 0; i < 100; ++i) map.at(7 * i) = i;
  for (int i = 0; i < 700; ++i) EXPECT_EQ(map[i], i % 7 == 0 ? i / 7 : none);
  EXPECT_EQ(IndexMap()[5], none);
}

}  // namespace
}  // namespace illustrate
