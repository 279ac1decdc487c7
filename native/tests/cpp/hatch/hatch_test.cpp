#include <gtest/gtest.h>

#include "hatch/greedy/neighbour_grid.h"
#include "hatch/view/critical_curves.h"
#include "hatch/view/image_lattice.h"
#include "hatch/view/walk.h"
#include "tests/cpp/hatch/hatch_scene.h"

namespace illustrate {
namespace {

using namespace hatching;

// Greatest drift in latitude of a walk of a quarter turn round a sphere of radius 1, 100 px a unit.
double drift_along_parallel(int level) {
  const Surface sphere = shapes::sphere_surface(1, level);
  const CrossField field = field_of(sphere, round_z);
  const Camera camera = cameras::orthographic(Vec3(0, -1, 0), 1.2, 240);
  const Walker walker(sphere, field, camera);
  const VisibleImage visible = render_visible(sphere, camera, 1, {}, 1);
  const Vec2 start = camera.project(Vec3(0, -1, 0.5)).xy;
  Walk walk = walker.start(
      surface_point_under(sphere, camera, visible.triangle[visible.cell_of(start)], start),
      Vec3::UnitX());
  const double z = walker.point(walk.on).position.z();
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(walker.advance(walk, 1), WalkEnd::whole);
    worst = std::max(worst, std::abs(walker.point(walk.on).position.z() - z));
  }
  EXPECT_NEAR(walker.point(walk.on).image.x() - start.x(), 60, 0.5) << "lengths are of the image";
  return worst;
}

TEST(Walk, FollowsTheCrossToSecondOrder) {
  const double coarse = drift_along_parallel(3), fine = drift_along_parallel(5);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 4);
}

TEST(Walk, EndsOnTheSilhouette) {
  const Surface sphere = shapes::sphere_surface(1, 4);
  const CrossField field = field_of(sphere, round_z);
  const Camera camera = cameras::orthographic(Vec3(0, -1, 0), 1.2, 240);
  const Walker walker(sphere, field, camera);
  const VisibleImage visible = render_visible(sphere, camera, 1, {}, 1);
  const Vec2 start = camera.project(Vec3(0, -1, 0.2)).xy;
  Walk walk = walker.start(
      surface_point_under(sphere, camera, visible.triangle[visible.cell_of(start)], start),
      Vec3::UnitX());
  WalkEnd end = WalkEnd::whole;
  for (int i = 0; i < 200 && end == WalkEnd::whole; ++i) end = walker.advance(walk, 1);
  EXPECT_EQ(end, WalkEnd::silhouette);
  EXPECT_NEAR(normal_at(sphere, walk.on).y(), 0, 1e-6);
}

TEST(Walk, StopsAtCreasesAndBoundaries) {
  Surface plane = shapes::plain_surface(shapes::plane(2, 2));
  const CrossField field = field_of(plane, [](const Vec3&) { return Vec3::UnitX(); });
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const auto walk_right = [&] {
    const Walker walker(plane, field, camera);
    const VisibleImage visible = render_visible(plane, camera, 1, {}, 1);
    const Vec2 start = camera.project(Vec3(-0.63, 0.31, 0)).xy;
    Walk walk = walker.start(
        surface_point_under(plane, camera, visible.triangle[visible.cell_of(start)], start),
        Vec3::UnitX());
    EXPECT_EQ(walker.advance(walk, 1000), WalkEnd::edge);
    EXPECT_NEAR(walker.point(walk.on).position.y(), 0.31, 1e-6);
    return walker.point(walk.on).position.x();
  };
  EXPECT_NEAR(walk_right(), 1, 1e-6);
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const double a = plane.positions[plane.triangles[t][k]].x();
      const double b = plane.positions[plane.triangles[t][next_corner(k)]].x();
      if (a == 0 && b == 0) plane.edge_kinds[t][k] = EdgeKind::crease;
    }
  }
  EXPECT_NEAR(walk_right(), 0, 1e-6);
}

// The right half wound the other way, as beyond the seam of a double cover.
TEST(Walk, CrossesTheSeamOfADoubleCover) {
  Surface plane = shapes::plain_surface(shapes::plane(8, 8));
  for (std::size_t t = 0; t < plane.triangles.size(); ++t) {
    Triangle& corner = plane.triangles[t];
    const double x = plane.positions[corner[0]].x() + plane.positions[corner[1]].x() +
                     plane.positions[corner[2]].x();
    if (x < 0) continue;
    std::swap(corner[1], corner[2]);
    plane.flips[t] = 7;
  }
  shapes::link_neighbours(plane);
  const CrossField field = field_of(plane, [](const Vec3&) { return Vec3(2, 1, 0); });
  const Camera camera = cameras::orthographic(Vec3::UnitZ(), 1, 200);
  const Walker walker(plane, field, camera);
  Walk walk = walker.start({0, 0.3, 0.3}, Vec3::UnitX());
  const Vec3 from = walker.point(walk.on).position;
  EXPECT_EQ(walker.advance(walk, 150), WalkEnd::whole);
  const Vec3 run = walker.point(walk.on).position - from;
  EXPECT_LT((run - 1.5 * Vec3(2, 1, 0).normalized()).norm(), 1e-5);
  EXPECT_EQ(walk.facing, -1);
}

// --- critical curves and neighbours

TEST(CriticalCurves, OnlyVisibleCriticalArcsSeparate) {
  Scene scene = plane_scene();
  scene.add_arc(Kind::crease,
                {Vec3(0, -1e6, 0), Vec3(0, 1, 0)});  // far out of the frame, column 120
  scene.add_arc(Kind::mark, {Vec3(0.5, -1, 0), Vec3(0.5, 1, 0)});
  scene.add_arc(Kind::silhouette, {Vec3(-0.5, -1, 0), Vec3(-0.5, 1, 0)});
  scene.graph.arcs[2].invisibility = 2;
  const CriticalCurves curves(scene.graph, 240, 240);
  EXPECT_NEAR(curves.first_crossing(Vec2(115, 100), Vec2(135, 108)), 0.25, 1e-6);
  EXPECT_FALSE(curves.separate(Vec2(115, 100), Vec2(119, 108)));
  EXPECT_FALSE(curves.separate(Vec2(160, 100), Vec2(180, 100))) << "marks do not count";
  EXPECT_FALSE(curves.separate(Vec2(60, 100), Vec2(80, 100))) << "nor do hidden silhouettes";
  EXPECT_FALSE(curves.separate(Vec2(115, 5), Vec2(125, 5))) << "it ends at y = 1, row 20";
}

TEST(NeighbourGrid, ParallelTestIsThePapers) {
  const Vec3 n = Vec3::UnitZ(), t = Vec3::UnitX();
  EXPECT_TRUE(are_parallel(t, n, -t));
  EXPECT_TRUE(are_parallel(t, n, Vec3(1, 0.99, 0)));
  EXPECT_FALSE(are_parallel(t, n, Vec3(1, 1.01, 0)));
  EXPECT_TRUE(are_parallel(t, n, Vec3(0.3, 0.1, 5))) << "after projection to the tangent plane";
  EXPECT_FALSE(are_parallel(t, n, n));
}

TEST(NeighbourGrid, FindsAllWithinTheRadius) {
  NeighbourGrid grid(100, 100, 8);
  int point = 0;
  for (double x = -5; x < 106; x += 3.7) {
    for (double y = -5; y < 106; y += 3.1) grid.add({Vec2(x, y), Vec3::UnitX(), point++});
  }
  int found = 0, expected = 0;
  grid.any_within(Vec2(33, 47), 15, [&](const HatchNode&) { return ++found < 0; });
  grid.any_within(Vec2(33, 47), 1000, [&](const HatchNode& node) {
    expected += (node.image - Vec2(33, 47)).norm() < 15;
    return false;
  });
  EXPECT_EQ(found, expected);
  EXPECT_GT(expected, 40);
}

// --- the lattice of the image

TEST(VisitLattice, VisitsEachSquareOnceAndSpreadsEvenly) {
  std::vector<Vec2> points;
  visit_lattice(50, 30, 2.5, [&](std::int64_t i, const Vec2& p) {
    EXPECT_EQ(i, static_cast<std::int64_t>(points.size()));
    points.push_back(p);
  });
  ASSERT_EQ(points.size(), 20U * 12U);
  std::array<int, 4> quarters{0, 0, 0, 0};
  for (std::size_t i = 0; i < 60; ++i) {
    ++quarters[(points[i].x() > 25 ? 1 : 0) + (points[i].y() > 15 ? 2 : 0)];
  }
  for (const int count : quarters) EXPECT_NEAR(count, 15, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(std::fmod(points[i].x(), 2.5), 1.25);
    EXPECT_TRUE(points[i].x() < 50 && points[i].y() < 30);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((points[i] - points[j]).norm(), 2);
  }
  visit_lattice(1, 30, 2.5, [](std::int64_t, const Vec2&) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace illustrate
