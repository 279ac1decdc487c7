#include "visibility/arrangement/arrangement.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"

namespace illustrate {
namespace {

const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);  // a world unit is a pixel

// Two closed contours that cross twice, the first one in front, and an open path of two strands
// with a cusp between them, far from both.
CurveNetwork two_squares_and_a_path() {
  CurveNetwork network;
  const auto add = [&](const Points& points, int start_node, int end_node) {
    for (const Vec3& p : points) network.points.push({p, {}});
    network.points.close_list();
    network.strands.push_back({Kind::silhouette, 0, start_node, end_node, 2, 0});
  };
  add({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}}, none, none);
  add({{10, 5, -1}, {30, 5, -1}, {30, 15, -1}, {10, 15, -1}}, none, none);
  const Points places{{100, 0, 0}, {120, 0, 0}, {140, 10, 0}};
  for (const Vec3& p : places) network.nodes.push_back({NodeKind::end, p});
  network.nodes[1].kind = NodeKind::cusp;
  add({places[0], places[1]}, 0, 1);
  add({places[1], places[2]}, 1, 2);
  network.ties = {{1, 2, 3, 1}};
  return network;
}

TEST(Arrangement, VisitsRunAlongStrandsAndPathsThroughTies) {
  const CurveNetwork network = two_squares_and_a_path();
  const Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings().size(), 2U);
  EXPECT_EQ(arrangement.live_crossings(), 2);
  EXPECT_EQ(arrangement.loops(), 2);
  for (const int strand : {0, 1}) {
    ASSERT_EQ(arrangement.visits(strand).size(), 2U);
    for (const Visit& visit : arrangement.visits(strand)) EXPECT_EQ(visit.front, strand == 0);
  }
  ASSERT_EQ(arrangement.paths().size(), 3U);
  EXPECT_EQ(arrangement.paths()[2].strands, (std::vector<int>{2, 3}));
  EXPECT_EQ(arrangement.paths()[2].jumps, (std::vector<int>{0, 1}));
}

TEST(Arrangement, WhatIsDroppedNobodyVisitsAndWhatIsDemotedOnlyItsBackStrand) {
  const CurveNetwork network = two_squares_and_a_path();
  Arrangement arrangement = arrange(network, one_px);
  arrangement.drop({0});
  EXPECT_FALSE(arrangement.is_live(0));
  for (const int strand : {0, 1}) {
    ASSERT_EQ(arrangement.visits(strand).size(), 1U);
    EXPECT_EQ(arrangement.visits(strand)[0].crossing, 1);
  }
  arrangement.demote({1});
  EXPECT_EQ(arrangement.state(1), CrossingState::demoted);
  EXPECT_TRUE(arrangement.visits(0).empty());
  EXPECT_EQ(arrangement.visits(1).size(), 1U);
  EXPECT_EQ(arrangement.live_crossings(), 0);
}

TEST(Arrangement, JumpsAreTurnedAndDropped) {
  const CurveNetwork network = two_squares_and_a_path();
  Arrangement arrangement = arrange(network, one_px);
  arrangement.turn_jump(2, 1);
  EXPECT_EQ(arrangement.paths()[2].jumps[1], -1);
  arrangement.drop_jump(2, 1);
  EXPECT_EQ(arrangement.paths()[2].jumps[1], 0);
}

TEST(Arrangement, ApartStrandsCrossAndFollowNothing) {
  const CurveNetwork network = two_squares_and_a_path();
  const Arrangement arrangement = arrange_apart(network, one_px);
  EXPECT_TRUE(arrangement.crossings().empty());
  EXPECT_EQ(arrangement.paths().size(), network.strands.size());
}

}  // namespace
}  // namespace illustrate
