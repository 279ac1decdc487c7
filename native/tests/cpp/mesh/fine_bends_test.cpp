// Rounded edges that are finer than a drawing shows: one line each.
#include "mesh/fine_bends.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "mesh/sanitize.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

// As one drawn so that a line is `reach` wide.
PolygonMesh drawn(PolygonMesh mesh, double reach) {
  mesh.cage = false;
  mesh.crease_angle_deg = 30;
  mesh.edge_length = 2 * reach;
  return mesh;
}

std::int64_t fine_bends_of(const PolygonMesh& mesh) {
  Counts report;
  sanitize(mesh, report);
  return report.at("fine_bends");
}

// A profile (distance from the axis, height), counterclockwise, turned round the z axis.
PolygonMesh lathed(const std::vector<Vec2>& profile, int sides) {
  PolygonMesh mesh;
  const int n = static_cast<int>(profile.size());
  for (int k = 0; k < sides; ++k) {
    const double a = 2 * pi * k / sides;
    for (const Vec2& p : profile)
      mesh.positions.emplace_back(p.x() * std::cos(a), p.x() * std::sin(a), p.y());
  }
  for (int k = 0; k < sides; ++k) {
    const int from = n * k, to = n * ((k + 1) % sides);
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      shapes::add_face(mesh, {from + i, to + i, to + j, from + j});
    }
  }
  return mesh;
}

// A ring of square section, of which each edge is rounded off by so many strips.
PolygonMesh rounded_ring(double radius, int strips, int sides) {
  std::vector<Vec2> profile;
  for (int corner = 0; corner < 4; ++corner) {
    const double quarter = corner * pi / 2, side = 0.2 - radius;
    const Vec2 middle(std::cos(quarter + pi / 4), std::sin(quarter + pi / 4));
    for (int s = 0; s <= strips; ++s) {
      const double a = quarter + s * pi / 2 / strips;
      profile.push_back(Vec2(1, 0) + side * std::sqrt(2) * middle +
                        radius * Vec2(std::cos(a), std::sin(a)));
    }
  }
  return lathed(profile, sides);
}

TEST(FineBends, AreOneLineForEachRoundedEdge) {
  for (const int strips : {4, 5, 7, 8}) {
    const PolygonMesh ring = rounded_ring(.01, strips, 48);
    EXPECT_EQ(fine_bends_of(drawn(ring, .02)), 4 * 48) << strips;
    EXPECT_EQ(fine_bends_of(drawn(ring, .002)), 0) << strips << ", seen as round";
  }
}

// Of an odd number of strips none is in the middle, but two edges are.
TEST(FineBends, AreClosedWhereTheEdgeIs) {
  for (const int strips : {4, 5, 7, 8}) {
    Counts report;
    const SoundMesh sound = sanitize(drawn(rounded_ring(.01, strips, 48), .02), report);
    std::map<int, int> ends;
    for (const Edge& edge : sound.edge_vertices)
      for (const int v : edge) ++ends[v];
    EXPECT_EQ(ends.size(), 4 * 48U) << strips;
    for (const auto& [vertex, count] : ends) EXPECT_EQ(count, 2) << strips;
  }
}

TEST(FineBends, AreToldOfNoCageAndOfNoMeshWithoutASize) {
  PolygonMesh ring = drawn(rounded_ring(.01, 4, 48), .02);
  ring.edge_length = {};
  EXPECT_EQ(fine_bends_of(ring), 0);
  ring = drawn(rounded_ring(.01, 4, 48), .02);
  ring.cage = true;
  EXPECT_EQ(fine_bends_of(ring), 0);
}

// A wire turns by 360 degrees, a sheet's rounded rim by 180.
TEST(FineBends, AreNoneOfWiresAndRims) {
  std::vector<Vec2> wire, sheet;
  for (int k = 0; k < 16; ++k)
    wire.emplace_back(1 + .01 * std::cos(k * pi / 8), .01 * std::sin(k * pi / 8));
  for (int k = 0; k <= 12; ++k)
    sheet.emplace_back(1 + .01 * std::sin(k * pi / 12), -.01 * std::cos(k * pi / 12));
  sheet.emplace_back(.3, .01);
  sheet.emplace_back(.3, -.01);
  EXPECT_EQ(fine_bends_of(drawn(lathed(wire, 48), .05)), 0);
  EXPECT_EQ(fine_bends_of(drawn(lathed(sheet, 48), .05)), 0);
}

// Ground with small waves, whose quads are as long as they are wide; and a noisy ball.
TEST(FineBends, AreNoneOfAScan) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 1);
  PolygonMesh ground = shapes::plane(40, 40), ball = shapes::icosphere_mesh(1, 5);
  for (Vec3& p : ground.positions) {
    p *= 20;  // quads of 1
    p.z() = .35 * std::sin(1.1 * p.x()) + .02 * noise(random);
  }
  for (Vec3& p : ball.positions) p *= 1 + .004 * noise(random);
  for (const double edges : {1., 2., 3., 5.}) {
    EXPECT_EQ(fine_bends_of(drawn(ground, edges)), 0) << edges;
    EXPECT_EQ(fine_bends_of(drawn(ball, .035 * edges)), 0) << edges;
  }
}

}  // namespace
}  // namespace illustrate
