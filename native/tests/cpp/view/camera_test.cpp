#include <gtest/gtest.h>

#include <limits>

#include "core/errors.h"
#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

TEST(Camera, PerspectiveEyeIsAPoint) {
  const Vec3 eye(3, -4, 2);
  const Camera camera = cameras::perspective(eye, Vec3::Zero());
  ASSERT_TRUE(camera.is_perspective());
  EXPECT_LT((camera.viewpoint().head<3>() - eye).norm(), 1e-12);
  EXPECT_LT((camera.to_eye(Vec3(1, 1, 1)) - (eye - Vec3(1, 1, 1))).norm(), 1e-12);
}

TEST(Camera, OrthographicEyeIsADirection) {
  const Vec3 direction(1, -2, 0.5);
  const Camera camera = cameras::orthographic(direction, 2);
  ASSERT_FALSE(camera.is_perspective());
  EXPECT_LT((camera.to_eye(Vec3(5, 5, 5)) - direction.normalized()).norm(), 1e-12);
}

TEST(Camera, ProjectsTheTargetToTheCentre) {
  for (const Camera& camera : {cameras::perspective(Vec3(0, -5, 0), Vec3::Zero()),
                               cameras::orthographic(Vec3(0, -1, 0), 2)}) {
    EXPECT_LT((camera.project(Vec3::Zero()).xy - Vec2(500, 500)).norm(), 1e-9);
    EXPECT_LT(camera.project(Vec3(0, 0, 1)).xy.y(), 500) << "y is down";
    EXPECT_GT(camera.project(Vec3(1, 0, 0)).xy.x(), 500);
    EXPECT_LT(camera.project(Vec3(0, -1, 0)).depth, camera.project(Vec3::Zero()).depth);
  }
}

TEST(Camera, PixelSizeIsThatOfTheProjection) {
  for (const Camera& camera : {cameras::perspective(Vec3(0, -5, 1), Vec3::Zero()),
                               cameras::orthographic(Vec3(0, -1, 0.2), 2)}) {
    const Vec3 p(0.3, 0.2, -0.1), right = camera.view().row(0).head<3>();
    const double size = camera.pixel_size(p);
    EXPECT_NEAR((camera.project(p + size * right).xy - camera.project(p).xy).norm(), 1, 1e-9);
  }
}

TEST(Camera, UnitsScaleTheImageAlone) {
  for (const Camera& camera : {cameras::perspective(Vec3(0, -5, 1), Vec3::Zero()),
                               cameras::orthographic(Vec3(0, -1, 0.2), 2)}) {
    const Camera coarse = camera.in_units_of(4);
    const Vec3 p(0.3, 0.2, -0.1), along(1, 2, 3);
    EXPECT_EQ(coarse.project(p).xy, camera.project(p).xy / 4);
    EXPECT_EQ(coarse.project(p).depth, camera.project(p).depth);
    EXPECT_EQ(coarse.project_direction(p, along), camera.project_direction(p, along) / 4);
    EXPECT_EQ(coarse.pixel_size(p), 4 * camera.pixel_size(p));
    EXPECT_EQ(coarse.viewpoint(), camera.viewpoint());
  }
}

TEST(Camera, RaysEndAtTheNearPlane) {
  const Camera camera = cameras::perspective(Vec3(0, -5, 0), Vec3::Zero(), 1.5);
  const Vec3 p(0.5, 1, 0.25);
  const Vec3 end = p + camera.ray_end(p) * camera.to_eye(p);
  EXPECT_NEAR(camera.near_distance(end), 0, 1e-9);
  EXPECT_NEAR(end.y(), -3.5, 1e-9);
}

TEST(Camera, RefusesWhatIsNoCamera) {
  const Mat4 one = Mat4::Identity();
  EXPECT_THROW(Camera(Mat4::Zero(), one, 10, 10), InvalidInput);
  EXPECT_THROW(Camera(one, Mat4::Zero(), 10, 10), InvalidInput);
  EXPECT_THROW(Camera(one * std::numeric_limits<double>::quiet_NaN(), one, 10, 10), InvalidInput);
  EXPECT_THROW(Camera(one, one, 0, 10), InvalidInput);
  EXPECT_THROW(Camera(one, one, 10, -5), InvalidInput);
}

}  // namespace
}  // namespace illustrate
