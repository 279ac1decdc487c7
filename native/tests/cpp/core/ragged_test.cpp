#include "core/ragged.h"

#include <gtest/gtest.h>

#include <random>

namespace illustrate {
namespace {

std::vector<int> copied(Span<const int> list) { return {list.begin(), list.end()}; }

TEST(SortedInto, ListsHoldTheirValuesInOrder) {
  std::mt19937 random(3);
  std::vector<std::vector<int>> expected(7);
  std::vector<std::pair<int, int>> put_in;
  for (int value = 0; value < 100; ++value) {
    const int list = static_cast<int>(random() % 6);  // the last one stays empty
    put_in.push_back({list, value});
    expected[static_cast<std::size_t>(list)].push_back(value);
  }
  const Ragged<int> lists = sorted_into<int>(expected.size(), [&](const auto& put) {
    for (const auto& [list, value] : put_in) put(list, value);
  });
  ASSERT_EQ(lists.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(copied(lists[i]), expected[i]);
}

TEST(SortedInto, NothingGivesEmptyLists) {
  const Ragged<int> lists = sorted_into<int>(3, [](const auto&) {});
  EXPECT_EQ(lists.size(), 3U);
  EXPECT_TRUE(lists.values.empty());
  EXPECT_TRUE(sorted_into<int>(0, [](const auto&) {}).empty());
}

}  // namespace
}  // namespace illustrate
