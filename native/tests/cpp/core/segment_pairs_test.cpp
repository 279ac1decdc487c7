#include "core/segment_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace illustrate {
namespace {

bool meet(const SegmentBox& a, const SegmentBox& b) {
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
         b.low[1] <= a.high[1];
}

// Steps of a random walk that now and then starts elsewhere.
std::vector<SegmentBox> walk_boxes(int count, int jump_every) {
  std::mt19937 random(5);
  std::vector<SegmentBox> boxes;
  std::int64_t x = 0, y = 0;
  for (int i = 0; i < count; ++i) {
    if (i % jump_every == 0) {
      x = random() % 300;
      y = random() % 300;
    }
    const std::int64_t u = x + random() % 21 - 10, v = y + random() % 21 - 10;
    boxes.push_back({{std::min(x, u), std::min(y, v)}, {std::max(x, u), std::max(y, v)}});
    x = u;
    y = v;
  }
  return boxes;
}

TEST(SegmentPairs, AreThoseOfAllBoxesThatMeet) {
  for (const int jump_every : {1, 3, 50, 1000}) {
    const std::vector<SegmentBox> boxes = walk_boxes(700, jump_every);
    std::vector<std::pair<int, int>> found, expected;
    overlapping_boxes(boxes, [&](int i, int j) { found.emplace_back(i, j); });
    for (int i = 0; i < 700; ++i) {
      for (int j = i + 1; j < 700; ++j) {
        if (meet(boxes[idx(i)], boxes[idx(j)])) expected.emplace_back(i, j);
      }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << jump_every;
  }
}

TEST(SegmentPairs, OfNothingAreNone) {
  overlapping_boxes({}, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace illustrate
