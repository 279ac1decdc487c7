// Lines that have no room beside each other.
#include "stroke/crowded_lines.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

constexpr double full = 2, reach = 6 * full;  // widths in pixels

StrokePath line(const Vec2& from, const Vec2& to, double width = full) {
  StrokePath path;
  for (const Vec2& image : {from, to}) {
    path.points.push_back({Vec3(image.x(), -image.y(), 0), {}, image, width});
  }
  return path;
}

// Upright lines next to each other, in the middle of an image of 1000 px.
std::vector<StrokePath> comb(int count, double pitch) {
  std::vector<StrokePath> lines;
  for (int i = 0; i < count; ++i) {
    const double x = 500 + pitch * (i - (count - 1) / 2.0);
    lines.push_back(line({x, 300}, {x, 700}));
  }
  return lines;
}

std::vector<StrokePath> thinned(std::vector<StrokePath> lines, double share = 1) {
  thin_where_crowded(lines, reach, share, cameras::one_px);
  return lines;
}

double width_at(const StrokePath& path, double y) {
  const auto nearest = std::min_element(
      path.points.begin(), path.points.end(), [&](const StrokePoint& a, const StrokePoint& b) {
        return std::abs(a.image.y() - y) < std::abs(b.image.y() - y);
      });
  return nearest->width;
}

TEST(CrowdedLines, AreNotThoseWithRoom) {
  for (const int count : {1, 2, 3, 20}) {
    const std::vector<StrokePath> lines = thinned(comb(count, 3 * full));
    for (const StrokePath& path : lines) {
      ASSERT_EQ(path.points.size(), 2U) << count;
      EXPECT_EQ(path.points[0].width, full);
    }
  }
  EXPECT_EQ(thinned(comb(2, 0))[0].points.size(), 2U) << "twice the same";
}

TEST(CrowdedLines, CoverAShareOfThePaper) {
  for (const double pitch : {1., 1.5, 2., 3.}) {
    const double middle = width_at(thinned(comb(101, pitch))[50], 500);
    EXPECT_NEAR(middle, 0.4 * pitch, 0.03 * pitch) << pitch;
  }
}

TEST(CrowdedLines, KeepTheOutlineOfTheCrowd) {
  const std::vector<StrokePath> lines = thinned(comb(41, 2));
  EXPECT_GT(width_at(lines[0], 500), 0.9 * full);
  EXPECT_GT(width_at(lines[40], 500), 0.9 * full);
  EXPECT_LT(width_at(lines[8], 500), 0.5 * full);
}

TEST(CrowdedLines, StayHairs) {
  EXPECT_NEAR(width_at(thinned(comb(400, 0.1))[200], 500), 0.2 * full, 1e-6);
}

TEST(CrowdedLines, ThinOutAsFarAsIsAsked) {
  const double all = full - width_at(thinned(comb(101, 2))[50], 500);
  EXPECT_NEAR(full - width_at(thinned(comb(101, 2), 0.5)[50], 500), all / 2, 1e-6);
  EXPECT_EQ(thinned(comb(101, 2), 0)[50].points.size(), 2U);
}

TEST(CrowdedLines, AreFullWhereTheyLeaveTheCrowd) {
  std::vector<StrokePath> lines = comb(41, 2);
  lines[20] = line({500, 50}, {500, 950});
  const StrokePath path = thinned(lines)[20];
  EXPECT_EQ(width_at(path, 100), full);
  EXPECT_LT(width_at(path, 500), 0.5 * full);
  EXPECT_EQ(path.points.front().image, Vec2(500, 50));
  EXPECT_EQ(path.points.back().image, Vec2(500, 950));
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double step = (path.points[i].image - path.points[i - 1].image).norm();
    EXPECT_LT(std::abs(path.points[i].width - path.points[i - 1].width), 0.12 * step);
  }
}

TEST(CrowdedLines, AreThinnedOnTheWayRoundToo) {
  const double step = std::acos(-1.) / 45;
  std::vector<StrokePath> rings;
  for (int r = 100; r < 200; r += 2) {
    StrokePath ring;
    ring.closed = true;
    for (int i = 0; i < 90; ++i) {
      const Vec2 image = Vec2(500, 500) + r * Vec2(std::cos(i * step), std::sin(i * step));
      ring.points.push_back({Vec3(image.x(), -image.y(), 0), {}, image, full});
    }
    rings.push_back(ring);
  }
  const std::vector<StrokePath> lines = thinned(rings);
  for (const StrokePoint& p : lines[25].points) EXPECT_NEAR(p.width, 0.8, 0.1);
  EXPECT_TRUE(lines[25].closed);
}

TEST(CrowdedLines, MayLieAnywhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<StrokePath> lines = comb(41, 2);
  lines.push_back(line({nan, 0}, {10, nan}));
  lines.push_back(line({-1e9, 500}, {1e9, 500}));
  lines.push_back({});
  lines = thinned(lines);
  EXPECT_TRUE(lines.back().points.empty());
  EXPECT_LT(width_at(lines[20], 450), full);
}

}  // namespace
}  // namespace illustrate
