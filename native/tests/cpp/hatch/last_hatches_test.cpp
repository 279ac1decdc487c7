#include "hatch/last_hatches.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

// A pixel is a unit of the world.
const Camera camera = cameras::orthographic(Vec3::UnitZ(), 500);
constexpr double spacing = 10;

HatchPoint at(double x, double y, double z = 0) {
  const Vec3 position(x, y, z);
  return {position, {}, camera.project(position).xy};
}

LastHatches one_line() {
  Ragged<Vec3> strokes;
  strokes.add(Points{Vec3(-100, 0, 0), Vec3(100, 0, 0)});
  return {strokes, camera, spacing};
}

TEST(LastHatches, AreWhereNoOtherWouldFit) {
  const LastHatches last = one_line();
  const Vec3 along = Vec3::UnitX();
  for (double x = -99; x < 100; x += 7.3) EXPECT_TRUE(last.was_at(at(x, 3), along, spacing)) << x;
  EXPECT_TRUE(last.was_at(at(0, 3), -along, spacing)) << "either way";
  EXPECT_FALSE(last.was_at(at(0, 6), along, spacing)) << "half a spacing away";
  EXPECT_FALSE(last.was_at(at(110, 0), along, spacing)) << "beyond the end";
  EXPECT_FALSE(last.was_at(at(0, 0), Vec3::UnitY(), spacing)) << "across";
  EXPECT_FALSE(last.was_at(at(0, 0, 40), along, spacing)) << "on another sheet";
}

TEST(LastHatches, AreAlongWhatTheyCoverMostOf) {
  const LastHatches last = one_line();
  const auto line = [](double from, double to) {
    std::vector<HatchPoint> points;
    for (double x = from; x <= to; x += 2) points.push_back(at(x, 1));
    return points;
  };
  const auto was_along = [&](std::vector<HatchPoint> points) {
    return last.was_along({points.data(), points.size()}, spacing);
  };
  EXPECT_TRUE(was_along(line(-50, 50)));
  EXPECT_TRUE(was_along(line(0, 180)));
  EXPECT_FALSE(was_along(line(20, 240)));
  EXPECT_FALSE(was_along(line(120, 240)));
}

}  // namespace
}  // namespace illustrate
