#include "stroke/pen_parts.h"

#include <gtest/gtest.h>

namespace illustrate {
namespace {

// Points a pixel apart, on triangles whose pens are to be these.
StrokePath path_over(const std::vector<int>& triangles, bool closed = false) {
  StrokePath path;
  path.closed = closed;
  path.free_start = path.free_end = !closed;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vec2 at(static_cast<double>(i), 0);
    path.points.push_back({Vec3(at.x(), 0, 0), {triangles[i], 0, 0}, at, 1});
  }
  return path;
}

const std::vector<int> pens{0, 1, 2};  // of triangles

struct Told {
  double first, last;
  int pen;
  bool operator==(const Told& o) const {
    return first == o.first && last == o.last && pen == o.pen;
  }
};

std::vector<Told> told(const StrokePath& path, double speck_px = 0) {
  std::vector<Told> all;
  for (const PenPart& part : parts_by_pen(path, pens, speck_px)) {
    EXPECT_FALSE(part.path.closed);
    all.push_back(
        {part.path.points.front().image.x(), part.path.points.back().image.x(), part.pen});
  }
  return all;
}

TEST(PenParts, EndWhereTheNextOneStarts) {
  const StrokePath path = path_over({0, 0, 0, 2, 2, 1, 1, 1});
  EXPECT_EQ(told(path), (std::vector<Told>{{0, 3, 0}, {3, 5, 2}, {5, 7, 1}}));
  const std::vector<PenPart> parts = parts_by_pen(path, pens, 0);
  EXPECT_TRUE(parts[0].path.free_start && parts[2].path.free_end);
  EXPECT_FALSE(parts[0].path.free_end || parts[1].path.free_start || parts[2].path.free_start);
}

TEST(PenParts, SpecksJoinWhatIsBeforeThem) {
  EXPECT_EQ(told(path_over({0, 0, 0, 0, 1, 0, 0, 0, 0}), 3), (std::vector<Told>{{0, 8, 0}}));
}

TEST(PenParts, OfAClosedPathStartWhereAPenChanges) {
  EXPECT_EQ(told(path_over({0, 0, 1, 1, 0}, true)), (std::vector<Told>{{2, 4, 1}, {4, 2, 0}}));
}

TEST(PenParts, WithOnePenAPathStays) {
  const std::vector<PenPart> parts = parts_by_pen(path_over({2, 2, 2}, true), pens, 0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].path.closed);
  EXPECT_EQ(parts[0].pen, 2);
  EXPECT_EQ(parts_by_pen(path_over({1, 2}), {}, 0).at(0).pen, 0) << "without pens";
}

}  // namespace
}  // namespace illustrate
