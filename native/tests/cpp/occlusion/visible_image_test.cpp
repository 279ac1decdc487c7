// What is seen at each cell of an image.
#include "occlusion/visible_image.h"

#include <gtest/gtest.h>

#include "core/errors.h"
#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

Vec2 centre_of(const VisibleImage& image, int cell) {
  const int column = cell % image.width, row = cell / image.width;
  return Vec2(column + 0.5, row + 0.5) * image.cell_px;
}

// Greatest error in depth of an icosphere seen from the front, where it is not seen at a grazing
// angle.
double sphere_error(int level) {
  const Surface sphere = shapes::sphere_surface(1, level);
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1.25, 200);
  const VisibleImage image = render_visible(sphere, camera, 1, {}, 1);
  const double eye = camera.project(Vec3::Zero()).depth;
  double worst = 0;
  for (int cell = 0; cell < image.width * image.height; ++cell) {
    const Vec2 p = (centre_of(image, cell) - Vec2(100, 100)) / 80;
    if (p.norm() > 0.8) continue;
    EXPECT_NE(image.triangle[cell], none);
    worst = std::max(worst, std::abs(image.depth[cell] - eye + std::sqrt(1 - p.squaredNorm())));
  }
  return worst;
}

TEST(VisibleImage, DepthOfASphereConverges) {
  const double coarse = sphere_error(2), fine = sphere_error(4);
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(fine, coarse / 10) << "second order: 16";
}

TEST(VisibleImage, DepthIsCorrectInPerspective) {
  const Surface plane = shapes::plain_surface(shapes::plane(1, 1));
  const Vec3 eye(0.2, -2, 1);
  const Camera camera = cameras::perspective(eye, Vec3::Zero(), 0.1, 60, 300);
  const VisibleImage image = render_visible(plane, camera, 1, {}, 1);
  int covered = 0;
  for (int cell = 0; cell < image.width * image.height; ++cell) {
    if (image.triangle[cell] == none) continue;
    ++covered;
    const Vec2 centre = centre_of(image, cell);
    const SurfacePoint on = surface_point_under(plane, camera, image.triangle[cell], centre);
    const ImagePoint seen = camera.project(position_at(plane, on));
    EXPECT_LT((seen.xy - centre).norm(), 1e-8);
    EXPECT_NEAR(seen.depth, image.depth[cell], 1e-9);
  }
  EXPECT_GT(covered, 5000);
}

TEST(VisibleImage, NeighboursLeaveNoCracks) {
  const Surface plane = shapes::plain_surface(shapes::height_field(
      37, 41, [](double x, double y) { return 0.3 * std::sin(5 * x) * std::cos(4 * y); }));
  const Camera camera = cameras::orthographic(Vec3(0.1, 0.05, 1), 0.5, 400);
  const VisibleImage image = render_visible(plane, camera, 1, {}, 1);
  for (const int triangle : image.triangle) EXPECT_NE(triangle, none);
}

TEST(VisibleImage, NearestObjectWinsUnlessHidden) {
  const Surface both =
      shapes::joined(shapes::plain_surface(shapes::plane(2, 2)),
                     shapes::plain_surface(shapes::moved(shapes::plane(2, 2), Vec3(0, 0, 0.5))));
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 0.9, 64);
  for (const int triangle : render_visible(both, camera, 1, {}, 1).triangle) {
    EXPECT_EQ(both.triangle_objects[triangle], 1);
  }
  for (const int triangle : render_visible(both, camera, 1, {0, 1}, 1).triangle) {
    EXPECT_EQ(both.triangle_objects[triangle], 0);
  }
  EXPECT_THROW(render_visible(both, camera, 1, {1}, 1), InvalidInput);
}

TEST(VisibleImage, TrianglesAreCutAtTheNearPlane) {
  const Surface floor = shapes::plain_surface(shapes::plane(1, 1));
  const Camera camera = cameras::perspective(Vec3(0, 0, 0.2), Vec3(0, 0.5, 0.1), 0.3, 90, 200);
  const VisibleImage image = render_visible(floor, camera, 1, {}, 1);
  int covered = 0;
  for (std::size_t cell = 0; cell < image.triangle.size(); ++cell) {
    if (image.triangle[cell] == none) continue;
    ++covered;
    EXPECT_GE(image.depth[cell], 0.3 - 1e-9);
    EXPECT_LT(image.depth[cell], 1.2);
  }
  EXPECT_GT(covered, 1000);
  const Camera beyond = cameras::perspective(Vec3(0, 0, -2), Vec3(0, 0, -3), 0.3, 90, 200);
  for (const int triangle : render_visible(floor, beyond, 1, {}, 1).triangle) {
    EXPECT_EQ(triangle, none) << "all of it is behind the eye";
  }
}

TEST(VisibleImage, IsTheSameAtAnyThreadCount) {
  const Surface torus = shapes::torus_surface(1, 0.4, 60, 30);
  const Camera camera = cameras::perspective(Vec3(2, 1, 3), Vec3::Zero(), 0.1, 40, 333);
  const VisibleImage one = render_visible(torus, camera, 1.5, {}, 1);
  const VisibleImage many = render_visible(torus, camera, 1.5, {}, 7);
  EXPECT_EQ(one.width, 222);
  EXPECT_EQ(one.triangle, many.triangle);
  EXPECT_EQ(one.depth, many.depth);
}

TEST(VisibleImage, CellsAndBadSizes) {
  const Surface plane = shapes::plain_surface(shapes::plane(1, 1));
  const VisibleImage image =
      render_visible(plane, cameras::orthographic(Vec3::UnitZ(), 2, 10), 2, {}, 1);
  EXPECT_EQ(image.cell_of(Vec2(0, 0)), 0);
  EXPECT_EQ(image.cell_of(Vec2(9.9, 2.1)), 9);
  EXPECT_EQ(image.cell_of(Vec2(10, 5)), none);
  EXPECT_EQ(image.cell_of(Vec2(-0.1, 5)), none);
  EXPECT_EQ(image.cell_of(Vec2(std::nan(""), 5)), none);
  EXPECT_THROW(render_visible(plane, cameras::orthographic(Vec3::UnitZ(), 2, 10), 0, {}, 1),
               InvalidInput);
}

}  // namespace
}  // namespace illustrate
