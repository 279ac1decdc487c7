#include "contour/intersection/flush.h"

#include <gtest/gtest.h>

#include "tests/cpp/blocks.h"
#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

PolygonMesh turned(PolygonMesh mesh, const Eigen::Quaterniond& by) {
  for (Vec3& p : mesh.positions) p = by * p;
  return mesh;
}

// Of all flush edges, world units.
double flush_length(const std::vector<PolygonMesh>& meshes) {
  const auto prepared = blocks::prepared(meshes);
  const Surface& surface = prepared->surface();
  double length = 0;
  for (const FlushEdge& edge : prepared->intersections().flush_edges) {
    const Triangle& corners = surface.triangles[idx(edge.side.triangle)];
    const Vec3& start = surface.positions[idx(corners[idx(edge.side.corner)])];
    const Vec3& end = surface.positions[idx(corners[idx(next_corner(edge.side.corner))])];
    length += (edge.to - edge.from) * (end - start).norm();
  }
  return length;
}

const PolygonMesh slab = blocks::block(Vec3(-2, -2, -1), Vec3(2, 2, 0));

void expect_length(const PolygonMesh& other, double expected) {
  const Eigen::Quaterniond askew = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
  for (const auto& turn : {Eigen::Quaterniond::Identity(), askew}) {
    const PolygonMesh a = turned(slab, turn), b = turned(other, turn);
    EXPECT_NEAR(flush_length({a, b}), expected, 1e-3);
    EXPECT_NEAR(flush_length({b, a}), expected, 1e-3);
  }
}

TEST(FlushEdges, OfABlockWithinASlabAreThoseOfItsTop) {
  expect_length(blocks::block(Vec3(-0.5, -0.5, -0.7), Vec3(0.5, 0.5, 0)), 4);
}

// Two edges of the block as far as the slab, the third wholly, and the slab's as far as the block.
TEST(FlushEdges, EndWhereTheOtherFaceEnds) {
  expect_length(blocks::block(Vec3(1.2, -0.5, -0.7), Vec3(2.5, 0.5, 0)), 0.8 + 0.8 + 1 + 1);
}

TEST(FlushEdges, AreNotTheSeamsOfBlocksThatAbut) {
  expect_length(blocks::block(Vec3(2, -2, -1), Vec3(4, 2, 0)), 0);
  expect_length(blocks::block(Vec3(2, -0.5, -0.7), Vec3(3, 0.5, 0)), 0);
}

// Of a block that is flush with two faces of the slab, the edge that both have is none.
TEST(FlushEdges, AreNotWhereBothFacesEnd) {
  expect_length(blocks::block(Vec3(0, -0.5, -0.7), Vec3(2, 0.5, 0)), (2 + 2 + 1) + (0.7 + 0.7 + 1));
}

// Over the seam of two slabs that abut, in one plane with both: from end to end, not in two.
TEST(FlushEdges, OfABlockWithinTwoSlabsAreWhole) {
  const PolygonMesh left = blocks::block(Vec3(-2, -2, -1), Vec3(0, 2, 0));
  const PolygonMesh right = blocks::block(Vec3(0, -2, -1), Vec3(2, 2, 0));
  const PolygonMesh block = blocks::block(Vec3(-0.5, -0.5, -0.7), Vec3(0.5, 0.5, 0));
  const Eigen::Quaterniond askew = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
  for (const auto& turn : {Eigen::Quaterniond::Identity(), askew}) {
    std::vector<PolygonMesh> meshes{left, right, block};
    for (PolygonMesh& mesh : meshes) mesh = turned(mesh, turn);
    const auto prepared = blocks::prepared(meshes);
    double of_block = 0;
    for (const FlushEdge& edge : prepared->intersections().flush_edges) {
      if (prepared->surface().triangle_objects[idx(edge.side.triangle)] != 2) continue;
      EXPECT_EQ(edge.from, 0);
      EXPECT_EQ(edge.to, 1);
      ++of_block;
    }
    EXPECT_GE(of_block, 4);
  }
}

TEST(FlushEdges, AreNotOfFacesThatFaceEachOther) {
  expect_length(blocks::block(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1)), 0);
}

// An angle whose flat leg lies in the slab: along the standing leg its top rises from the plane.
TEST(FlushEdges, AreNotWhereTheSurfaceRises) {
  const PolygonMesh angle = blocks::sharp(shapes::polygon_mesh({{0, 0, -0.5},
                                                                {1, 0, -0.5},
                                                                {1, 0, 0},
                                                                {0.2, 0, 0},
                                                                {0.2, 0, 1},
                                                                {0, 0, 1},
                                                                {0, 1, -0.5},
                                                                {1, 1, -0.5},
                                                                {1, 1, 0},
                                                                {0.2, 1, 0},
                                                                {0.2, 1, 1},
                                                                {0, 1, 1}},
                                                               {{0, 1, 2, 3, 4, 5},
                                                                {11, 10, 9, 8, 7, 6},
                                                                {0, 6, 7, 1},
                                                                {1, 7, 8, 2},
                                                                {2, 8, 9, 3},
                                                                {3, 9, 10, 4},
                                                                {4, 10, 11, 5},
                                                                {5, 11, 6, 0}}));
  expect_length(angle, 0.8 + 0.8 + 1);
}

// Bars that lie across each other at angles of no lattice, all tops in one plane.
std::vector<PolygonMesh> crossed_bars(const Eigen::Quaterniond& askew) {
  std::vector<PolygonMesh> bars;
  for (int i = 0; i < 4; ++i) {
    const double depth = 0.5 + 0.2 * i, place = 0.37 * i - 0.5;
    const PolygonMesh bar = blocks::block(Vec3(-2, place, -depth), Vec3(2, place + 0.3, 0));
    const Eigen::Quaterniond about(Eigen::AngleAxisd(0.4 + 0.8 * i, Vec3::UnitZ()));
    bars.push_back(turned(bar, askew * about));
  }
  return bars;
}

// An edge that pierces another bar beside an edge of that, and the intersection that starts there,
// are nearer to each other than the image tells apart.
TEST(FlushEdges, MeetInJointsWhereBarsOfOnePlaneCross) {
  const Eigen::Quaterniond askew = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
  const auto prepared = blocks::prepared(crossed_bars(askew));
  DrawOptions options;
  options.hatching = false;
  std::int64_t nodes = 0;
  for (int view = 0; view < 40; ++view) {
    const double turn = 2.4 * view, height = 0.9 - 0.04 * view;
    const Vec3 direction(std::cos(turn), std::sin(turn), height);
    const DrawResult drawn = draw(*prepared, cameras::orthographic(direction, 3), options, {});
    EXPECT_EQ(drawn.counts.at("repairs"), 0) << view;
    nodes += drawn.counts.at("crossings");
  }
  EXPECT_GT(nodes, 1000);
}

}  // namespace
}  // namespace illustrate
