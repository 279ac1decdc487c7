#include "core/intervals.h"

#include <gtest/gtest.h>

namespace illustrate {
namespace {

void expect_are(const Intervals& found, const std::vector<std::array<double, 2>>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].from, expected[i][0]);
    EXPECT_EQ(found[i].to, expected[i][1]);
  }
}

TEST(Intervals, AreJoinedWhereLittleIsBetween) {
  expect_are(joined({}, 0), {});
  expect_are(joined({{4, 5}, {0, 1}, {1, 2}, {0.5, 0.7}}, 0), {{0, 2}, {4, 5}});
  expect_are(joined({{4, 5}, {0, 1}, {1.5, 2}}, 0.4), {{0, 1}, {1.5, 2}, {4, 5}});
  expect_are(joined({{4, 5}, {0, 1}, {1.5, 2}}, 0.5), {{0, 2}, {4, 5}});
}

TEST(Intervals, HaveInCommonWhatBothHave) {
  expect_are(common({{0, 2}, {3, 5}}, {{1, 4}, {4.5, 9}}), {{1, 2}, {3, 4}, {4.5, 5}});
  expect_are(common({{0, 1}}, {{1, 2}}), {});
}

TEST(Intervals, LeaveWhatIsOutside) {
  expect_are(without({0, 1}, {}), {{0, 1}});
  expect_are(without({0, 1}, {{-1, 0.2}, {0.4, 0.5}}), {{0.2, 0.4}, {0.5, 1}});
  expect_are(without({0, 1}, {{0.4, 3}, {4, 5}}), {{0, 0.4}});
  expect_are(without({0, 1}, {{0, 1}}), {});
  expect_are(without({0, 1}, {{2, 3}}), {{0, 1}});
}

}  // namespace
}  // namespace illustrate
