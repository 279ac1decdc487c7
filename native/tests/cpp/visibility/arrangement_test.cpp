#include "visibility/arrangement/arrangement.h"

#include <gtest/gtest.h>

#include "tests/cpp/cameras.h"
#include "tests/cpp/shapes.h"

namespace illustrate {
namespace {

using cameras::one_px;

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

// A line passes over the borders of two sheets that adjoin at x = 0: once all is moved inward the
// sheets overlap there, or are apart.
TEST(Arrangement, VisitsOfBordersAtOnePlaceComeInTheOrderThatWasDecided) {
  CurveNetwork network;
  const auto add = [&](const Points& points) {
    for (const Vec3& p : points) network.points.push({p, {}});
    network.points.close_list();
    network.strands.push_back({Kind::boundary, 0, none, none, 1, 0});
  };
  const auto sheet = [&](double from, double to) {
    add({{from, -20, -1}, {to, -20, -1}, {to, 20, -1}, {from, 20, -1}});
  };
  add({{-50, 0, 0}, {50, 0, 0}, {50, 30, 0}, {-50, 30, 0}});
  sheet(-40, 0);
  sheet(0, 40);
  for (const double overlap : {3e-4, -3e-4}) {
    Points decided;
    for (const CurvePoint& p : network.points.values) decided.push_back(p.position);
    for (const std::size_t i : {5, 6}) decided[i].x() = overlap;
    for (const std::size_t i : {8, 11}) decided[i].x() = -overlap;
    const Arrangement arrangement = *arrange(network, one_px, 100, decided);
    std::vector<int> sheets;
    double before = 0;
    for (const Visit& visit : arrangement.visits(0)) {
      sheets.push_back(arrangement.crossing(visit.crossing).back.strand);
      EXPECT_GE(visit.place.segment + visit.place.fraction, before);
      before = visit.place.segment + visit.place.fraction;
    }
    EXPECT_EQ(sheets,
              overlap > 0 ? std::vector<int>({1, 2, 1, 2}) : std::vector<int>({1, 1, 2, 2}));
  }
}

// Places on needles have shares of their corners far beyond them. One such place that was moved by
// as much would have all curves of a view touch each other.
TEST(InsetPoints, MoveNoFartherThanTheSurface) {
  const Surface surface =
      shapes::plain_surface(shapes::polygon_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  const Points insets{{0, 0, 1e-6}, {0, 0, 2e-6}, {0, 0, 3e-6}};
  CurveNetwork network;
  for (const auto& [b1, b2] : {std::array{0., 0.}, {0.25, 0.5}, {1e12, -1e12}, {-3., 2.}})
    network.points.push({Vec3(1, 2, 3), {0, b1, b2}});
  network.points.close_list();
  Strand strand;
  strand.start_node = strand.end_node = none;
  network.strands.push_back(strand);
  const Points moved = inset_points(network, surface, insets);
  const double expected[] = {1e-6, 2.25e-6, 1.5e-6, 2e-6};
  for (std::size_t i = 0; i < moved.size(); ++i)
    EXPECT_NEAR((moved[i] - Vec3(1, 2, 3)).z(), expected[i], 1e-15) << i;
}

}  // namespace
}  // namespace illustrate
