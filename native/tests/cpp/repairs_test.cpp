#include "visibility/repairs.h"

#include <gtest/gtest.h>

#include "cameras.h"
#include "visibility/potential.h"

namespace illustrate {
namespace {

const Camera one_px = cameras::orthographic(Vec3(0, 0, 1), 500);  // a world unit is a pixel

// A square with a curl of less than half a pixel in its upper side, in front on its way in, cut
// into two strands at two cusps with these jumps.
CurveNetwork curled_square(int first_jump, int second_jump) {
  const Points points{{50, -50, 0},   {50, 50, 0},    {-.2, 50, 0},    {-.2, 50.3, -1},
                      {.1, 50.3, -1}, {.1, 49.8, -1}, {-50, 49.8, -1}, {-50, -50, -1}};
  CurveNetwork network;
  network.nodes = {{NodeKind::cusp, points.front()}, {NodeKind::cusp, points.back()}};
  for (const Vec3& p : points) network.points.push({p, {}});
  network.points.close_list();
  network.points.push({points.back(), {}});
  network.points.push({points.front(), {}});
  network.points.close_list();
  Strand strand;
  strand.left_layers = 2;
  for (const int start : {0, 1}) {
    strand.start_node = start;
    strand.end_node = 1 - start;
    network.strands.push_back(strand);
  }
  network.ties = {{1, 0, 1, first_jump}, {0, 1, 0, second_jump}};
  return network;
}

TEST(Twists, OfUnbalancedPathsAreDropped) {
  const CurveNetwork network = curled_square(0, 0);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(arrangement.crossings.size(), 1U);
  ASSERT_EQ(std::abs(imbalance(arrangement, arrangement.paths[0])), 2);
  double moved_px = 0;
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 1);
  EXPECT_EQ(imbalance(arrangement, arrangement.paths[0]), 0);
  EXPECT_NEAR(moved_px, std::hypot(.3, .3), 1e-3);
}

// Two cusps and a crossing that undo each other are the image of a fold, however small.
TEST(Twists, ThatBalanceAPathAreKept) {
  CurveNetwork network = curled_square(0, 0);
  const Arrangement bare = arrange(network, one_px);
  const int half = -imbalance(bare, bare.paths[0]) / 2;
  network = curled_square(half, half);
  Arrangement arrangement = arrange(network, one_px);
  ASSERT_EQ(imbalance(arrangement, arrangement.paths[0]), 0);
  double moved_px = 0;
  EXPECT_EQ(drop_twists_and_lenses(arrangement, moved_px), 0);
  EXPECT_EQ(drop_lenses(arrangement, {0}, moved_px), 0);
  EXPECT_TRUE(arrangement.is_live(0));
  EXPECT_EQ(moved_px, 0);
}

TEST(Imbalance, IsTheResidualOfTheLabels) {
  for (const int jump : {-1, 0, 1}) {
    const CurveNetwork network = curled_square(jump, 1);
    const Arrangement arrangement = arrange(network, one_px);
    const Path& path = arrangement.paths[0];
    EXPECT_EQ(imbalance(arrangement, path), relative_labels(arrangement, path).residual);
  }
}

}  // namespace
}  // namespace illustrate
