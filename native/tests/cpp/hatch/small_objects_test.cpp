#include "hatch/small_objects.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// Balls of these diameters in pixels, side by side.
std::vector<double> scales_of_balls(const std::vector<double>& diameters, double spacing_px,
                                    double least_px) {
  Surface balls = shapes::sphere_surface(diameters[0] / 2, 3);
  for (std::size_t i = 1; i < diameters.size(); ++i) {
    balls = shapes::joined(balls, shapes::sphere_surface(diameters[i] / 2, 3));
  }
  measure_diagonals(balls);
  HatchOptions options;
  options.spacing_px = spacing_px;
  options.least_spacing_px = least_px;
  return SmallObjects(balls, cameras::one_px).finer({}, options);
}

TEST(SmallObjects, HaveAsManyHatchesAsTheyShrink) {
  const double per_diameter = std::sqrt(3.0);  // the diagonal of the box round a ball
  const std::vector<double> scales = scales_of_balls({200, 60, 40, 1}, 8, 3);
  EXPECT_EQ(scales[0], 1);
  EXPECT_NEAR(scales[1], per_diameter * 60 / 128, 0.03);
  EXPECT_NEAR(scales[2] / scales[1], 40 / 60., 1e-9);
  EXPECT_EQ(scales[3], 3 / 8.);
}

TEST(SmallObjects, NeverHaveTheirSpacingWidened) {
  for (const double least : {8.0, 20.0}) {
    EXPECT_EQ(scales_of_balls({200, 30, 1}, 8, least), std::vector<double>(3, 1));
  }
}

TEST(SmallObjects, AreSmallForTheirOwnSpacing) {
  Surface ball = shapes::sphere_surface(50, 3);
  measure_diagonals(ball);
  const double scale = SmallObjects(ball, cameras::one_px).finer({2}, HatchOptions())[0];
  EXPECT_NEAR(scale, 100 * std::sqrt(3.0) / 128, 0.03) << "of 16 spacings of 16 px";
}

TEST(SmallObjects, AreThoseFarAway) {
  Surface ball = shapes::sphere_surface(1, 3);
  measure_diagonals(ball);
  HatchOptions options;
  options.least_spacing_px = 1;
  double before = 1;
  for (double distance = 10; distance < 200; distance += 5) {
    const Camera view = cameras::perspective(Vec3(0, 0, distance), Vec3::Zero());
    const double scale = SmallObjects(ball, view).finer({}, options)[0];
    EXPECT_LE(scale, before);
    EXPECT_GT(scale, 0.7 * before) << "little by little";
    before = scale;
  }
  EXPECT_LT(before, 0.3);
}

}  // namespace
}  // namespace illustrate
