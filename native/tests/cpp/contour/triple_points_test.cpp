#include "contour/intersection/triple_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "contour/contour_functions.h"
#include "contour/intersection/intersections.h"
#include "core/errors.h"
#include "core/pi.h"
#include "tests/cpp/blocks.h"

namespace illustrate {
namespace {

IntersectionCurves found_on(const Surface& surface) {
  Counts report;
  return intersections(surface, Bvh(surface.positions, surface.triangles), report);
}

Surface of_three(const PolygonMesh& a, const PolygonMesh& b, const PolygonMesh& c) {
  return shapes::joined(shapes::joined(shapes::plain_surface(a), shapes::plain_surface(b)),
                        shapes::plain_surface(c));
}

// Through the origin, which lies within one of its two triangles.
PolygonMesh turned_plane(const Eigen::Quaterniond& by) {
  PolygonMesh plane = shapes::plane(1, 1);
  for (Vec3& p : plane.positions) p = by * (p + Vec3(0.3, -0.2, 0));
  return plane;
}

TEST(TriplePoints, CurvesPassAlongTheNormalOrAgainstIt) {
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  const auto any_turn = [&] {
    return Eigen::Quaterniond(number(random), number(random), number(random), number(random))
        .normalized();
  };
  for (int scene = 0; scene < 50; ++scene) {
    const Surface surface =
        of_three(turned_plane(any_turn()), turned_plane(any_turn()), turned_plane(any_turn()));
    const IntersectionCurves curves = found_on(surface);
    ASSERT_EQ(curves.triple_points.size(), 1u);
    ASSERT_EQ(curves.triple_points[0].passages.size(), 3u);
    for (const Passage& p : curves.triple_points[0].passages) {
      const auto curve = curves.curves[idx(p.curve)];
      const Vec3 along = curve[idx(p.segment) + 1].position - curve[idx(p.segment)].position;
      EXPECT_EQ(p.along_normal, winding_normal(surface, p.through).dot(along) > 0);
    }
  }
}

// A block whose edges lie in a ground's plane: the curve runs straight through its triangles.
TEST(TriplePoints, AreNoneAlongAStraightCurve) {
  PolygonMesh ground = blocks::sharp(shapes::plane(3, 3));
  for (Vec3& p : ground.positions) p = 4 * p - Vec3(2, 2, 0);
  const PolygonMesh block = blocks::block(Vec3(0.9, -0.4, -0.3), Vec3(1.7, 0.4, 0.5));
  for (const auto& meshes : {std::vector<PolygonMesh>{ground, block}, {block, ground}}) {
    const auto prepared = blocks::prepared(meshes, 200'000);
    EXPECT_EQ(prepared->intersections().curves.size(), 1u);
    EXPECT_TRUE(prepared->intersections().triple_points.empty());
  }
}

// A shelf's end lies flush on a wall, up to rounding: its normals do not tell from which side the
// shelf's top comes through it.
TEST(TriplePoints, ACurveThatPassesASheetAgainComesBack) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> rounding(-1e-7, 1e-7);
  const Surface surface =
      of_three(shapes::plane(4, 4), shapes::height_field(1, 1, [](double, double y) { return y; }),
               shapes::height_field(32, 8, [&](double x, double y) {
                 return 1e-6 * (y + 0.5 * std::sin(8 * x)) + rounding(random);
               }));
  std::map<std::pair<int, int>, std::map<std::pair<int, double>, bool>> passages;
  for (const TriplePoint& point : found_on(surface).triple_points)
    for (const Passage& p : point.passages)
      passages[{p.curve, surface.object_of(p.through)}][{p.segment, p.fraction}] = p.along_normal;
  std::size_t most = 0;
  for (const auto& [curve, of_curve] : passages) {
    most = std::max(most, of_curve.size());
    for (auto p = of_curve.begin(), next = std::next(p); next != of_curve.end(); ++p, ++next)
      EXPECT_NE(p->second, next->second) << next->first.first;
  }
  EXPECT_GE(most, 5u);
}

PolygonMesh prism(int sides, const Eigen::Quaterniond& by) {
  PolygonMesh mesh;
  for (const double z : {0., 1.})
    for (int i = 0; i < sides; ++i)
      mesh.positions.push_back(by *
                               Vec3(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), z));
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    shapes::add_face(mesh, {i, next, sides + i});
    shapes::add_face(mesh, {next, sides + next, sides + i});
    if (i == 0 || next == 0) continue;
    shapes::add_face(mesh, {0, next, i});
    shapes::add_face(mesh, {sides, sides + i, sides + next});
  }
  return mesh;
}

// Walls of two prisms run in and out of each other, and their ends lie flush: a curve that runs
// over a corner, in one plane with what it lies on, crossed itself there as rounding had it.
TEST(TriplePoints, AreNotOfSheetsThatShareAVertex) {
  std::mt19937 random(7);
  std::normal_distribution<double> number;
  for (int scene = 0; scene < 20; ++scene) {
    const Eigen::Quaterniond by =
        Eigen::Quaterniond(number(random), number(random), number(random), number(random))
            .normalized();
    const Surface surface =
        shapes::joined(shapes::plain_surface(prism(24, by)), shapes::plain_surface(prism(36, by)));
    for (const TriplePoint& point : found_on(surface).triple_points) {
      for (const int v : surface.triangles[idx(point.passages[0].through)])
        for (const int w : surface.triangles[idx(point.passages[1].through)])
          EXPECT_NE(surface.places[idx(v)], surface.places[idx(w)]) << scene;
    }
  }
}

// A plane that folds over itself, cut by another: the curves of its layers are one, and rounding
// let them cross.
TEST(TriplePoints, AreNotOfLayersOfOnePlane) {
  PolygonMesh folded = shapes::plane(14, 6), wall = shapes::plane(3, 3);
  for (Vec3& p : folded.positions) p.x() = 0.4 + 0.3 * std::sin(9 * p.x()) + 0.1 * p.y();
  for (Vec3& p : wall.positions) p = Vec3(p.x(), 0.11 + 0.6 * p.x(), p.y() - 0.45);
  for (const double angle : {0., 0.7, 2.1}) {
    Surface layers = shapes::plain_surface(folded);
    for (Vec3& n : layers.normals) n = Vec3::UnitZ();
    Surface surface = shapes::joined(layers, shapes::plain_surface(wall));
    const Eigen::AngleAxisd by(angle, Vec3(1, 2, 3).normalized());
    for (Vec3& p : surface.positions) p = by * p + Vec3(5, -3, 2);
    for (Vec3& n : surface.normals) n = by * n;
    const IntersectionCurves found = found_on(surface);
    EXPECT_FALSE(found.curves.empty());
    EXPECT_EQ(found.triple_points.size(), 0u) << angle;
  }
}

// Pillars through one ground of two triangles, each pair overlapping at a corner.
Surface pairs_of_pillars(int rows) {
  PolygonMesh ground = shapes::plane(1, 1), pillars;
  for (Vec3& p : ground.positions) p = rows * (p + Vec3(0.01, 0.02, 0));
  for (int i = 0; i < rows * rows; ++i) {
    const Vec3 corner(i % rows + 0.3, i / rows + 0.3, 0);
    const Vec3 low(0.1, 0.13, 0.5), high(0.2, 0.24, 0.7), aside(0.11, 0.12, 0.1);
    pillars = shapes::joined(pillars, blocks::block(corner - low, corner + high));
    pillars = shapes::joined(pillars, blocks::block(corner - low + aside, corner + high + aside));
  }
  return shapes::joined(shapes::plain_surface(ground), shapes::plain_surface(pillars));
}

// The outlines of two rectangles that overlap at a corner cross twice.
TEST(TriplePoints, OfManyCurvesOnOneTriangleAreAllFound) {
  for (const int rows : {1, 20}) {
    const Surface surface = pairs_of_pillars(rows);
    const IntersectionCurves curves = found_on(surface);
    ASSERT_EQ(curves.triple_points.size(), idx(2 * rows * rows));
    for (const TriplePoint& point : curves.triple_points) {
      EXPECT_EQ(point.passages.size(), 3u);
      EXPECT_NEAR(point.position.z(), 0, 1e-9);
    }
  }
}

TEST(TriplePoints, TellHowFarTheyAreAndCanBeCancelled) {
  const Surface surface = pairs_of_pillars(3);
  const IntersectionCurves curves = found_on(surface);
  std::vector<double> told;
  const auto tell = [&](double fraction, const std::string&) {
    told.push_back(fraction);
    return true;
  };
  EXPECT_EQ(triple_points(surface, curves, Progress(tell, "")).size(), 18u);
  ASSERT_GE(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
  const Progress stop([](double, const std::string&) { return false; }, "");
  EXPECT_THROW(triple_points(surface, curves, stop), Cancelled);
}

}  // namespace
}  // namespace illustrate
