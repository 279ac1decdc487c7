#include "stroke/stroke_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

constexpr int size_px = 100;

Camera perspective_camera() {
  Mat4 projection = Mat4::Zero();
  projection(0, 0) = projection(1, 1) = 2;
  projection(2, 2) = -1.02;
  projection(2, 3) = -0.2;
  projection(3, 2) = -1;
  return {projection, Mat4::Identity(), size_px, size_px};
}

TEST(ClipAtFrame, WorldPointsFollowInPerspective) {
  const Camera camera = perspective_camera();
  StrokePath path;
  for (const Vec3& p : {Vec3(0, 0, -2), Vec3(9, 1, -7)}) {
    path.points.push_back({p, {}, camera.project(p).xy, 1});
  }
  const std::vector<StrokePath> parts = clip_at_frame(path, camera);
  ASSERT_EQ(parts.size(), 1U);
  const StrokePoint& cut = parts[0].points.back();
  EXPECT_NEAR(cut.image.x(), size_px, 1e-12);
  EXPECT_NEAR((camera.project(cut.position).xy - cut.image).norm(), 0, 1e-9);
}

double farthest_from(const std::vector<StrokePoint>& line, const Vec2& p) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i].image;
    const Vec2 chord = line[(i + 1) % line.size()].image - a;
    const double t = std::clamp((p - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * chord).norm());
  }
  return nearest;
}

TEST(Simplify, StaysWithinToleranceAndNeedsFewerPoints) {
  StrokePath path;
  path.closed = true;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2 * pi * i / 2000;
    const Vec2 p = Vec2(50, 50) + 40 * Vec2(std::cos(angle), std::sin(angle));
    path.points.push_back({Vec3::Zero(), {}, p, 1});
  }
  std::size_t last_count = 2000;
  for (const double tolerance : {0.01, 0.1, 1.0}) {
    const StrokePath simple = simplify(path, tolerance, 1);
    for (const StrokePoint& p : path.points) {
      EXPECT_LE(farthest_from(simple.points, p.image), tolerance + 1e-12);
    }
    // Chords of sagitta s on radius r span 2 sqrt(2 s / r); twice as many points are generous.
    const double fewest = pi / std::sqrt(2 * tolerance / 40);
    EXPECT_LE(static_cast<double>(simple.points.size()), 2 * fewest + 3);
    EXPECT_LT(simple.points.size(), last_count);
    last_count = simple.points.size();
  }
}

TEST(Simplify, KeepsEndsAndTriangles) {
  StrokePath line;
  for (const double x : {0.0, 1.0, 2.0, 3.0}) line.points.push_back({Vec3::Zero(), {}, {x, 0}, 1});
  EXPECT_EQ(simplify(line, 0.1, 1).points.size(), 2U);
  StrokePath loop = line;
  loop.closed = true;
  EXPECT_EQ(simplify(loop, 10, 1).points.size(), 3U);
}

// Straight in the image, a parabola in depth: points stay within five tolerances of it, in pixels
// of the world.
TEST(Simplify, KeepsTheDepthOfAStroke) {
  StrokePath path;
  for (int i = 0; i <= 100; ++i) {
    const double x = i, depth = 0.02 * (x - 50) * (x - 50);
    path.points.push_back({Vec3(x, 0, depth) * 0.01, {}, {x, 0}, 1});
  }
  const StrokePath simple = simplify(path, 0.1, 0.01);
  EXPECT_GT(simple.points.size(), 5U);
  EXPECT_LT(simple.points.size(), 40U);
}

}  // namespace
}  // namespace illustrate
