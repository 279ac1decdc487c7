#include "core/disjoint_sets.h"

#include <gtest/gtest.h>

namespace illustrate {
namespace {

TEST(DisjointSets, TheRootIsTheLowestWhateverWasJoinedFirst) {
  DisjointSets sets(7);
  sets.join(5, 6);
  sets.join(2, 5);
  sets.join(4, 1);
  sets.join(6, 4);
  const std::vector<int> expected{0, 1, 1, 3, 1, 1, 1};
  for (int i = 0; i < 7; ++i) EXPECT_EQ(sets.root(i), expected[idx(i)]) << i;
}

}  // namespace
}  // namespace illustrate
