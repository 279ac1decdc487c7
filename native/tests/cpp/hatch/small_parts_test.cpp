#include "hatch/small_parts.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// The scale of each part; of objects: those asked for.
std::vector<double> scales_of_parts(const Surface& surface, const Camera& seen_by,
                                    const std::vector<double>& of_objects,
                                    const HatchOptions& options) {
  const SurfaceParts parts = surface_parts(surface);
  const std::vector<float> scales = SmallParts(surface, parts, seen_by).finer(of_objects, options);
  std::vector<double> of_parts(parts.diagonals.size(), 1);
  for (std::size_t t = 0; t < scales.size(); ++t) of_parts[idx(parts.of_triangle[t])] = scales[t];
  return of_parts;
}

// Balls of these diameters in pixels, side by side.
std::vector<double> scales_of_balls(const std::vector<double>& diameters, double spacing_px,
                                    double least_px) {
  Surface balls = shapes::sphere_surface(diameters[0] / 2, 3);
  for (std::size_t i = 1; i < diameters.size(); ++i) {
    balls = shapes::joined(balls, shapes::sphere_surface(diameters[i] / 2, 3));
  }
  HatchOptions options;
  options.spacing_px = spacing_px;
  options.least_spacing_px = least_px;
  return scales_of_parts(balls, cameras::one_px, {}, options);
}

TEST(SmallParts, HaveAsManyHatchesAsTheyShrink) {
  const double per_diameter = std::sqrt(3.0);  // the diagonal of the box round a ball
  const std::vector<double> scales = scales_of_balls({200, 60, 40, 1}, 8, 3);
  EXPECT_EQ(scales[0], 1);
  EXPECT_NEAR(scales[1], per_diameter * 60 / 128, 0.03);
  EXPECT_NEAR(scales[2] / scales[1], 40 / 60., 1e-6);
  EXPECT_EQ(scales[3], 3 / 8.);
}

TEST(SmallParts, NeverHaveTheirSpacingWidened) {
  for (const double least : {8.0, 20.0}) {
    EXPECT_EQ(scales_of_balls({200, 30, 1}, 8, least), std::vector<double>(3, 1));
  }
}

TEST(SmallParts, AreSmallForTheirOwnSpacing) {
  const Surface ball = shapes::sphere_surface(50, 3);
  const double scale = scales_of_parts(ball, cameras::one_px, {2}, HatchOptions())[0];
  EXPECT_NEAR(scale, 100 * std::sqrt(3.0) / 128, 0.03) << "of 16 spacings of 16 px";
}

TEST(SmallParts, OfOneObjectHaveTheirOwn) {
  const PolygonMesh large = shapes::icosphere_mesh(100, 3), small = shapes::icosphere_mesh(20, 3);
  const Surface eye =
      shapes::plain_surface(shapes::joined(large, shapes::moved(small, {130, 0, 0})));
  ASSERT_EQ(eye.object_is_smooth.size(), 1U);
  const std::vector<double> scales = scales_of_parts(eye, cameras::one_px, {}, HatchOptions());
  EXPECT_EQ(scales, (std::vector<double>{1, scales_of_balls({40}, 8, 4)[0]}));
  EXPECT_LT(scales[1], 0.7);
}

TEST(SmallParts, OfLargeOnesAreNone) {
  const Surface ball = shapes::sphere_surface(200, 3);
  const SurfaceParts parts = surface_parts(ball);
  EXPECT_TRUE(SmallParts(ball, parts, cameras::one_px).finer({}, HatchOptions()).empty());
}

TEST(SmallParts, AreThoseFarAway) {
  const Surface ball = shapes::sphere_surface(1, 3);
  HatchOptions options;
  options.least_spacing_px = 1;
  double before = 1;
  for (double distance = 10; distance < 200; distance += 5) {
    const Camera view = cameras::perspective(Vec3(0, 0, distance), Vec3::Zero());
    const double scale = scales_of_parts(ball, view, {}, options)[0];
    EXPECT_LE(scale, before);
    EXPECT_GT(scale, 0.7 * before) << "little by little";
    before = scale;
  }
  EXPECT_LT(before, 0.3);
}

// A rod of these sides in pixels.
PolygonMesh rod(double width, double length) {
  PolygonMesh mesh = shapes::cube();
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(length, width, width) / 2);
  return mesh;
}

// Of each part, at a spacing of 8 px, of 4 px on the smallest.
std::vector<bool> narrow_parts(const Surface& surface, double scale = 1) {
  const SurfaceParts parts = surface_parts(surface);
  const SmallParts small(surface, parts, cameras::one_px);
  HatchOptions options;
  options.spacing_px = 8;
  options.least_spacing_px = 4;
  const std::vector<std::uint8_t> narrow = small.too_narrow(small.finer({scale}, options), options);
  std::vector<bool> of_parts(parts.diagonals.size(), false);
  for (std::size_t t = 0; t < narrow.size(); ++t) of_parts[idx(parts.of_triangle[t])] = narrow[t];
  return of_parts;
}

TEST(SmallParts, NarrowerThanTheirSpacingHaveNoHatches) {
  const auto is_narrow = [](const PolygonMesh& mesh, double scale = 1) -> bool {
    return narrow_parts(shapes::plain_surface(mesh), scale)[0];
  };
  EXPECT_TRUE(is_narrow(rod(3, 200))) << "a wire";
  EXPECT_FALSE(is_narrow(rod(6, 200)));
  EXPECT_TRUE(is_narrow(rod(6, 200), 2)) << "a wider spacing is asked for";
  EXPECT_FALSE(is_narrow(rod(3, 40))) << "short and finer";
  EXPECT_TRUE(is_narrow(rod(2, 20))) << "a hair";
  EXPECT_TRUE(is_narrow(shapes::icosphere_mesh(2, 2)));
  EXPECT_FALSE(is_narrow(shapes::icosphere_mesh(4, 2)));
}

TEST(SmallParts, AreNarrowEachByItself) {
  const PolygonMesh brush = shapes::joined(
      rod(40, 200),
      shapes::joined(shapes::moved(rod(2, 60), {0, 60, 0}), shapes::moved(rod(2, 60), {0, 70, 0})));
  EXPECT_EQ(narrow_parts(shapes::plain_surface(brush)), (std::vector<bool>{false, true, true}));
}

}  // namespace
}  // namespace illustrate
