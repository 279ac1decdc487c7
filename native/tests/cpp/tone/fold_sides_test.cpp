#include "tone/fold_sides.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr double px = 0.01;  // world units: the view shows 2 x 2

// A plate over a floor, half a unit high and as wide as asked for, to the left of x = 0; seen from
// above, each of a brightness of its own.
FoldSides seen_across(double plate_px, float plate_light, float floor_light, double most_px = 100) {
  PolygonMesh plate = shapes::plane(1, 1);
  for (Vec3& p : plate.positions) {
    p = Vec3((p.x() - 1) / 2 * plate_px * px, p.y(), 0.5);
  }
  const Surface surface =
      shapes::joined(shapes::plain_surface(shapes::plane(1, 1)), shapes::plain_surface(plate));
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const VisibleImage visible = render_visible(surface, camera, 1, {}, 1);
  std::vector<float> brightness;
  for (const int t : visible.triangle) {
    brightness.push_back(surface.object_of(t) == 1 ? plate_light : floor_light);
  }
  return fold_sides(surface, visible, brightness, camera.project(Vec3(0, 0, 0.5)).xy, Vec2::UnitX(),
                    most_px, 6 * px);
}

TEST(FoldSides, APartIsAsWideAsItIsSeen) {
  for (const double width : {6.0, 20.0, 45.0}) {
    EXPECT_NEAR(seen_across(width, 1, 1).width_px, width, 1) << width;
  }
  EXPECT_EQ(seen_across(80, 1, 1, 48).width_px, 48);
}

// Next to its outline a ball recedes by many cells from one cell to the next.
TEST(FoldSides, ABallIsAsWideAsItsDiameter) {
  for (const double radius : {20.0, 60.0}) {
    const Surface surface = shapes::sphere_surface(radius * px, 5);
    const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
    const VisibleImage visible = render_visible(surface, camera, 1, {}, 1);
    const std::vector<float> brightness(visible.triangle.size(), 1);
    const Vec2 outline = camera.project(Vec3(radius * px, 0, 0)).xy;
    const auto width = [&](double most_px) {
      return fold_sides(surface, visible, brightness, outline, Vec2::UnitX(), most_px, 6 * px)
          .width_px;
    };
    EXPECT_EQ(width(1.5 * radius), 1.5 * radius);
    EXPECT_NEAR(width(1000), 2 * radius, 3);
  }
}

TEST(FoldSides, WhatLeavesTheFrameGoesOn) {
  EXPECT_EQ(seen_across(150, 1, 1, 120).width_px, 120) << "100 px of it are in the frame";
}

TEST(FoldSides, LightIsThatOfEachSide) {
  const FoldSides sides = seen_across(20, 0.25F, 0.75F);
  EXPECT_EQ(sides.light, 0.25);
  EXPECT_EQ(sides.light_beyond, 0.75);
  EXPECT_EQ(seen_across(20, 0.5F, 7).light_beyond, 1) << "white is white";
}

TEST(FoldSides, AnotherFlatFaceIsAnotherPart) {
  const Surface cube = [] {
    Surface surface = shapes::plain_surface(shapes::cube());
    surface.planes.resize(6);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      surface.triangle_planes[t] = static_cast<int>(t / 2);
    }
    return surface;
  }();
  const Camera camera = cameras::orthographic(Vec3(1, 0, 2), 2, 200);
  const VisibleImage visible = render_visible(cube, camera, 1, {}, 1);
  const std::vector<float> brightness(visible.triangle.size(), 1);
  const double half = cube.positions[0].cwiseAbs().maxCoeff();
  const Vec2 near_edge = camera.project(Vec3(half, 0, -half)).xy;
  const Vec2 between = camera.project(Vec3(half, 0, half)).xy;
  const Vec2 beyond = (near_edge - between).normalized();
  const FoldSides sides = fold_sides(cube, visible, brightness, near_edge, beyond, 150, 1);
  EXPECT_NEAR(sides.width_px, (near_edge - between).norm(), 1.5);
}

TEST(MachBands, AreKeptByWhatIsWideOrLight) {
  const double band = 6;
  EXPECT_EQ(kept_mach_band({17, 0.1, 0.8}, band), 0) << "narrow and dark";
  EXPECT_EQ(kept_mach_band({17, 0.8, 0.8}, band), 1);
  EXPECT_EQ(kept_mach_band({17, 0.8, 0.1}, band), 1);
  EXPECT_EQ(kept_mach_band({48, 0.1, 0.8}, band), 1);
  EXPECT_NEAR(kept_mach_band({33, 0.1, 0.8}, band), 0.5, 1e-12) << "half way from 3 bands to 8";
  EXPECT_NEAR(kept_mach_band({17, 0.5, 0.8}, band), 0.5, 1e-12) << "half way from 1/2 to 3/4";
  EXPECT_EQ(kept_mach_band({17, 0, 0}, band), 1) << "nothing to be told from";
  EXPECT_EQ(kept_mach_band({0, 0.1, 0.8}, 0), 1) << "no band at all";
}

}  // namespace
}  // namespace illustrate
