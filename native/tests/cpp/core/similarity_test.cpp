#include "core/similarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

Similarity some_motion() {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  return {Eigen::AngleAxisd(2.1, axis).toRotationMatrix(), 1, Vec3(3, -1, 20)};
}

Points moved(Points points, const Similarity& motion) {
  for (Vec3& p : points) p = motion.point(p);
  return points;
}

void expect_near(const Similarity& a, const Similarity& b, double tolerance) {
  EXPECT_LT((a.rotation - b.rotation).norm(), tolerance);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_LT((a.translation - b.translation).norm(), 20 * tolerance);
}

TEST(Similarity, AndItsInverseAreNothing) {
  Similarity map = some_motion();
  map.scale = 2;
  const Points points = shapes::icosahedron().positions;
  const Points back = moved(moved(points, map), map.inverse());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((points[i] - back[i]).norm(), 1e-14);
}

TEST(Move, LeavesWhatRestsToTheBit) {
  const Vec3 p(-0.0, 3, -0.0);
  for (const Vec3& q : {Move({}).point(p), Move({}).direction(p)}) {
    EXPECT_TRUE(std::signbit(q.x()) && std::signbit(q.z()) && q == p);
  }
  EXPECT_EQ(Move(some_motion()).point(p), some_motion().point(p));
}

TEST(RigidMotion, IsFoundOfBodiesPlatesAndRods) {
  const Similarity motion = some_motion();
  const Points plate = shapes::plane(3, 2).positions;
  for (const Points& points : {shapes::torus_mesh(2, 1, 9, 7).positions, plate}) {
    const auto found = rigid_motion(points, moved(points, motion));
    ASSERT_TRUE(found);
    expect_near(*found, motion, 1e-13);
  }
  const Points rod{Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()};
  const auto found = rigid_motion(rod, moved(rod, motion));
  ASSERT_TRUE(found);
  for (const Vec3& p : rod) EXPECT_LT((found->point(p) - motion.point(p)).norm(), 1e-13);
}

TEST(RigidMotion, OfWhatRestsIsExactlyNone) {
  const Points points = shapes::torus_mesh(2, 1, 9, 7).positions;
  EXPECT_EQ(rigid_motion(points, points), Similarity());
}

// Matrices and positions in single precision.
TEST(RigidMotion, BearsSinglePrecision) {
  const Points points = shapes::torus_mesh(2, 1, 9, 7).positions;
  Points rounded = moved(points, some_motion());
  for (Vec3& p : rounded) p = p.cast<float>().cast<double>();
  const auto found = rigid_motion(points, rounded);
  ASSERT_TRUE(found);
  expect_near(*found, some_motion(), 1e-6);
}

TEST(RigidMotion, IsNoneOfWhatBendsGrowsOrIsMirrored) {
  const Points points = shapes::torus_mesh(2, 1, 9, 7).positions;
  Points bent = moved(points, some_motion());
  bent[10] += Vec3(1e-4, 0, 0);
  Points grown = points, mirrored = points, broken = points;
  for (Vec3& p : grown) p *= 1.0001;
  // Not one that its symmetry undoes.
  mirrored[5] = bent[5];
  const Points lopsided = mirrored;
  for (Vec3& p : mirrored) p.x() = -p.x();
  broken[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rigid_motion(points, bent));
  EXPECT_FALSE(rigid_motion(points, grown));
  EXPECT_FALSE(rigid_motion(lopsided, mirrored));
  EXPECT_FALSE(rigid_motion(points, broken));
  EXPECT_FALSE(rigid_motion(points, Points(points.begin(), points.end() - 1)));
}

}  // namespace
}  // namespace illustrate
