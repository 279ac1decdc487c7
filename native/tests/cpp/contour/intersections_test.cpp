#include "contour/intersection/intersections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "contour/intersection/crossing_test.h"
#include "core/errors.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

struct Found {
  IntersectionCurves curves;
  Counts report;

  std::size_t count() const { return curves.curves.size(); }
  std::size_t count_closed() const {
    return static_cast<std::size_t>(std::count(curves.closed.begin(), curves.closed.end(), 1));
  }
};

Vec3 point_on(const Surface& surface, const SurfacePoint& p) {
  const Triangle& t = surface.triangles[p.triangle];
  return surface.positions[t[0]] * (1 - p.b1 - p.b2) + surface.positions[t[1]] * p.b1 +
         surface.positions[t[2]] * p.b2;
}

void check_point(const Surface& surface, const IntersectionPoint& point, double tolerance) {
  for (const SurfacePoint& on : {point.a, point.b}) {
    ASSERT_GE(on.triangle, 0);
    EXPECT_GE(on.b1, 0);
    EXPECT_GE(on.b2, 0);
    EXPECT_LE(on.b1 + on.b2, 1 + 1e-15);
    EXPECT_LE((point_on(surface, on) - point.position).norm(), tolerance * surface.diagonal);
  }
}

// Consecutive segments share one triangle, on the same sheet; segments are as long as the contract
// says.
void check_curve(const Found& found, std::size_t c) {
  const auto first = static_cast<std::size_t>(found.curves.curves.offsets[c]);
  const std::size_t size = found.curves.curves[c].size();
  const bool closed = found.curves.closed[c] != 0;
  ASSERT_GE(size, closed ? 3u : 2u);
  for (std::size_t i = 0; i < size; ++i) {
    const auto& pair = found.curves.segment_triangles[first + i];
    const IntersectionPoint& point = found.curves.curves[c][i];
    if (!closed && i + 1 == size) {
      EXPECT_EQ(pair, (std::array<int, 2>{none, none}));
      continue;
    }
    EXPECT_EQ(pair, (std::array<int, 2>{point.a.triangle, point.b.triangle}));
    if (i == 0) continue;
    const auto& before = found.curves.segment_triangles[first + i - 1];
    EXPECT_NE(pair[0] == before[0], pair[1] == before[1]);
  }
}

// tolerance: of points on both sheets, relative to the diagonal; where sheets touch it is that of
// the inset.
Found find(const Surface& surface, double tolerance = 1e-9) {
  Found found;
  const Bvh bvh(surface.positions, surface.triangles);
  found.curves = intersections(surface, bvh, found.report);
  EXPECT_EQ(found.curves.closed.size(), found.count());
  EXPECT_EQ(found.curves.segment_triangles.size(), found.curves.curves.values.size());
  EXPECT_EQ(found.report.at("intersection_curves"), static_cast<int>(found.count()));
  for (const IntersectionPoint& point : found.curves.curves.values)
    check_point(surface, point, tolerance);
  for (std::size_t c = 0; c < found.count(); ++c) check_curve(found, c);
  return found;
}

constexpr double touching = 1e-5;

double length(const Found& found, std::size_t c) {
  const auto curve = found.curves.curves[c];
  double sum = 0;
  for (std::size_t i = 0; i + (found.curves.closed[c] ? 0 : 1) < curve.size(); ++i)
    sum += (curve[(i + 1) % curve.size()].position - curve[i].position).norm();
  return sum;
}

void expect_nothing(const Surface& surface) {
  const Found found = find(surface);
  EXPECT_EQ(found.count(), 0u);
  EXPECT_EQ(found.report.at("intersection_ties"), 0);
}

// A cube as `refine` makes it of one whose edges are creases: a vertex for each side of each
// corner. n: a power of two, so that the sides' points are equal.
Surface sharp_cube(const Vec3& centre, int n = 1) {
  Surface cube;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec3 normal = Vec3::Zero();
      normal[axis] = sign;
      const Vec3 u = Vec3::Unit(next_corner(axis)) * sign, v = Vec3::Unit(previous_corner(axis));
      PolygonMesh side = shapes::plane(n, n);
      for (Vec3& p : side.positions) p = centre + normal + p.x() * u + p.y() * v;
      const Surface face = shapes::plain_surface(side);
      const int first = static_cast<int>(cube.positions.size());
      shapes::append(cube.positions, face.positions);
      cube.normals.resize(cube.positions.size(), normal);
      for (const Triangle& t : face.triangles)
        cube.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  shapes::complete(cube);
  std::map<std::array<double, 3>, int> places;
  for (std::size_t v = 0; v < cube.positions.size(); ++v) {
    const Vec3& p = cube.positions[v];
    cube.places[v] =
        places.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(places.size())).first->second;
  }
  shapes::link_neighbours(cube);
  return cube;
}

Surface plane_surface(int n, double scale, double z) {
  PolygonMesh mesh = shapes::plane(n, n);
  for (Vec3& p : mesh.positions) p = Vec3(p.x() * scale, p.y() * scale, z);
  return shapes::plain_surface(mesh);
}

TEST(Intersections, EmbeddedSurfacesHaveNone) {
  expect_nothing(Surface{});
  expect_nothing(shapes::torus_surface(3, 1, 40, 20));
  expect_nothing(shapes::sphere_surface(1, 3));
  expect_nothing(plane_surface(20, 1, 0));
  expect_nothing(sharp_cube({0, 0, 0}, 8));
  expect_nothing(shapes::joined(shapes::sphere_surface(1, 3), shapes::sphere_surface(0.9, 3)));
}

TEST(Intersections, RotatedFlatSurfacesHaveNone) {
  Surface plane = plane_surface(40, 1, 0.3);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : plane.positions) p = turn * p;
  expect_nothing(plane);
}

// A limit may fold over itself within its plane; rounding is not to say that it crosses there.
TEST(Intersections, AFoldWithinAPlaneCrossesNothing) {
  Surface plane = plane_surface(16, 1, 0);
  for (std::size_t v = 0; v < plane.positions.size(); v += 7)
    plane.positions[v] += Vec3(0.21, 0.13, 0);
  expect_nothing(plane);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : plane.positions) p = turn * p + Vec3(5, -3, 2);
  for (Vec3& n : plane.normals) n = turn * n;
  expect_nothing(plane);
}

// Points of one plane that are moved along one normal stay in one, and some of the others are moved
// the other way.
TEST(Intersections, OfAFoldWithinAPlaneDoNotDependOnWhereItIs) {
  Surface plane = plane_surface(16, 1, 0);
  for (std::size_t v = 0; v < plane.positions.size(); v += 7)
    plane.positions[v] += Vec3(0.21, 0.13, 0);
  for (std::size_t v = 0; v < plane.normals.size(); v += 5) plane.normals[v] = -plane.normals[v];
  const Found expected = find(plane, touching);
  EXPECT_GT(expected.count(), 0u);
  for (const double angle : {0., 0.7, 2.1}) {
    const Eigen::AngleAxisd by(angle, Vec3(1, 2, 3).normalized());
    Surface there = plane;
    for (Vec3& p : there.positions) p = by * p + Vec3(-4, 9, 7);
    for (Vec3& n : there.normals) n = by * n;
    const Found found = find(there, touching);
    EXPECT_EQ(found.curves.segment_triangles, expected.curves.segment_triangles) << angle;
  }
}

TEST(Intersections, CrossingSpheresMeetInOneCircle) {
  double last_error = 0;
  for (const int level : {2, 3, 4, 5}) {
    const Found found = find(shapes::joined(shapes::sphere_surface(1, level),
                                            shapes::sphere_surface(1, level, {1.2, 0.1, 0.05})));
    ASSERT_EQ(found.count(), 1u);
    EXPECT_TRUE(found.curves.closed[0]);
    EXPECT_EQ(found.report.at("intersection_ties"), 0);
    const double radius = std::sqrt(1 - Vec3(1.2, 0.1, 0.05).squaredNorm() / 4);
    const double error = std::abs(length(found, 0) - 2 * pi * radius);
    if (last_error > 0) {
      EXPECT_LT(error, last_error / 3);
    }
    last_error = error;
  }
}

TEST(Intersections, MirroredSpheresMeetThoughTheirPointsCoincide) {
  // Mirror images in a plane through vertices of both: the circle is all ties.
  Surface a = shapes::sphere_surface(1, 3), b = a;
  for (Vec3& p : a.positions) p.x() -= 0.5;
  for (std::size_t v = 0; v < b.positions.size(); ++v) {
    b.positions[v] = a.positions[v].cwiseProduct(Vec3(-1, 1, 1));
    b.normals[v].x() = -b.normals[v].x();
  }
  for (Triangle& t : b.triangles) std::swap(t[1], t[2]);
  const Found found = find(shapes::joined(a, b));
  ASSERT_EQ(found.count(), 1u);
  EXPECT_TRUE(found.curves.closed[0]);
  EXPECT_NEAR(length(found, 0), 2 * pi * std::sqrt(0.75), 0.1);
}

TEST(Intersections, KleinBottleCrossesItselfAlongACircle) {
  for (const int n : {15, 16, 31, 32}) {
    const Found found = find(shapes::plain_surface(shapes::klein_mesh(24, n)));
    ASSERT_EQ(found.count(), 1u) << n;
    EXPECT_TRUE(found.curves.closed[0]);
    EXPECT_NEAR(length(found, 0), 2 * pi * 2, 0.5);
  }
}

TEST(Intersections, CrossingSheetsMeetInAnOpenCurve) {
  Surface upright = plane_surface(7, 1, 0);
  for (std::size_t v = 0; v < upright.positions.size(); ++v) {
    upright.positions[v] = {upright.positions[v].z() + 0.01, upright.positions[v].x(),
                            upright.positions[v].y()};
    upright.normals[v] = Vec3::UnitX();
  }
  const Found found = find(shapes::joined(plane_surface(9, 2, 0.02), upright));
  ASSERT_EQ(found.count(), 1u);
  EXPECT_FALSE(found.curves.closed[0]);
  EXPECT_DOUBLE_EQ(length(found, 0), 2);
}

TEST(Intersections, ACubeOnTheFloorOnlyTouches) {
  for (const int n : {1, 4}) {
    expect_nothing(shapes::joined(plane_surface(6, 3, -1), sharp_cube({0, 0, 0}, n)));
    expect_nothing(shapes::joined(sharp_cube({0, 0, 0}, n), plane_surface(5, 3, -1)));
    expect_nothing(shapes::joined(sharp_cube({0, 0, 0}, n), sharp_cube({1, 1, 2}, n)));
    expect_nothing(shapes::joined(sharp_cube({0, 0, 0}, n), sharp_cube({0, 0, 2}, n)));
  }
}

// Turned, and rounded to single precision as a modelling program stores it.
Surface turned_and_rounded(Surface surface, double angle_rad) {
  const Eigen::AngleAxisd turn(angle_rad, Vec3(1, 2, 3).normalized());
  for (Vec3& p : surface.positions) p = (turn * p).cast<float>().cast<double>();
  for (Vec3& n : surface.normals) n = turn * n;
  return surface;
}

TEST(Intersections, TouchingUpToSinglePrecisionIsNotCrossing) {
  for (const double angle : {0.1, 0.5, 0.7, 1.1, 2.0, 2.9}) {
    const Surface floor = plane_surface(16, 3, -1);
    expect_nothing(turned_and_rounded(shapes::joined(floor, sharp_cube({0, 0, 0}, 8)), angle));
    expect_nothing(turned_and_rounded(
        shapes::joined(sharp_cube({0, 0, 0}, 8), sharp_cube({1, 0, 2}, 8)), angle));
  }
}

TEST(Intersections, ASunkenCubeHasOneLoop) {
  const Found found = find(shapes::joined(plane_surface(6, 3, -0.5), sharp_cube({0, 0, 0}, 4)));
  ASSERT_EQ(found.count(), 1u);
  EXPECT_TRUE(found.curves.closed[0]);
  EXPECT_NEAR(length(found, 0), 8, 1e-12);
}

TEST(Intersections, CubesWithCoplanarSidesMeetInOneLoopWithoutDoubleLines) {
  for (const int n : {1, 4}) {
    const Found found = find(shapes::joined(sharp_cube({0, 0, 0}, n), sharp_cube({1, 0, 0}, n)));
    ASSERT_EQ(found.count(), 1u) << n;
    EXPECT_NEAR(length(found, 0), 8, 1e-12);
  }
}

TEST(Intersections, CopiesAtTheSamePlaceHaveNone) {
  expect_nothing(shapes::joined(shapes::sphere_surface(1, 3), shapes::sphere_surface(1, 3)));
  expect_nothing(shapes::joined(sharp_cube({0, 0, 0}, 4), sharp_cube({0, 0, 0}, 4)));
  expect_nothing(shapes::joined(sharp_cube({0, 0, 0}, 2), sharp_cube({0, 0, 0}, 8)));
}

TEST(Intersections, CurvesDoNotDependOnTheScale) {
  const Surface small =
      shapes::joined(shapes::sphere_surface(1, 2), shapes::sphere_surface(1, 2, {1, 0, 0}));
  const Found expected = find(small);
  for (const double scale : {0x1p-100, 0x1p100}) {
    Surface scaled = small;
    for (Vec3& p : scaled.positions) p *= scale;
    scaled.diagonal *= scale;
    const Found found = find(scaled);
    EXPECT_EQ(found.curves.segment_triangles, expected.curves.segment_triangles);
  }
}

// Tetrahedra with corners on a small lattice touch in every way. Where no two faces are coplanar,
// all curves close.
TEST(Intersections, LatticeTetrahedraNeverLeaveLooseEndsOrTies) {
  std::mt19937 random(7);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::size_t curves = 0, open = 0;
  for (int i = 0; i < 3000; ++i) {
    PolygonMesh tetrahedra[2];
    for (PolygonMesh& mesh : tetrahedra) {
      double volume = 0;
      do {
        mesh = shapes::tetrahedron();
        for (Vec3& p : mesh.positions) p = Vec3(below(5), below(5), below(5));
        const auto& p = mesh.positions;
        volume = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[0] - p[3]);
      } while (volume == 0);
      if (volume < 0) mesh = shapes::turned(mesh);
    }
    const Found found = find(
        shapes::joined(shapes::plain_surface(tetrahedra[0]), shapes::plain_surface(tetrahedra[1])),
        touching);
    EXPECT_EQ(found.report.at("intersection_ties"), 0);
    curves += found.count();
    open += found.count() - found.count_closed();
  }
  EXPECT_GT(curves, 500u);
  EXPECT_LT(open, curves / 20);  // coplanar faces
}

// A far vertex makes the rounding of coordinates larger than the detail: the work must stay in
// proportion.
TEST(Intersections, OneFarVertexDoesNotMakeEveryBoxANeighbour) {
  for (const double far : {1e3, 1e6, 3e38}) {
    Surface sphere = shapes::sphere_surface(1, 4);
    sphere.positions[0] = Vec3(far, 0, 0);
    const Bvh bvh(sphere.positions, sphere.triangles);
    std::size_t pairs = 0;
    bvh.overlapping_pairs([&](int, int) { ++pairs; }, CrossingTest(sphere).reach());
    EXPECT_LT(pairs, 20 * sphere.triangles.size()) << far;
  }
}

TEST(Intersections, SameInputSameBytes) {
  const Surface surface = shapes::plain_surface(shapes::klein_mesh(24, 16));
  const Found a = find(surface), b = find(surface);
  ASSERT_EQ(a.curves.curves.values.size(), b.curves.curves.values.size());
  for (std::size_t i = 0; i < a.curves.curves.values.size(); ++i)
    EXPECT_EQ(a.curves.curves.values[i].position, b.curves.curves.values[i].position);
  EXPECT_EQ(a.curves.segment_triangles, b.curves.segment_triangles);
}

TEST(Intersections, SoupsOfDegenerateTrianglesAreHarmless) {
  std::mt19937 random(9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 200; ++i) {
    PolygonMesh soup;
    for (int v = 0; v < 30; ++v)
      soup.positions.emplace_back(random() % 4, random() % 4, random() % 3);
    if (i % 2) soup.positions[0] = {nan, 0, 0};
    if (i % 3 == 0) soup.positions[1] = {1e140, 1e140, 1e-140};
    for (int f = 0; f < 40; ++f)
      shapes::add_face(soup, {static_cast<int>(random() % 30), static_cast<int>(random() % 30),
                              static_cast<int>(random() % 30)});
    const Surface surface = shapes::plain_surface(soup);
    Counts report;
    const IntersectionCurves curves =
        intersections(surface, Bvh(surface.positions, surface.triangles), report);
    for (const IntersectionPoint& point : curves.curves.values)
      EXPECT_TRUE(point.position.allFinite());
  }
}

// Two spheres through each other, and a small one through the first.
TEST(Intersections, OfWhatCrossesMostAreLeftOutWhereThereAreTooMany) {
  const Surface crossing = shapes::joined(
      shapes::joined(shapes::sphere_surface(1, 4), shapes::sphere_surface(1, 4, Vec3(.3, .2, .1))),
      shapes::sphere_surface(.2, 1, Vec3(-1, 0, 0)));
  const Bvh bvh(crossing.positions, crossing.triangles);
  Counts all, few, none_left;
  const IntersectionCurves whole = intersections(crossing, bvh, all);
  EXPECT_TRUE(whole.left_out.empty());
  EXPECT_EQ(whole.curves.size(), 2U);
  const auto segments = static_cast<std::int64_t>(whole.curves.values.size());
  EXPECT_TRUE(intersections(crossing, bvh, all, {}, segments).left_out.empty());
  const IntersectionCurves part = intersections(crossing, bvh, few, {}, segments - 1);
  EXPECT_EQ(part.left_out, (std::vector<ObjectPair>{{0, 1}}));
  EXPECT_EQ(few["intersections_left_out"], 1);
  ASSERT_EQ(part.curves.size(), 1U);
  EXPECT_LT(part.curves[0].front().position.x(), -.7);
  const IntersectionCurves empty = intersections(crossing, bvh, none_left, {}, 0);
  EXPECT_EQ(empty.left_out, (std::vector<ObjectPair>{{0, 1}, {0, 2}}));
  EXPECT_TRUE(empty.curves.empty());
}

TEST(Intersections, CanBeCancelled) {
  const Surface surface = shapes::torus_surface(3, 1, 200, 100);
  const Bvh bvh(surface.positions, surface.triangles);
  Counts report;
  const Progress progress([](double, const std::string&) { return false; }, "intersections");
  EXPECT_THROW(intersections(surface, bvh, report, progress), Cancelled);
}

}  // namespace
}  // namespace illustrate
